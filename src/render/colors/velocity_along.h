/* A component of velocity as a colour field: VELOCITY_ALONG(x) makes color_velocity_x. */
#ifndef RENDER_COLORS_VELOCITY_ALONG_H
#define RENDER_COLORS_VELOCITY_ALONG_H

#include "render/color.h"

static void range(const struct color_expectation *expect, double out[2])
{
    out[1] = expect->fastest > 0 ? expect->fastest : 1;
    out[0] = -out[1];
}

#define VELOCITY_ALONG(axis)                                                                       \
    const struct color_row color_velocity_##axis = {                                               \
        .variant = {.name = "velocity." #axis, .doc = "velocity along " #axis ", m/s"},            \
        .label = #axis "-velocity",                                                                  \
        .unit = "m/s",                                                                             \
        .reads = FIELD_BIT(FIELD_MOTION),                                                          \
        .has_sign = true,                                                                          \
        .value = VALUE_velocity_##axis,                                                            \
        .range = range,                                                                            \
        .estimate = "speed of a fall from the highest body to the lowest floor",                   \
    }

#endif
