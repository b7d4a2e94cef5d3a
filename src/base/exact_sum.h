/* Sums of doubles whose bits do not depend on the order, hence on threads, lanes or sorting.
 *
 * Each term is cut at 2^-192 and its bits are spread over integers of 32 bits each, from 2^-192 to
 * 2^160; integers add exactly in any order, 2^31 terms without overflow. Terms of 2^127 and more,
 * or not finite, make the sum NAN. (The idea is Kulisch's long accumulator.) */
#ifndef BASE_EXACT_SUM_H
#define BASE_EXACT_SUM_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

enum { EXACT_PARTS = 11, EXACT_LOWEST = 192 };

struct exact_sum {
    int64_t part[EXACT_PARTS]; /* part k counts 2^(32 k - EXACT_LOWEST) */
    bool bad;
};

/* What a term adds to parts k, k + 1 and k + 2; returns k, or -1 for nothing, or -2 when the sum is to be
 * NAN. */
static inline __attribute__((always_inline)) int exact_split(double term, int64_t part[3])
{
    uint64_t bits, low = 0xffffffffu;
    if (!(fabs(term) < 0x1p127))
        return -2;
    memcpy(&bits, &term, sizeof bits);
    uint64_t mantissa = (bits & (UINT64_MAX >> 12)) | UINT64_C(1) << 52;
    int place = (int)(bits >> 52 & 0x7ff) - 1075 + EXACT_LOWEST;
    if (place <= -53)
        return -1;
    if (place < 0) {
        mantissa >>= -place;
        place = 0;
    }
    int k = place / 32, shift = place % 32;
    uint64_t rest = mantissa >> (32 - shift);
    int64_t sign = bits >> 63 ? -1 : 1;
    part[0] = sign * (int64_t)(mantissa << shift & low);
    part[1] = sign * (int64_t)(rest & low);
    part[2] = sign * (int64_t)(rest >> 32);
    return k;
}

static inline void exact_add(struct exact_sum *s, double term)
{
    int64_t part[3];
    int k = exact_split(term, part);
    if (k < 0) {
        s->bad = s->bad || k == -2;
        return;
    }
    s->part[k] += part[0];
    s->part[k + 1] += part[1];
    s->part[k + 2] += part[2];
}

static inline void exact_merge(struct exact_sum *s, const struct exact_sum *other)
{
    for (int k = 0; k < EXACT_PARTS; k++)
        s->part[k] += other->part[k];
    s->bad = s->bad || other->bad;
}

static inline double exact_value(const struct exact_sum *s)
{
    double sum = 0, scale = 0x1p128; /* of the highest part: 2^(320 - 192) */
    for (int k = EXACT_PARTS - 1; k >= 0; k--, scale *= 0x1p-32)
        sum += (double)s->part[k] * scale;
    return s->bad ? (double)NAN : sum;
}

#endif
