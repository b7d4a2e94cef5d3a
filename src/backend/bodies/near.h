/* The distance by which neighbour rows choose. In the common subset of C and CUDA. */
#ifndef BACKEND_BODIES_NEAR_H
#define BACKEND_BODIES_NEAR_H

#include <math.h>
#include <stdint.h>

/* Square of the distance of two fixed-point places, in smoothing lengths; the same from either side. */
static inline float near_q2(const uint32_t a[3], const uint32_t b[3], const float scale[3])
{
    float x = (float)(int32_t)(a[0] - b[0]) * scale[0];
    float y = (float)(int32_t)(a[1] - b[1]) * scale[1];
    float z = (float)(int32_t)(a[2] - b[2]) * scale[2];
    return fmaf(z, z, fmaf(y, y, x * x));
}

#endif
