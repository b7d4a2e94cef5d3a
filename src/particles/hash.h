/* The hash of one particle's state: id, position, velocity and density. The state's hash is their sum with the
 * count's, so that order in memory does not matter. In the common subset of C and CUDA. */
#ifndef PARTICLES_HASH_H
#define PARTICLES_HASH_H

#include "particles/particles.h"

#include <string.h>

/* splitmix64's finalizer (Steele et al. 2014): every input bit reaches every output bit. */
static inline uint64_t hash_mix(uint64_t x)
{
    x ^= x >> 30;
    x *= UINT64_C(0xbf58476d1ce4e5b9);
    x ^= x >> 27;
    x *= UINT64_C(0x94d049bb133111eb);
    return x ^ x >> 31;
}

static inline uint64_t hash_word(uint64_t seed, uint32_t word)
{
    return hash_mix(seed ^ word) + UINT64_C(0x9e3779b97f4a7c15);
}

static inline uint64_t hash_float(uint64_t seed, float value)
{
    uint32_t word;
    memcpy(&word, &value, sizeof word);
    return hash_word(seed, word);
}

static inline uint64_t hash_particle(uint32_t id, const struct position *x, const struct motion *m, float density)
{
    uint64_t h = id;
    for (int a = 0; a < 3; a++)
        h = hash_word(h, x->count[a]);
    for (int a = 0; a < 3; a++)
        h = hash_float(h, m->velocity[a]);
    return hash_mix(hash_float(h, density));
}

#endif
