/* Where a particle began, as a colour field: START_ALONG(x, 0) makes color_start_x. */
#ifndef RENDER_COLORS_START_ALONG_H
#define RENDER_COLORS_START_ALONG_H

#include "render/color.h"

#include <math.h>

/* From the lowest particle to the highest; all may be at one place, or there may be none. */
static void start_range(const struct fill *start, int axis, double out[2])
{
    out[0] = start->count ? INFINITY : 0;
    out[1] = start->count ? -INFINITY : 1;
    for (size_t i = 0; i < start->count; i++) {
        out[0] = fmin(out[0], start->point[i][axis]);
        out[1] = fmax(out[1], start->point[i][axis]);
    }
    out[1] = out[1] > out[0] ? out[1] : out[0] + 1;
}

#define START_ALONG(axis, number)                                                                  \
    static float fixed(const struct fill *start, size_t id)                                        \
    {                                                                                              \
        return (float)start->point[id][number];                                                    \
    }                                                                                              \
    static void range(const struct color_expectation *expect, double out[2])                       \
    {                                                                                              \
        start_range(expect->start, number, out);                                                   \
    }                                                                                              \
    const struct color_row color_start_##axis = {                                                  \
        .variant = {.name = "start." #axis, .doc = #axis " of the particle at the start, m: mixing"}, \
        .label = "initial " #axis,                                                                 \
        .unit = "m",                                                                               \
        .reads = FIELD_BIT(FIELD_ID),                                                              \
        .fixed = fixed,                                                                            \
        .range = range,                                                                            \
        .estimate = "of the bodies",                                                               \
    }

#endif
