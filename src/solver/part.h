/* Moves particles apart that share a place, where the gradient of a pair vanishes and no force would.
 *
 * Each pair that is nearer than 1e-3 d moves along a direction hashed from its two ids, in opposite
 * ways in the ratio of the masses, to 0.2 to 0.4 d: the mass centre stays, to a count. Velocity and
 * density stay too. In the common subset of C and CUDA. */
#ifndef SOLVER_PART_H
#define SOLVER_PART_H

#include "solver/explicit.h"

#define PART_NEAR 1e-3  /* spacings; nearer particles share a place */
#define PART_MOST 0.25f /* spacings; largest component of the distance after it */

/* The square of that distance, in smoothing lengths. */
static inline float part_near2(double spacing, double smoothing_length)
{
    float near = (float)(PART_NEAR * spacing / smoothing_length);
    return near * near;
}

/* The bits of `word` well mixed (Appleby's finalizer of MurmurHash3). */
static inline uint32_t part_mix(uint32_t word)
{
    word ^= word >> 16;
    word *= 0x85ebca6bu;
    word ^= word >> 13;
    word *= 0xc2b2ae35u;
    return word ^ word >> 16;
}

/* Component of a distance, 0.5 to 1 or -1 to -0.5; the opposite when the ids are exchanged. */
static inline float part_component(uint32_t i, uint32_t j, uint32_t axis)
{
    uint32_t low = i < j ? i : j, high = i < j ? j : i;
    uint32_t word = part_mix(part_mix(part_mix(low) + high) + axis);
    float size = 0.5f + (float)(word >> 8) * 0x1p-25f;
    return (word & 1) == (i < j) ? size : -size;
}

/* 1 or -1 when the plane below or above is too near to move towards it, else 0. */
static inline int part_blocked(const struct explicit_constants *c, int a, const struct position *x)
{
    uint32_t room = (uint32_t)(PART_MOST * c->spacing * c->per_metre[a]);
    if (!c->closed[a])
        return 0;
    return x->count[a] - c->low[a] < room ? 1 : c->high[a] - x->count[a] < room ? -1 : 0;
}

/* Adds what particle i moves, in counts, because of particle j; `share` is j's part of their mass.
 * Along planes that are near; where three are near the one with the lower id moves off them. */
static inline void part_pair(const struct explicit_constants *c, const struct position *xi,
                             const struct position *xj, uint32_t i, uint32_t j, float share,
                             int32_t move[3])
{
    int inward[3];
    for (int a = 0; a < 3; a++)
        inward[a] = part_blocked(c, a, i < j ? xi : xj); /* the same for both */
    bool corner = inward[0] && inward[1] && inward[2];
    for (int a = 0; a < 3; a++) {
        float most = PART_MOST * c->spacing * c->per_metre[a];
        float part = part_component(i, j, (uint32_t)a);
        if (corner && i < j)
            move[a] += inward[a] * (int32_t)(most * fabsf(part));
        else if (!inward[a])
            move[a] += (int32_t)(share * most * part);
    }
}

/* Moves a particle; a crowd near a plane may push it beyond, from where it is mirrored. */
static inline void part_move(const struct explicit_constants *c, const int32_t move[3],
                             struct position *x)
{
    for (int a = 0; a < 3; a++) {
        x->count[a] += (uint32_t)move[a];
        if (!c->closed[a])
            continue;
        int64_t at = (int32_t)x->count[a], low = c->low[a], high = c->high[a];
        at = at < low ? 2 * low - at : at > high ? 2 * high - at : at;
        x->count[a] = (uint32_t)(at < low ? low : at > high ? high : at);
    }
}

#endif
