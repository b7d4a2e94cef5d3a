/* One lane: plain C floats, the reference for the vector versions. */
#ifndef BACKEND_CPU_LANES_SCALAR_H
#define BACKEND_CPU_LANES_SCALAR_H

#include "backend/bodies/near.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

enum { LANES = 1 };
typedef float real;

static inline __attribute__((always_inline)) real real_set(float x)
{
    return x;
}
static inline __attribute__((always_inline)) real real_load(const float *p)
{
    return *p;
}
static inline __attribute__((always_inline)) void real_store(float *p, real x)
{
    *p = x;
}
static inline __attribute__((always_inline)) real real_fma(real a, real b, real c)
{
    return fmaf(a, b, c);
}
/* max(x, 0); also +0 for -0 and NaN, like the vector instruction. */
static inline __attribute__((always_inline)) real real_positive(real x)
{
    return x > 0 ? x : 0;
}
/* First guess of 1/sqrt(x) from the bits of x, error 3.4 % (real_rsqrt in pair_loops.h). */
static inline __attribute__((always_inline)) real real_rsqrt_guess(real x)
{
    uint32_t bits;
    memcpy(&bits, &x, 4);
    bits = 0x5f375a86u - (bits >> 1);
    memcpy(&x, &bits, 4);
    return x;
}
/* Signed difference of fixed-point coordinates, as float. */
static inline __attribute__((always_inline)) real real_difference(real a, real b)
{
    uint32_t x, y;
    memcpy(&x, &a, 4);
    memcpy(&y, &b, 4);
    return (float)(int32_t)(x - y);
}
/* x in lanes where k < count, otherwise y. */
static inline __attribute__((always_inline)) real real_below(uint32_t k, const uint32_t *count, real x, real y)
{
    return k < *count ? x : y;
}
/* The four words of the records at LANES row entries. */
static inline __attribute__((always_inline)) void records_load(const void *records, const uint32_t *index, real out[4])
{
    memcpy(out, (const char *)records + 8 * (size_t)*index, 16);
}
static inline __attribute__((always_inline)) real lookup_load(const float *values, const uint32_t *index)
{
    return values[*index / 2];
}

/* Appends to `out` the row entries of the candidates first..last-1 within sqrt(limit[0]) of `point`,
 * leaving out `self`; coordinates are by axis; returns the new length. Sets *coincident when one is
 * within sqrt(limit[1]). */
static inline __attribute__((always_inline)) uint32_t *rows_append(uint32_t *out, const uint32_t *const axis[3],
                                    const uint32_t point[3], const float scale[3],
                                    const float limit[2], uint32_t first, uint32_t last,
                                    uint32_t self, bool *coincident)
{
    for (uint32_t j = first; j < last; j++) {
        const uint32_t other[3] = {axis[0][j], axis[1][j], axis[2][j]};
        float q2 = near_q2(point, other, scale);
        *out = 2 * j;
        out += q2 < limit[0] && j != self;
        *coincident |= q2 < limit[1] && j != self;
    }
    return out;
}

/* out[16 k + l] = list[l room + k] for k, l below 4. */
static inline __attribute__((always_inline)) void rows_transpose(const uint32_t *list, size_t room,
                                                                 uint32_t *out)
{
    for (size_t k = 0; k < 4; k++)
        for (size_t l = 0; l < 4; l++)
            out[16 * k + l] = list[l * room + k];
}

#endif
