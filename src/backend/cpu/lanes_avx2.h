/* Eight lanes: AVX2 with FMA. */
#ifndef BACKEND_CPU_LANES_AVX2_H
#define BACKEND_CPU_LANES_AVX2_H

#include "backend/cpu/rows_x86.h"

#include <immintrin.h>
#include <stdbool.h>
#include <stdint.h>

enum { LANES = 8 };
typedef __m256 real;

static inline __attribute__((always_inline)) real real_set(float x)
{
    return _mm256_set1_ps(x);
}
static inline __attribute__((always_inline)) real real_load(const float *p)
{
    return _mm256_loadu_ps(p);
}
static inline __attribute__((always_inline)) void real_store(float *p, real x)
{
    _mm256_storeu_ps(p, x);
}
static inline __attribute__((always_inline)) real real_fma(real a, real b, real c)
{
    return _mm256_fmadd_ps(a, b, c);
}
static inline __attribute__((always_inline)) real real_positive(real x)
{
    return _mm256_max_ps(x, _mm256_setzero_ps());
}
static inline __attribute__((always_inline)) real real_rsqrt_guess(real x)
{
    __m256i half = _mm256_srli_epi32(_mm256_castps_si256(x), 1);
    return _mm256_castsi256_ps(_mm256_sub_epi32(_mm256_set1_epi32(0x5f375a86), half));
}
static inline __attribute__((always_inline)) real real_difference(real a, real b)
{
    return _mm256_cvtepi32_ps(
        _mm256_sub_epi32(_mm256_castps_si256(a), _mm256_castps_si256(b)));
}
static inline __attribute__((always_inline)) real real_below(uint32_t k, const uint32_t *count, real x, real y)
{
    __m256i n = _mm256_loadu_si256((const __m256i *)count);
    __m256i below = _mm256_cmpgt_epi32(n, _mm256_set1_epi32((int)k));
    return _mm256_blendv_ps(y, x, _mm256_castsi256_ps(below));
}

static inline __attribute__((always_inline)) void records_load(const void *records, const uint32_t *index, real out[4])
{
    const float *r = records;
    __m256 row[4];
    for (int k = 0; k < 4; k++)
        row[k] = _mm256_insertf128_ps(
            _mm256_castps128_ps256(_mm_load_ps(r + 2 * (size_t)index[k])),
            _mm_load_ps(r + 2 * (size_t)index[k + 4]), 1);
    __m256 a = _mm256_unpacklo_ps(row[0], row[1]), b = _mm256_unpackhi_ps(row[0], row[1]);
    __m256 c = _mm256_unpacklo_ps(row[2], row[3]), d = _mm256_unpackhi_ps(row[2], row[3]);
    out[0] = _mm256_shuffle_ps(a, c, 0x44);
    out[1] = _mm256_shuffle_ps(a, c, 0xee);
    out[2] = _mm256_shuffle_ps(b, d, 0x44);
    out[3] = _mm256_shuffle_ps(b, d, 0xee);
}
static inline __attribute__((always_inline)) real lookup_load(const float *values, const uint32_t *index)
{
    return _mm256_i32gather_ps(values, _mm256_loadu_si256((const __m256i *)index), 2);
}

static inline __attribute__((always_inline)) uint32_t *rows_append(uint32_t *out, const uint32_t *const axis[3],
                                    const uint32_t point[3], const float scale[3],
                                    const float limit[2], uint32_t first, uint32_t last,
                                    uint32_t self, bool *coincident)
{
    unsigned shared = 0;
    for (uint32_t j = first; j < last; j += LANES) {
        __m256 q2 = _mm256_setzero_ps();
        for (int a = 0; a < 3; a++) {
            __m256i other = _mm256_loadu_si256((const __m256i *)(axis[a] + j));
            __m256i count = _mm256_sub_epi32(_mm256_set1_epi32((int)point[a]), other);
            __m256 x = _mm256_mul_ps(_mm256_cvtepi32_ps(count), _mm256_set1_ps(scale[a]));
            q2 = a ? _mm256_fmadd_ps(x, x, q2) : _mm256_mul_ps(x, x);
        }
        unsigned near = (unsigned)_mm256_movemask_ps(
            _mm256_cmp_ps(q2, _mm256_set1_ps(limit[0]), _CMP_LT_OQ));
        if (last - j < LANES)
            near &= (1u << (last - j)) - 1;
        if (self - j < LANES)
            near &= ~(1u << (self - j));
        shared |= near & (unsigned)_mm256_movemask_ps(
                             _mm256_cmp_ps(q2, _mm256_set1_ps(limit[1]), _CMP_LT_OQ));
        for (; near; near &= near - 1)
            *out++ = 2 * (j + (uint32_t)__builtin_ctz(near));
    }
    *coincident |= shared != 0;
    return out;
}

#endif
