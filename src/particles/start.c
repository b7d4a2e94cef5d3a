/* Turns start points into particles. */
#include "particles/start.h"

#include "particles/flows.h"
#include "particles/hydrostatic.h"

#include <math.h>

void start_count(const struct scene *scene, const struct fill *fill, double *fluid_volume,
                 size_t *fluid_particles)
{
    for (size_t f = 0; f < scene->fluid_count; f++) {
        fluid_volume[f] = 0;
        fluid_particles[f] = 0;
    }
    const struct scene_body *body = NULL;
    double cell = 0;
    for (size_t i = 0; i < fill->count; i++) {
        if (body != &scene->bodies[fill->body[i]]) {
            body = &scene->bodies[fill->body[i]];
            cell = fill_cell_volume(scene, body);
        }
        fluid_volume[body->fluid] += cell;
        fluid_particles[body->fluid]++;
    }
}

static void place(const struct space *space, const struct fill *fill, struct particles *p)
{
    for (size_t i = 0; i < fill->count; i++) {
        struct position *x = &particles_position(p)[i];
        for (int a = 0; a < 3; a++)
            x->count[a] = space_count(space, a, fill->point[i][a]);
        x->volume = 1;
        particles_id(p)[i] = (uint32_t)i;
    }
}

/* Pressure of a round body about which nothing stands: by surface tension, 2 sigma/R of a sphere and
 * sigma/R of a cylinder, and by a central force about its middle, rho Omega^2 (R^2 - r^2)/2. */
static double round_pressure(const struct scene *scene, const struct space *space,
                             const struct scene_body *body, const double x[3])
{
    const struct scene_fluid *fluid = &scene->fluids[body->fluid];
    double omega = scene->central_force.frequency, left = body->shape.radius * body->shape.radius;
    bool sphere = body->shape.kind == SHAPE_SPHERE, centred = true;
    if (body->shape.kind == SHAPE_BOX)
        return 0;
    for (int a = 0; a < 3; a++) {
        bool across = sphere || a != body->shape.axis;
        centred = centred && (across ? body->shape.center[a] == scene->central_force.center[a] &&
                                           !space->periodic[a]
                                     : space->periodic[a]);
        left -= across ? (x[a] - body->shape.center[a]) * (x[a] - body->shape.center[a]) : 0;
    }
    double pressure = (sphere ? 2 : 1) * fluid->surface_tension / body->shape.radius;
    return pressure + (centred ? fluid->density * omega * omega * fmax(left, 0) / 2 : 0);
}

/* Velocity and pressure of the particle at fill point i. */
static struct motion motion_at(const struct scene *scene, const struct space *space,
                               const struct hydrostatic *hydrostatic, const struct fill *fill,
                               size_t i)
{
    const struct scene_body *body = &scene->bodies[fill->body[i]];
    double v[3], pressure = 0;
    flow_velocity(body, fill->point[i], v);
    if (body->start != START_REST)
        pressure = hydrostatic_pressure(hydrostatic, (size_t)fill->body[i], fill->point[i]) +
                   flow_pressure(body, scene->fluids[body->fluid].density, fill->point[i]) +
                   round_pressure(scene, space, body, fill->point[i]);
    return (struct motion){{(float)v[0], (float)v[1], (float)v[2]}, (float)pressure};
}

enum status start_bodies(const struct scene *scene, const struct space *space,
                         const struct fill *fill, unsigned fields, struct particles *particles,
                         struct error *e)
{
    struct hydrostatic hydrostatic;
    if (hydrostatic_create(&hydrostatic, scene, e))
        return e->status;
    if (particles_create(particles, fill->count, fields, e)) {
        hydrostatic_free(&hydrostatic);
        return e->status;
    }
    place(space, fill, particles);
    for (size_t i = 0; i < fill->count; i++) {
        const struct scene_body *body = &scene->bodies[fill->body[i]];
        const struct scene_fluid *fluid = &scene->fluids[body->fluid];
        particles_motion(particles)[i] = motion_at(scene, space, &hydrostatic, fill, i);
        particles_density(particles)[i] = (float)fluid->density;
        if (particles->now[FIELD_FLUID])
            ((uint8_t *)particles->now[FIELD_FLUID])[i] = (uint8_t)body->fluid;
        if (particles->now[FIELD_VISCOSITY])
            ((float *)particles->now[FIELD_VISCOSITY])[i] = (float)fluid->viscosity;
    }
    hydrostatic_free(&hydrostatic);
    return STATUS_OK;
}

enum status start_walls(const struct space *space, const struct fill *fill,
                        struct particles *particles, struct error *e)
{
    if (particles_create(particles, fill->count, FIELD_BIT(FIELD_POSITION) | FIELD_BIT(FIELD_ID),
                         e))
        return e->status;
    place(space, fill, particles);
    return STATUS_OK;
}
