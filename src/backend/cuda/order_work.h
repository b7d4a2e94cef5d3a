/* What the kernels that sort particles and build neighbour rows work on. In the common subset of C and
 * CUDA. */
#ifndef BACKEND_CUDA_ORDER_WORK_H
#define BACKEND_CUDA_ORDER_WORK_H

#include "backend/work.h"
#include "grid/cells.h"

/* What row builds find besides. */
struct row_facts {
    uint64_t entries;
    uint32_t coincident; /* points that share a place with another */
    uint32_t total;      /* entries of the longest rows of all blocks, of 16 each */
};

struct order_work {
    struct cells cells;
    /* of the sort */
    const struct position *points; /* that are sorted, or get rows */
    const uint32_t *id;
    size_t point_count;
    uint64_t *keys;                /* cell, then id */
    uint32_t *order;               /* order[new] = old */
    int id_bits;
    /* of a permutation: to[i] = from[order[i]], records of `size` bytes */
    void *to;
    const void *from;
    size_t size;
    /* of rows */
    const struct position *candidates;
    size_t candidate_count;
    bool same;                     /* candidates are the points: leave the particle itself out */
    bool all;                      /* every candidate is looked at */
    float scale[3];                /* counts to smoothing lengths */
    float limit;                   /* square of the list radius, in smoothing lengths */
    float coincident;              /* and of the distance below which two share a place; 0: none does */
    uint32_t *count;               /* of each point */
    uint32_t *hits;                /* which candidates are neighbours: word k of point i at k point_count + i */
    uint32_t hit_words;            /* of each point; further candidates are looked at again */
    uint32_t *length;              /* of each block; then of all before it */
    struct row_block *block;
    uint32_t *index;
    float *weight;                 /* or NULL */
    struct row_facts *facts;
};

#endif
