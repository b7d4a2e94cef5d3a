/* Random numbers for tests, the same on every machine. */
#ifndef TESTS_RANDOM_H
#define TESTS_RANDOM_H

#include <stdint.h>

static inline uint32_t random_bits(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (uint32_t)(*state >> 32);
}

/* Uniform in [low, high). */
static inline double random_between(uint64_t *state, double low, double high)
{
    return low + (high - low) * random_bits(state) * 0x1p-32;
}

/* Puts count numbers 0 .. count-1 in random order. */
static inline void random_order(uint64_t *state, uint32_t *out, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        uint32_t j = random_bits(state) % (i + 1);
        out[i] = out[j];
        out[j] = i;
    }
}

#endif
