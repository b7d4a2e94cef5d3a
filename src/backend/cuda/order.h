/* Sorting and neighbour rows: what their kernels do for thread i. In the common subset of C and CUDA; the
 * includer says how threads add to a number that they share (order_add, order_add64), how 16 bytes are
 * moved (order_move), how many bits of a word are set and which is the lowest (order_bits, order_lowest). */
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

/* The next candidates of a range, at most 32 and never the point itself; the rest stays in *left. */
static inline struct range order_some(uint32_t own, struct range *left)
{
    struct range some = *left;
    some.last = some.last - some.first > 32 ? some.first + 32 : some.last;
    left->first = some.last;
    if (own - some.first < some.last - some.first) {
        some.last = own;
        left->first = own + 1;
    }
    return some;
}

/* Which of some candidates are neighbours of a point, a bit each; lowers *nearest to the least square of a distance. */
static inline uint32_t order_hits(const struct order_work *w, const struct position *point,
                                  struct range some, float *nearest)
{
    const struct position *end = w->candidates + some.last;
    const float limit = w->limit;
    float least = *nearest;
    uint32_t hits = 0, bit = 1;
    for (const struct position *j = w->candidates + some.first; j < end; j++, bit *= 2) {
        alignas(16) struct position other;
        order_move(&other, j);
        float q2 = near_q2(point->count, other.count, w->scale);
        if (q2 < limit)
            hits += bit;
        least = fminf(least, q2);
    }
    *nearest = least;
    return hits;
}

/* Counts the neighbours of point i, keeps which of its candidates they are, and says whether one shares its
 * place. */
static inline void order_row_counts(const struct order_work *w, size_t i)
{
    struct range range[RANGES_MAX];
    const int ranges = order_ranges(w, i, range);
    const uint32_t own = order_own(w, i);
    float nearest = w->limit;
    uint32_t count = 0, word = 0;
    alignas(16) struct position point;
    order_move(&point, &w->points[i]);
    for (int r = 0; r < ranges; r++)
        for (struct range left = range[r]; left.first < left.last; word++) {
            uint32_t hits = order_hits(w, &point, order_some(own, &left), &nearest);
            if (word < w->hit_words)
                w->hits[(size_t)word * w->point_count + i] = hits;
            count += order_bits(hits);
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
    float nearest = w->limit;
    uint32_t *out = w->index + first + lane, word = 0;
    alignas(16) struct position point;
    order_move(&point, &w->points[i]);
    for (int r = 0; r < ranges; r++)
        for (struct range left = range[r]; left.first < left.last; word++) {
            struct range some = order_some(own, &left);
            uint32_t hits = word < w->hit_words ? w->hits[(size_t)word * w->point_count + i]
                                                : order_hits(w, &point, some, &nearest);
            for (; hits != 0; hits &= hits - 1, out += PARTICLE_BLOCK)
                *out = 2 * (some.first + order_lowest(hits));
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
