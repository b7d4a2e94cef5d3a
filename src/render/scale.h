/* How values spread over a colour map: linear or logarithmic, continuous or in steps. */
#ifndef RENDER_SCALE_H
#define RENDER_SCALE_H

#include <stdbool.h>

struct color_scale {
    double range[2]; /* values at the ends of the map; above 0 when log */
    int steps;       /* equal parts, a colour each; 0: continuous */
    bool log;
    bool counts;     /* whole numbers: each in the middle of its step */
};

/* Place between the ends, 0..1, before steps; below 0 and above 1 outside. NAN where a log scale has
 * no place. */
double scale_part(const struct color_scale *scale, double value);

/* The value at that place. */
double scale_value(const struct color_scale *scale, double part);

/* Place in a linear map without steps. */
static inline float scale_place_linear(double low, double high, float value)
{
    double part = ((double)value - low) / (high - low);
    return (float)(part >= 1 ? 1 : part > 0 ? part : 0);
}

/* Place in the map, 0..1: of step k of n, k / (n - 1). What is not a number counts as low. */
float scale_place(const struct color_scale *scale, float value);

#endif
