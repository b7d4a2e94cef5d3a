/* Sorting and neighbour rows: what their kernels do for thread i. In the common subset of C and CUDA; the
 * includer says how threads add to a number that they share (order_add, order_add64), and how 16 bytes are
 * moved (order_move). */
#ifndef BACKEND_CUDA_ORDER_H
#define BACKEND_CUDA_ORDER_H

#include "backend/bodies/near.h"
#include "backend/cuda/order_work.h"

#include <stdalign.h>

static inline void order_keys(const struct order_work *w, size_t i)
{
    w->keys[i] = (uint64_t)cells_index(&w->cells, w->points[i].count) << w->id_bits | w->id[i];
    w->order[i] = (uint32_t)i;
}

/* The first particle of cell i, by bisection of the sorted keys. */
static inline void order_starts(const struct order_work *w, size_t i)
{
    const uint64_t key = (uint64_t)i << w->id_bits;
    size_t low = 0, high = w->point_count;
    while (low < high) {
        size_t middle = (low + high) / 2;
        if (w->keys[middle] < key)
            low = middle + 1;
        else
            high = middle;
    }
    w->cells.start[i] = (uint32_t)low;
}

static inline void order_permute(const struct order_work *w, size_t i)
{
    const size_t words = w->size / 4;
    if (w->size == 16) {
        order_move((char *)w->to + 16 * i, (const char *)w->from + 16 * (size_t)w->order[i]);
        return;
    }
    if (w->size == 1) {
        ((uint8_t *)w->to)[i] = ((const uint8_t *)w->from)[w->order[i]];
        return;
    }
    for (size_t k = 0; k < words; k++)
        ((uint32_t *)w->to)[words * i + k] = ((const uint32_t *)w->from)[words * w->order[i] + k];
}

/* Ranges of candidates around point i. */
static inline int order_ranges(const struct order_work *w, size_t i, struct range out[RANGES_MAX])
{
    if (!w->all)
        return cells_ranges(&w->cells, w->points[i].count, out);
    out[0].first = 0;
    out[0].last = (uint32_t)w->candidate_count;
    return 1;
}

/* The candidate that point i is itself; none has the number UINT32_MAX. */
static inline uint32_t order_own(const struct order_work *w, size_t i)
{
    return w->same ? (uint32_t)i : UINT32_MAX;
}

/* The square of the distance of two points, in smoothing lengths; far from itself. */
static inline float order_q2(const struct order_work *w, const struct position *point, uint32_t own, uint32_t j)
{
    alignas(16) struct position other;
    order_move(&other, &w->candidates[j]);
    float q2 = near_q2(point->count, other.count, w->scale);
    return j == own ? INFINITY : q2;
}

/* Counts the neighbours of point i, and says whether one shares its place. */
static inline void order_row_counts(const struct order_work *w, size_t i)
{
    struct range range[RANGES_MAX];
    const int ranges = order_ranges(w, i, range);
    const uint32_t own = order_own(w, i);
    const float limit = w->limit;
    float nearest = limit;
    uint32_t count = 0;
    alignas(16) struct position point;
    order_move(&point, &w->points[i]);
    for (int r = 0; r < ranges; r++) {
        const struct range some = range[r];
        for (uint32_t j = some.first; j < some.last; j++) {
            float q2 = order_q2(w, &point, own, j);
            count += q2 < limit;
            nearest = q2 < nearest ? q2 : nearest;
        }
    }
    w->count[i] = count;
    order_add64(&w->facts->entries, count);
    if (nearest < w->coincident)
        order_add(&w->facts->coincident, 1);
}

/* The longest row of block i. */
static inline void order_row_lengths(const struct order_work *w, size_t i)
{
    uint32_t most = 0;
    for (size_t l = i * PARTICLE_BLOCK; l < (i + 1) * PARTICLE_BLOCK && l < w->point_count; l++)
        most = w->count[l] > most ? w->count[l] : most;
    w->length[i] = most;
}

/* Fills the row of point i; the first of a block says where the block's rows are. */
static inline void order_rows(const struct order_work *w, size_t i)
{
    const size_t b = i / PARTICLE_BLOCK, lane = i % PARTICLE_BLOCK;
    const size_t first = (size_t)w->length[b] * PARTICLE_BLOCK;
    struct range range[RANGES_MAX];
    const int ranges = order_ranges(w, i, range);
    const uint32_t own = order_own(w, i);
    const float limit = w->limit;
    uint32_t *out = w->index + first + lane;
    alignas(16) struct position point;
    order_move(&point, &w->points[i]);
    for (int r = 0; r < ranges; r++) {
        const struct range some = range[r];
        for (uint32_t j = some.first; j < some.last; j++)
            if (order_q2(w, &point, own, j) < limit) {
                *out = 2 * j;
                out += PARTICLE_BLOCK;
            }
    }
    if (lane == 0) {
        w->block[b].index = w->index + first;
        w->block[b].weight = w->weight ? w->weight + first : NULL;
        w->block[b].length = w->length[b + 1] - w->length[b];
    }
}

/* Values of a sorted copy go back to where the particles are. */
static inline void order_hand_back(const struct order_work *w, size_t i)
{
    ((float *)w->to)[w->order[i]] = ((const float *)w->from)[i];
}

#endif
