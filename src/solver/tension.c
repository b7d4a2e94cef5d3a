/* Chooses the constants of surface tension: the energy of a plane surface on the lattice. */
#include "scene/load.h"
#include "solver/solver.h"

#include <math.h>
#include <stdlib.h>

/* h s: a gradient that passes for disorder; at a plane surface h grad c is 0.75. */
static double floor_ = 0.1;

static double slope(double q)
{
    return q < 2 ? kernel_wendland_c2.slope(q) : 0;
}

/* sums over layers up to `layer` of z slope, x^2 slope */
static void layer_sums(double h, int layer, double *gradient, double *moment)
{
    int reach = (int)ceil(2 * h);
    *gradient = *moment = 0;
    for (int z = -reach; z <= layer && z <= reach; z++)
        for (int y = -reach; y <= reach; y++)
            for (int x = -reach; x <= reach; x++) {
                double q = sqrt(x * x + y * y + z * z) / h;
                *gradient += z / h * slope(q);
                *moment -= x * x / (h * h) * slope(q);
            }
}

double tension_plane_energy(double support, double volume)
{
    double h = support / 2, sum = 0, inside, none;
    layer_sums(h, 100, &none, &inside);
    for (int layer = 0; layer < support; layer++) {
        double g, m;
        layer_sums(h, layer, &g, &m);
        g /= inside;
        m /= inside;
        double u=(g*g-floor_*floor_)/(3*floor_*floor_); sum += g * (u<0?0:u>1?1:u) / h;
    }
    return sum;
}

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
    struct tension_constants *t = &choice->tension; if (getenv("FLOOR")) floor_ = atof(getenv("FLOOR"));
    double d = choice->spacing, h = choice->smoothing_length;
    double volume = 1 / kernel_lattice_sum(choice->kernel, choice->support / d);
    double plane = tension_plane_energy(choice->support / d, volume);
    choice->limits.capillary = INFINITY;
    for (size_t f = 0; f < scene->fluid_count; f++) {
        double sigma = scene->fluids[f].surface_tension, rho = scene->fluids[f].density;
        t->any = t->any || sigma > 0;
        t->strength[f] = (float)(sigma / plane / (h * h * rho));
        if (sigma > 0)
            choice->limits.capillary = fmin(choice->limits.capillary,
                                            0.25 * sqrt(rho * h * h * h / (2 * pi * sigma)));
    }
    if (!t->any)
        return;
    double none, inside;
    layer_sums(h / d, 100, &none, &inside);
    t->gradient = (float)(1 / (volume * inside));
    t->most = getenv("MOST") ? atof(getenv("MOST")) : 2;
    t->floor = (float)floor_;
    t->floor2 = (float)(floor_ * floor_);
    kernel_plane_table(&kernel_wendland_c2, choice->support / d, &t->planes);
    choice->fastest = sqrt(choice->fastest * choice->fastest + capillary_speed2(scene, d));
}
