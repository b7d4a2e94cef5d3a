/* Colour spaces of FLIP: sRGB to opponent colours, and those to Hunt-adjusted CIELAB. */
#ifndef COMPARE_FLIP_COLOR_H
#define COMPARE_FLIP_COLOR_H

#include "base/image.h"

#include <math.h>
#include <stddef.h>

/* Planes Y (lightness of a linear scale, -16 to 100), Cx (red-green), Cz (blue-yellow); over black. */
void flip_opponent(float *const out[3], const struct image *image);

/* Y, Cx, Cz become L*, a* and b*, the latter two times 0.01 L* (Hunt), in place. */
void flip_lab(float *const planes[3], size_t count);

/* HyAB: lightness by absolute value, chroma by Euclid (Abasi et al. 2019). */
static inline float flip_distance(const float a[3], const float b[3])
{
    float u = a[1] - b[1], v = a[2] - b[2];
    return fabsf(a[0] - b[0]) + sqrtf(u * u + v * v);
}

/* The largest distance of sRGB colours, green to blue (FLIP, section 4.1). */
float flip_largest_distance(void);

#endif
