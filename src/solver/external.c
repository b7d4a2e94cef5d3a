/* Chooses central force, buoyancy and dissipation from the scene. */
#include "solver/solver.h"

#include <math.h>

double external_mean_density(const struct scene *scene, const double *fluid_volume)
{
    double mass = 0, volume = 0;
    for (size_t f = 0; f < scene->fluid_count; f++) {
        mass += scene->fluids[f].density * fluid_volume[f];
        volume += fluid_volume[f];
    }
    return volume > 0 ? mass / volume : scene->fluids[0].density;
}

/* The speed that the central force gives to what falls from the rim of a body. */
static double central_speed(const struct scene *scene, const struct external_constants *c)
{
    double most = 0;
    for (size_t b = 0; b < scene->body_count; b++) {
        const struct scene_body *body = &scene->bodies[b];
        double min[3], max[3], corner = 0, middle = 0, round = 0;
        shape_bounds(&body->shape, min, max);
        for (int a = 0; a < 3; a++) {
            double from = scene->central_force.center[a], at = (min[a] + max[a]) / 2 - from;
            double far = fmax(fabs(min[a] - from), fabs(max[a] - from));
            corner += c->stiffness[a] * far * far;
            middle += c->stiffness[a] * at * at;
            round = fmax(round, c->stiffness[a] * body->shape.radius * body->shape.radius);
        }
        bool ball = body->shape.kind == SHAPE_SPHERE || (body->shape.kind == SHAPE_CYLINDER &&
                                                   c->stiffness[body->shape.axis] == 0);
        most = fmax(most, ball ? sqrt(middle) + sqrt(round) : sqrt(corner));
    }
    return most;
}

void external_choose(const struct scene *scene, const struct space *space,
                     const double *fluid_volume, struct solver_choice *choice)
{
    struct external_constants *c = &choice->external;
    double omega = scene->central_force.frequency, b = scene->buoyancy;
    double mean = external_mean_density(scene, fluid_volume);
    c->central = omega > 0;
    c->dissipation = (float)scene->dissipation;
    for (int a = 0; a < 3; a++) {
        c->stiffness[a] = space->periodic[a] ? 0 : omega * omega;
        c->centre[a] = scene->central_force.center[a] - space->origin[a];
        c->unit[a] = space->unit[a];
        for (size_t f = 0; f < scene->fluid_count; f++) {
            double lift = b * (scene->fluids[f].density - mean) / scene->fluids[f].density;
            c->lift[f][a] = (float)(lift * scene->gravity[a]);
        }
    }
    c->any = c->central || scene->dissipation > 0 || (b > 0 && scene->fluid_count > 1);
    if (c->central) {
        double speed = central_speed(scene, c);
        choice->fastest = sqrt(choice->fastest * choice->fastest + speed * speed);
        choice->pull = omega * speed;
    }
    choice->limits.damping = scene->dissipation > 0 ? 0.5 / scene->dissipation : INFINITY;
}
