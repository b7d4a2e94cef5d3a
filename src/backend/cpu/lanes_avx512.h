/* Sixteen lanes: AVX-512. */
#ifndef BACKEND_CPU_LANES_AVX512_H
#define BACKEND_CPU_LANES_AVX512_H

#include "backend/cpu/rows_x86.h"

#include <immintrin.h>
#include <stdbool.h>
#include <stdint.h>

enum { LANES = 16 };
typedef __m512 real;

static inline __attribute__((always_inline)) real real_set(float x)
{
    return _mm512_set1_ps(x);
}
static inline __attribute__((always_inline)) real real_load(const float *p)
{
    return _mm512_loadu_ps(p);
}
static inline __attribute__((always_inline)) void real_store(float *p, real x)
{
    _mm512_storeu_ps(p, x);
}
static inline __attribute__((always_inline)) real real_fma(real a, real b, real c)
{
    return _mm512_fmadd_ps(a, b, c);
}
static inline __attribute__((always_inline)) real real_positive(real x)
{
    return _mm512_max_ps(x, _mm512_setzero_ps());
}
static inline __attribute__((always_inline)) real real_rsqrt_guess(real x)
{
    __m512i half = _mm512_srli_epi32(_mm512_castps_si512(x), 1);
    return _mm512_castsi512_ps(_mm512_sub_epi32(_mm512_set1_epi32(0x5f375a86), half));
}
static inline __attribute__((always_inline)) real real_difference(real a, real b)
{
    return _mm512_cvtepi32_ps(
        _mm512_sub_epi32(_mm512_castps_si512(a), _mm512_castps_si512(b)));
}
static inline __attribute__((always_inline)) real real_below(uint32_t k, const uint32_t *count, real x, real y)
{
    __mmask16 below =
        _mm512_cmpgt_epu32_mask(_mm512_loadu_si512(count), _mm512_set1_epi32((int)k));
    return _mm512_mask_blend_ps(below, y, x);
}

static inline __attribute__((always_inline)) __m512 records_row(const float *r, const uint32_t *index)
{
    __m512 row = _mm512_castps128_ps512(_mm_load_ps(r + 2 * (size_t)index[0]));
    row = _mm512_insertf32x4(row, _mm_load_ps(r + 2 * (size_t)index[4]), 1);
    row = _mm512_insertf32x4(row, _mm_load_ps(r + 2 * (size_t)index[8]), 2);
    return _mm512_insertf32x4(row, _mm_load_ps(r + 2 * (size_t)index[12]), 3);
}
static inline __attribute__((always_inline)) void records_load(const void *records, const uint32_t *index, real out[4])
{
    const float *r = records;
    __m512 r0 = records_row(r, index), r1 = records_row(r, index + 1);
    __m512 r2 = records_row(r, index + 2), r3 = records_row(r, index + 3);
    __m512 a = _mm512_unpacklo_ps(r0, r1), b = _mm512_unpackhi_ps(r0, r1);
    __m512 c = _mm512_unpacklo_ps(r2, r3), d = _mm512_unpackhi_ps(r2, r3);
    out[0] = _mm512_shuffle_ps(a, c, 0x44);
    out[1] = _mm512_shuffle_ps(a, c, 0xee);
    out[2] = _mm512_shuffle_ps(b, d, 0x44);
    out[3] = _mm512_shuffle_ps(b, d, 0xee);
}
/* Loads and inserts: twice as fast as the gather instruction of AMD's processors. */
static inline __attribute__((always_inline)) __m128 lookup_four(const float *values, const uint32_t *index)
{
    const char *v = (const char *)values;
    __m128 four = _mm_load_ss((const float *)(v + 2 * (size_t)index[0]));
    four = _mm_insert_ps(four, _mm_load_ss((const float *)(v + 2 * (size_t)index[1])), 0x10);
    four = _mm_insert_ps(four, _mm_load_ss((const float *)(v + 2 * (size_t)index[2])), 0x20);
    return _mm_insert_ps(four, _mm_load_ss((const float *)(v + 2 * (size_t)index[3])), 0x30);
}
static inline __attribute__((always_inline)) real lookup_load(const float *values, const uint32_t *index)
{
    __m512 out = _mm512_castps128_ps512(lookup_four(values, index));
    out = _mm512_insertf32x4(out, lookup_four(values, index + 4), 1);
    out = _mm512_insertf32x4(out, lookup_four(values, index + 8), 2);
    return _mm512_insertf32x4(out, lookup_four(values, index + 12), 3);
}

static inline __attribute__((always_inline)) uint32_t *rows_append(uint32_t *out, const uint32_t *const axis[3],
                                    const uint32_t point[3], const float scale[3],
                                    const float limit[2], uint32_t first, uint32_t last,
                                    uint32_t self, bool *coincident)
{
    __m512i step =
        _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    __m512i px = _mm512_set1_epi32((int)point[0]), py = _mm512_set1_epi32((int)point[1]);
    __m512i pz = _mm512_set1_epi32((int)point[2]), end = _mm512_set1_epi32((int)last);
    __m512i own = _mm512_set1_epi32((int)self);
    __m512 sx = _mm512_set1_ps(scale[0]), sy = _mm512_set1_ps(scale[1]);
    __m512 sz = _mm512_set1_ps(scale[2]), most = _mm512_set1_ps(limit[0]);
    __m512 least = _mm512_set1_ps(limit[1]);
    __mmask16 shared = 0;
    for (uint32_t j = first; j < last; j += LANES) {
        __m512i index = _mm512_add_epi32(_mm512_set1_epi32((int)j), step);
        __m512 x = _mm512_mul_ps(
            sx, _mm512_cvtepi32_ps(_mm512_sub_epi32(px, _mm512_loadu_si512(axis[0] + j))));
        __m512 y = _mm512_mul_ps(
            sy, _mm512_cvtepi32_ps(_mm512_sub_epi32(py, _mm512_loadu_si512(axis[1] + j))));
        __m512 z = _mm512_mul_ps(
            sz, _mm512_cvtepi32_ps(_mm512_sub_epi32(pz, _mm512_loadu_si512(axis[2] + j))));
        __m512 q2 = _mm512_fmadd_ps(z, z, _mm512_fmadd_ps(y, y, _mm512_mul_ps(x, x)));
        __mmask16 near = _mm512_cmp_ps_mask(q2, most, _CMP_LT_OQ);
        near = _mm512_mask_cmplt_epu32_mask(near, index, end);
        near = _mm512_mask_cmpneq_epi32_mask(near, index, own);
        shared |= _mm512_mask_cmp_ps_mask(near, q2, least, _CMP_LT_OQ);
        _mm512_storeu_si512(out, _mm512_maskz_compress_epi32(near, _mm512_add_epi32(index, index)));
        out += __builtin_popcount(near);
    }
    *coincident |= shared != 0;
    return out;
}

#endif
