/* How values spread over a colour map: linear or logarithmic, continuous or in steps. In the common subset of C
 * and CUDA. */
#ifndef RENDER_SCALE_H
#define RENDER_SCALE_H

#include "base/log_by_series.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

enum { MAP_SIZE = 256 }; /* colours of a map */

/* A log scale whose range does not say where it begins does so at this part of its end. */
#define DECADES_MIN 1e-3

struct color_scale {
    double range[2]; /* values at the ends of the map; above 0 when log */
    int steps;       /* equal parts, a colour each; 0: continuous */
    bool log;
    bool counts;     /* whole numbers: each in the middle of its step */
};

/* Place between the ends, 0..1, before steps; below 0 and above 1 outside. NAN where a log scale has
 * no place. */
static inline double scale_part(const struct color_scale *scale, double value)
{
    double low = scale->range[0], high = scale->range[1];
    if (!(high > low))
        return value > low;
    if (scale->log)
        return value > 0 ? log_by_series(value / low) / log_by_series(high / low) : (double)NAN;
    return (value - low) / (high - low);
}

/* Place in a linear map without steps. */
static inline float scale_place_linear(double low, double high, float value)
{
    double part = ((double)value - low) / (high - low);
    return (float)(part >= 1 ? 1 : part > 0 ? part : 0);
}

/* Place in the map, 0..1: of step k of n, k / (n - 1). What is not a number counts as low. */
static inline float scale_place(const struct color_scale *scale, float value)
{
    if (!scale->log && scale->steps < 2 && scale->range[1] > scale->range[0])
        return scale_place_linear(scale->range[0], scale->range[1], value);
    double part = scale_part(scale, (double)value);
    part = part >= 1 ? 1 : part > 0 ? part : 0;
    if (scale->steps < 2)
        return (float)part;
    double step = floor(part * scale->steps), last = scale->steps - 1;
    return (float)((step < last ? step : last) / last);
}

/* The colour of a place, red in the lowest byte: between the two nearest of the map, whose first and last are
 * the ends of the range. */
static inline uint32_t scale_color(const uint32_t *map, float place)
{
    double t = place * (double)(MAP_SIZE - 1);
    int low = t < MAP_SIZE - 2 ? (int)t : MAP_SIZE - 2;
    uint32_t own = map[low], next = map[low + 1], sum = 0;
    for (int k = 0; k < 24; k += 8) {
        int a = (int)(own >> k & 255), b = (int)(next >> k & 255);
        sum |= (uint32_t)(int)(a + (t - low) * (b - a) + 0.5) << k;
    }
    return sum;
}

/* The value at a place. */
double scale_value(const struct color_scale *scale, double part);

#endif
