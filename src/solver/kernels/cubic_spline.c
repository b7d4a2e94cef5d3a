/* Cubic spline kernel (Monaghan & Lattanzio 1985). */
#include "solver/kernel.h"

static double value(double q)
{
    return q < 1 ? 1 - 1.5 * q * q + 0.75 * q * q * q : 0.25 * (2 - q) * (2 - q) * (2 - q);
}

static double slope(double q)
{
    return q < 1 ? -3 + 2.25 * q : -0.75 * (2 - q) * (2 - q) / q;
}

const struct kernel_row kernel_cubic_spline = {
    .variant = {.name = "cubic-spline", .doc = "Monaghan & Lattanzio 1985 cubic spline"},
    .support = 2.4,
    .sigma = 1 / 3.14159265358979323846,
    .value = value,
    .slope = slope,
    .flag = 1,
};
