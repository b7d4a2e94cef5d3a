/* Wendland C2 kernel: no pairing at any neighbour count (Dehnen & Aly 2012). */
#include "solver/kernel.h"

#include <math.h>

static double value(double q)
{
    double t = 1 - q / 2;
    return t * t * t * t * (1 + 2 * q);
}

static double slope(double q)
{
    return -5 * (1 - q / 2) * (1 - q / 2) * (1 - q / 2);
}

const struct kernel_row kernel_wendland_c2 = {
    .variant = {.name = "wendland-c2", .doc = "Wendland 1995 C2, stable against pairing"},
    .support = 2.6,
    .sigma = 21 / (16 * 3.14159265358979323846),
    .value = value,
    .slope = slope,
    .flag = 0,
};
