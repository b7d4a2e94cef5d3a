/* Colour by density. */
#include "render/color.h"

static void range(const struct color_expectation *expect, double out[2])
{
    out[0] = 0.98 * expect->density;
    out[1] = 1.02 * expect->density;
}

const struct color_row color_density = {
    .variant = {.name = "density", .doc = "density, kg/m^3"},
    .label = "density",
    .unit = "kg/m\302\263",
    .reads = FIELD_BIT(FIELD_DENSITY),
    .value = VALUE_density,
    .range = range,
    .estimate = "2 % about the largest rest density",
};
