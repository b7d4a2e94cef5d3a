/* Colour by speed. */
#include "render/color.h"

#include <math.h>

static float value(const struct color_source *source, size_t i)
{
    const float *v = particles_motion(source->particles)[i].velocity;
    return sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

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
    .value = value,
    .range = range,
    .estimate = "speed of a fall from the highest body to the lowest floor",
};
