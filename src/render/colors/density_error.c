/* Colour by the error of density. */
#include "render/color.h"

static void range(const struct color_expectation *expect, double out[2])
{
    (void)expect;
    out[0] = -0.01;
    out[1] = 0.01;
}

const struct color_row color_density_error = {
    .variant = {.name = "density-error", .doc = "density over rest density, less 1"},
    .label = "\u03c1/\u03c1\u2080 \u2212 1",
    .unit = "",
    .reads = FIELD_BIT(FIELD_DENSITY),
    .has_sign = true,
    .value = VALUE_density_error,
    .range = range,
    .estimate = "1 % about the rest density",
};
