/* Turns start points into particles. */
#include "particles/start.h"

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

enum status start_bodies(const struct scene *scene, const struct space *space,
                         const struct fill *fill, unsigned fields, struct particles *particles,
                         struct error *e)
{
    if (particles_create(particles, fill->count, fields, e))
        return e->status;
    place(space, fill, particles);
    for (size_t i = 0; i < fill->count; i++) {
        const struct scene_body *body = &scene->bodies[fill->body[i]];
        const struct scene_fluid *fluid = &scene->fluids[body->fluid];
        for (int a = 0; a < 3; a++)
            particles_motion(particles)[i].velocity[a] = (float)body->velocity[a];
        particles_density(particles)[i] = (float)fluid->density;
        if (particles->now[FIELD_FLUID])
            ((uint8_t *)particles->now[FIELD_FLUID])[i] = (uint8_t)body->fluid;
        if (particles->now[FIELD_VISCOSITY])
            ((float *)particles->now[FIELD_VISCOSITY])[i] = (float)fluid->viscosity;
    }
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
