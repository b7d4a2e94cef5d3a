/* The loops of an instruction set, included once for each after its lanes_*.h. */
#include "backend/work.h"

#include "backend/cpu/lanes_own.h"
#include "backend/bodies/pair_bodies.h"
#include "backend/cpu/isa.h"

#define BLOCKS(name, call)                                                                         \
    static void name(const struct work *w, size_t first, size_t last)                              \
    {                                                                                              \
        for (size_t i = first * PARTICLE_BLOCK; i < last * PARTICLE_BLOCK; i += LANES)             \
            call;                                                                                  \
    }
#define PAIR(name, call) BLOCKS(name##_blocks, call)
#include "backend/bodies/pair_list.h"
#undef PAIR
/* One function per combination that a solver can ask for, with and without wall particles: the flags
 * are constants inside. */
#define FORCE(flags)                                                                               \
    BLOCKS(force_##flags, force_sum(w, i, flags, false))                                           \
    BLOCKS(force_walls_##flags, force_sum(w, i, flags, true))
#include "backend/bodies/force_list.h"
#undef FORCE
#undef BLOCKS

static pair_function *const loops_pair[BODY_COUNT] = {
#define PAIR(name, call) [BODY_##name] = name##_blocks,
#include "backend/bodies/pair_list.h"
#undef PAIR
#define FORCE(flags) [BODY_force_##flags] = force_##flags, [BODY_force_walls_##flags] = force_walls_##flags,
#include "backend/bodies/force_list.h"
#undef FORCE
};

/* Candidates of the cell that the last particle was in; the next one is often in it too. */
struct candidates {
    struct range range[RANGES_MAX];
    int ranges;
    size_t sum;
    uint32_t cell;
};

static void candidates_find(const struct row_build *b, const uint32_t point[3],
                            struct candidates *c)
{
    uint32_t cell = cells_index(b->cells, point);
    if (cell == c->cell)
        return;
    c->cell = cell;
    c->ranges = b->search->ranges(b->cells, point, b->candidate_count, c->range);
    c->sum = 0;
    for (int r = 0; r < c->ranges; r++)
        c->sum += c->range[r].last - c->range[r].first;
}

static size_t loops_build(const struct row_build *b, size_t block, struct row_scratch *scratch)
{
    struct candidates near = {.cell = UINT32_MAX};
    struct row_build work = *b; /* a copy that no store can alias */
    const float limit[2] = {b->limit, b->coincident};
    bool coincident = false;
    for (size_t l = 0; l < PARTICLE_BLOCK; l++) {
        size_t i = block * PARTICLE_BLOCK + l;
        uint32_t *list = scratch->list + l * scratch->room, *end = list;
        scratch->count[l] = 0;
        if (i >= work.point_count)
            continue;
        const uint32_t *point = work.points[i].count;
        candidates_find(&work, point, &near);
        if (near.sum + PARTICLE_BLOCK > scratch->room)
            return near.sum + PARTICLE_BLOCK;
        for (int r = 0; r < near.ranges; r++)
            end = rows_append(end, work.axis, point, work.scale, limit, near.range[r].first,
                              near.range[r].last, work.same ? (uint32_t)i : UINT32_MAX,
                              &coincident);
        scratch->count[l] = (uint32_t)(end - list);
    }
    scratch->coincident |= coincident;
    return 0;
}

/* Four lists at a time, four entries at a time. */
static void loops_interleave(const struct row_scratch *scratch, uint32_t length, uint32_t *rows)
{
    for (size_t l = 0; l < PARTICLE_BLOCK; l += 4) {
        const uint32_t *list = scratch->list + l * scratch->room;
        for (uint32_t k = 0; k < length; k += 4)
            rows_transpose(list + k, scratch->room, rows + (size_t)k * PARTICLE_BLOCK + l);
    }
}

/* Ten independent chains: enough to cover the latency of two FMA units. */
static double loops_peak(long rounds, float *sink)
{
    real a = real_set(0.999f), b = real_set(1e-3f);
    real c0 = a, c1 = b, c2 = a, c3 = b, c4 = a, c5 = b, c6 = a, c7 = b, c8 = a, c9 = b;
    float out[LANES];
    for (long r = 0; r < rounds; r++) {
        c0 = real_fma(c0, a, b), c1 = real_fma(c1, a, b), c2 = real_fma(c2, a, b);
        c3 = real_fma(c3, a, b), c4 = real_fma(c4, a, b), c5 = real_fma(c5, a, b);
        c6 = real_fma(c6, a, b), c7 = real_fma(c7, a, b), c8 = real_fma(c8, a, b);
        c9 = real_fma(c9, a, b);
    }
    real_store(out, ((c0 + c1) + (c2 + c3)) + ((c4 + c5) + (c6 + c7)) + (c8 + c9));
    *sink = out[0];
    return 20.0 * LANES * (double)rounds;
}
