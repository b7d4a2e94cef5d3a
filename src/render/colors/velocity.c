/* Colour by speed. */
#include "render/color.h"

static void range(const struct color_expectation *expect, double out[2])
{
    out[0] = 0;
    out[1] = expect->fastest > 0 ? expect->fastest : 1;
}

const struct color_row color_velocity = {
    .variant = {.name = "velocity", .doc = "magnitude of velocity, m/s"},
    .label = "speed",
    .unit = "m/s",
    .reads = FIELD_BIT(FIELD_MOTION),
    .value = VALUE_velocity,
    .range = range,
    .estimate = "speed of a fall from the highest body to the lowest floor",
};
