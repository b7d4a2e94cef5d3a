/* Colour by pressure. */
#include "render/color.h"

static void range(const struct color_expectation *expect, double out[2])
{
    out[0] = 0;
    out[1] = expect->density * expect->gravity * expect->depth;
    if (out[1] <= 0)
        out[1] = expect->density * expect->fastest * expect->fastest / 2;
    if (out[1] <= 0)
        out[1] = 1;
}

const struct color_row color_pressure = {
    .variant = {.name = "pressure", .doc = "pressure, Pa"},
    .label = "pressure",
    .unit = "Pa",
    .reads = FIELD_BIT(FIELD_MOTION),
    .value = VALUE_pressure,
    .range = range,
    .estimate = "hydrostatic pressure under the highest body",
};
