/* A direction of each particle's own, by which shifting stirs lattices. In the common subset of C and
 * CUDA. */
#ifndef SOLVER_STIR_H
#define SOLVER_STIR_H

#include <stdint.h>

/* Component of it, -1 to 1: the bits of `word` well mixed (Appleby's finalizer of MurmurHash3). */
static inline float stir_component(uint32_t word)
{
    word ^= word >> 16;
    word *= 0x85ebca6bu;
    word ^= word >> 13;
    word *= 0xc2b2ae35u;
    word ^= word >> 16;
    return (float)(int32_t)word * 0x1p-31f;
}

#endif
