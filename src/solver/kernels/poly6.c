/* The kernels of Mueller et al. 2003: poly6 for density, spiky and viscosity for forces. */
#include "solver/kernel.h"

static double value(double q)
{
    double t = 1 - q * q / 4;
    return t * t * t;
}

/* Of the spiky kernel, over the sigma of poly6 (bodies.h). */
static double slope(double q)
{
    return -32.0 / 7 * (1 - q / 2) * (1 - q / 2) / q;
}

const struct kernel_row kernel_poly6 = {
    .variant = {.name = "poly6", .doc = "Mueller 2003: poly6, with spiky and viscosity for forces"},
    .support = 2.4,
    .sigma = 315 / (512 * 3.14159265358979323846),
    .value = value,
    .slope = slope,
    .flag = 0,
};
