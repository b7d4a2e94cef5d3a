/* Where a particle began, as a colour field: START_ALONG(x, 0) makes color_start_x. */
#ifndef RENDER_COLORS_START_ALONG_H
#define RENDER_COLORS_START_ALONG_H

#include "render/color.h"

#define START_ALONG(axis, number)                                                                  \
    static float value(const struct color_source *source, size_t i)                                \
    {                                                                                              \
        return (float)source->start->point[particles_id(source->particles)[i]][number];            \
    }                                                                                              \
    static void range(const struct color_expectation *expect, double out[2])                       \
    {                                                                                              \
        out[0] = expect->scene->domain.min[number];                                                \
        out[1] = expect->scene->domain.max[number];                                                \
    }                                                                                              \
    const struct color_row color_start_##axis = {                                                  \
        .variant = {.name = "start." #axis, .doc = #axis " of the particle at the start, m: mixing"}, \
        .label = "initial " #axis,                                                                 \
        .unit = "m",                                                                               \
        .reads = FIELD_BIT(FIELD_ID),                                                              \
        .value = value,                                                                            \
        .range = range,                                                                            \
        .estimate = "the domain",                                                                  \
    }

#endif
