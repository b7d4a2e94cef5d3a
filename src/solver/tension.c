/* Chooses the constants of surface tension. */
#include "solver/solver.h"

#include <math.h>

/* h |grad c| between which disorder becomes a surface; at a plane surface of the lattice it is 0.5 to
 * 0.65 in the first layer and below 0.11 in the second, for supports of 2 to 3 spacings. */
static const double low = 0.12, high = 0.24;

/* -sum z W'/r and -sum x^2 W'/r of the lattice up to `layer`, z counting outwards in spacings. */
static void layer_sums(double h, int layer, double *gradient, double *moment)
{
    int reach = (int)ceil(2 * h);
    *gradient = *moment = 0;
    for (int z = -reach; z <= layer && z <= reach; z++)
        for (int y = -reach; y <= reach; y++)
            for (int x = -reach; x <= reach; x++) {
                double q = sqrt(x * x + y * y + z * z) / h;
                double slope = q < 2 ? kernel_wendland_c2.slope(q) : 0;
                *gradient += z / h * slope;
                *moment -= x * x / (h * h) * slope;
            }
}

double tension_plane(double support)
{
    double h = support / 2, sum = 0, none, whole;
    layer_sums(h, (int)ceil(support), &none, &whole);
    for (int layer = 0; layer < support; layer++) {
        double g, part;
        layer_sums(h, layer, &g, &none);
        g /= whole;
        part = (g * g - low * low) / (high * high - low * low);
        sum += g * fmin(fmax(part, 0), 1) / h;
    }
    return sum;
}

void tension_choose(const struct scene *scene, struct solver_choice *choice)
{
    const double pi = 3.14159265358979323846;
    struct tension_constants *t = &choice->tension;
    double d = choice->spacing, h = choice->smoothing_length, none, whole;
    double plane = tension_plane(choice->support / d), speed2 = 0;
    choice->limits.capillary = INFINITY;
    for (size_t f = 0; f < scene->fluid_count; f++) {
        double sigma = scene->fluids[f].surface_tension, rho = scene->fluids[f].density;
        t->any = t->any || sigma > 0;
        /* Ripples two spacings long, which outrun all others: omega^2 = sigma k^3/rho. */
        speed2 = fmax(speed2, pi * sigma / (rho * d));
        t->strength[f] = (float)(sigma / (plane * h * h * rho));
        t->pressure[f] = (float)(sigma / h);
        if (sigma > 0)
            choice->limits.capillary = fmin(choice->limits.capillary,
                                            0.25 * sqrt(rho * h * h * h / (2 * pi * sigma)));
        choice->ripple = fmax(choice->ripple, 3 * sqrt(rho * sigma / h));
    }
    if (!t->any)
        return;
    layer_sums(h / d, (int)ceil(2 * h / d), &none, &whole);
    t->gradient = (float)(kernel_lattice_sum(choice->kernel, choice->support / d) / whole);
    t->low2 = (float)(low * low);
    t->scale = (float)(1 / (high * high - low * low));
    t->most = 1;
    t->inset = (float)(d / (4 * h));
    t->between = scene->fluid_count > 1;
    kernel_plane_table(&kernel_wendland_c2, choice->support / d, &t->planes);
    choice->fastest = sqrt(choice->fastest * choice->fastest + speed2);
}
