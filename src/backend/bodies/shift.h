/* The loops around the pair body of particle shifting; part of pair_bodies.h. */

#include "solver/pair_shift.h"

FORCE_INLINE void shift_row(const struct work *w, const struct lane_point *point, size_t i,
                            const real own[4], struct pair_shifts *s, const unsigned flags)
{
    const uint32_t *row = w->rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
    uint32_t length = longest(w->row_count + i);
    real closeness = real_set(w->choice->closeness);
    for (uint32_t k = 0; k < length; k++) {
        const uint32_t *index = row + (size_t)k * PARTICLE_BLOCK;
        real other[4], motion[4], far = real_set(16);
        records_load(w->position, index, other);
        records_load(w->motion, index, motion);
        struct pair p = pair_between(point, other);
        p.q = real_below(k, w->row_count + i, p.q, far);
        pair_shift(s, &p, other[3], own, motion, lookup_load(w->shifting.surface, index), closeness,
                   flags);
    }
}

/* Wall particles move with the particle, and are no surface. */
FORCE_INLINE void shift_wall_row(const struct work *w, const struct lane_point *point, size_t i,
                                 const real own[4], struct pair_shifts *s, const unsigned flags)
{
    const uint32_t *row = w->wall_rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
    uint32_t length = longest(w->wall_row_count + i);
    real closeness = real_set(w->choice->closeness);
    for (uint32_t k = 0; k < length; k++) {
        real other[4], far = real_set(16);
        records_load(w->wall, row + (size_t)k * PARTICLE_BLOCK, other);
        struct pair p = pair_between(point, other);
        p.q = real_below(k, w->wall_row_count + i, p.q, far);
        pair_shift(s, &p, other[3], own, own, real_set(0), closeness, flags);
    }
}

FORCE_INLINE void shift_store(const struct work *w, size_t i, const struct pair_shifts *s)
{
    const struct shift_work *t = &w->shifting;
    const float gradient = w->constants.gradient;
    float sum[6][LANES];
    real_store(sum[0], s->x);
    real_store(sum[1], s->y);
    real_store(sum[2], s->z);
    real_store(sum[3], s->divergence);
    real_store(sum[4], s->speed2);
    real_store(sum[5], s->surface);
    for (size_t l = 0; l < LANES && i + l < w->count; l++) {
        struct shift_sums sums = {{gradient * settled(sum[0][l]), gradient * settled(sum[1][l]),
                                   gradient * settled(sum[2][l])},
                                  gradient * w->choice->each.h * sum[3][l],
                                  settled(sum[4][l]),
                                  sum[5][l]};
        t->surface_now[i + l] =
            shift_choose(&w->choice->each, &w->position[i + l], w->id[i + l], sums, &t->now[i + l]);
    }
}

FORCE_INLINE void shift_sum(const struct work *w, size_t i, const unsigned flags)
{
    real volume, own[4], zero = real_set(0);
    struct pair_shifts s = {zero, zero, zero, zero, zero, zero};
    struct lane_point point = point_load(w, i, &volume);
    records_own(w->motion + i, own);
    shift_row(w, &point, i, own, &s, flags);
    if (w->wall)
        shift_wall_row(w, &point, i, own, &s, flags);
    shift_store(w, i, &s);
}
