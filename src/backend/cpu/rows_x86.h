/* Interleaving of neighbour lists with 128-bit instructions, for all x86 versions. */
#ifndef BACKEND_CPU_ROWS_X86_H
#define BACKEND_CPU_ROWS_X86_H

#include <immintrin.h>
#include <stddef.h>
#include <stdint.h>

/* out[16 k + l] = list[l room + k] for k, l below 4. */
static inline __attribute__((always_inline)) void rows_transpose(const uint32_t *list, size_t room,
                                                                 uint32_t *out)
{
    __m128i a = _mm_loadu_si128((const __m128i *)list);
    __m128i b = _mm_loadu_si128((const __m128i *)(list + room));
    __m128i c = _mm_loadu_si128((const __m128i *)(list + 2 * room));
    __m128i d = _mm_loadu_si128((const __m128i *)(list + 3 * room));
    __m128i ab = _mm_unpacklo_epi32(a, b), cd = _mm_unpacklo_epi32(c, d);
    __m128i ef = _mm_unpackhi_epi32(a, b), gh = _mm_unpackhi_epi32(c, d);
    _mm_storeu_si128((__m128i *)out, _mm_unpacklo_epi64(ab, cd));
    _mm_storeu_si128((__m128i *)(out + 16), _mm_unpackhi_epi64(ab, cd));
    _mm_storeu_si128((__m128i *)(out + 32), _mm_unpacklo_epi64(ef, gh));
    _mm_storeu_si128((__m128i *)(out + 48), _mm_unpackhi_epi64(ef, gh));
}

#endif
