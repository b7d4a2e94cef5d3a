/* Chooses the constants of surface tension. */
#include "scene/load.h"
#include "solver/solver.h"

#include <math.h>
#include <stdlib.h>

static double env(const char *n, double d) { return getenv(n) ? atof(getenv(n)) : d; }

/* The pressure that tension makes in the smallest body, over its density: the square of a speed. */
static double capillary_speed2(const struct scene *scene, double spacing)
{
    double most = 0;
    for (size_t b = 0; b < scene->body_count; b++) {
        const struct scene_fluid *fluid = &scene->fluids[scene->bodies[b].fluid];
        double min[3], max[3], radius = INFINITY;
        body_bounds(&scene->bodies[b], min, max);
        for (int a = 0; a < 3; a++)
            if (scene->domain.walls[2 * a] != WALL_PERIODIC)
                radius = fmin(radius, (max[a] - min[a]) / 2);
        radius = fmax(radius, 2 * spacing);
        most = fmax(most, 2 * fluid->surface_tension / (fluid->density * radius));
    }
    return most;
}

void tension_choose(const struct scene *scene, struct solver_choice *choice)
{
    const double pi = 3.14159265358979323846;
    struct tension_constants *t = &choice->tension;
    double d = choice->spacing, h = choice->smoothing_length;
    choice->limits.capillary = INFINITY;
    for (size_t f = 0; f < scene->fluid_count; f++) {
        double sigma = scene->fluids[f].surface_tension, rho = scene->fluids[f].density;
        t->any = t->any || sigma > 0;
        t->ripple[f] = (float)(env("BETA", 0.3) * sqrt(rho * sigma * h) * choice->pair.gradient / h);
        t->strength[f] = (float)(2 * sigma / (h * h));
        if (sigma > 0)
            choice->limits.capillary = fmin(choice->limits.capillary,
                                            0.25 * sqrt(rho * h * h * h / (2 * pi * sigma)));
    }
    if (!t->any)
        return;
    double low = env("LOW", 0.2), high = env("HIGH", 0.4);
    t->gradient = (float)(choice->pair.gradient * h);
    t->low = (float)(low * low);
    t->scale = (float)(1 / (high * high - low * low));
    t->most = (float)env("MOST", 1);
    t->depth = (float)(env("DEPTH", 0.75) * 0.5 * d / h);
    choice->fastest = sqrt(choice->fastest * choice->fastest + capillary_speed2(scene, d));
}
