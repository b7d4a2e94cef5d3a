/* The loops around the pair bodies of surface tension; part of pair_bodies.h. Entries that repeat
 * the particle itself, or lie beyond the support, add nothing to the sums. */

#include "solver/pair_tension.h"

/* The neighbour's volume if it is of the same fluid, else 0. */
FORCE_INLINE real tension_volume(const float *fluid, real own, const uint32_t *index, real volume)
{
    if (fluid)
        volume = volume * pair_same(own, lookup_load(fluid, index));
    return volume;
}

FORCE_INLINE void normals_row(const struct work *w, const struct lane_point *point, size_t i,
                              real sum[3])
{
    const uint32_t *row = w->rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
    const float *fluid = w->tension.fluid;
    real own = fluid ? real_load(fluid + i) : real_set(0);
    uint32_t length = longest(w->row_count + i);
    for (uint32_t k = 0; k < length; k++) {
        const uint32_t *index = row + (size_t)k * PARTICLE_BLOCK;
        real other[4];
        records_load(w->position, index, other);
        struct pair p = pair_between(point, other);
        pair_normal(sum, &p, tension_volume(fluid, own, index, other[3]));
    }
}

/* Wall particles belong to every fluid. */
FORCE_INLINE void normals_wall_row(const struct work *w, const struct lane_point *point, size_t i,
                                   real sum[3])
{
    const uint32_t *row = w->wall_rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
    uint32_t length = longest(w->wall_row_count + i);
    for (uint32_t k = 0; k < length; k++) {
        real other[4], far = real_set(16);
        records_load(w->wall, row + (size_t)k * PARTICLE_BLOCK, other);
        struct pair p = pair_between(point, other);
        p.q = real_below(k, w->wall_row_count + i, p.q, far);
        pair_normal(sum, &p, other[3]);
    }
}

FORCE_INLINE void tension_row(const struct work *w, const struct lane_point *point, size_t i,
                              const real self[4], real sum[2])
{
    const uint32_t *row = w->rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
    const float *fluid = w->tension.fluid;
    real own = fluid ? real_load(fluid + i) : real_set(0);
    uint32_t length = longest(w->row_count + i);
    for (uint32_t k = 0; k < length; k++) {
        const uint32_t *index = row + (size_t)k * PARTICLE_BLOCK;
        real other[4], normal[4];
        records_load(w->position, index, other);
        records_load(w->tension.normal, index, normal);
        struct pair p = pair_between(point, other);
        pair_curvature(sum, &p, tension_volume(fluid, own, index, other[3]), self, normal);
    }
}

FORCE_INLINE void normals_sum(const struct work *w, size_t i)
{
    const struct tension_work *t = &w->tension;
    real volume, zero = real_set(0), sum[3] = {zero, zero, zero};
    float out[3][LANES];
    struct lane_point point = point_load(w, i, &volume);
    normals_row(w, &point, i, sum);
    if (w->wall)
        normals_wall_row(w, &point, i, sum);
    for (int a = 0; a < 3; a++)
        real_store(out[a], sum[a]);
    for (size_t l = 0; l < LANES && i + l < w->count; l++) {
        float own[3] = {settled(out[0][l]), settled(out[1][l]), settled(out[2][l])};
        t->normal[i + l] =
            tension_normal(&w->choice->each, &w->choice->tension, &w->position[i + l], own);
    }
}

FORCE_INLINE void tension_sum(const struct work *w, size_t i)
{
    const struct tension_work *t = &w->tension;
    real volume, self[4], zero = real_set(0), sum[2] = {zero, zero};
    float out[2][LANES];
    struct lane_point point = point_load(w, i, &volume);
    records_own(t->normal + i, self);
    tension_row(w, &point, i, self, sum);
    real_store(out[0], sum[0]);
    real_store(out[1], sum[1]);
    for (size_t l = 0; l < LANES && i + l < w->count; l++) {
        const int f = work_fluid(w, i + l);
        float curvature =
            tension_curvature(&w->choice->tension, settled(out[0][l]), settled(out[1][l]));
        if (t->pressure)
            t->pressure[i + l] = tension_pressure(&w->choice->tension, f, curvature);
        else
            tension_rate(&w->choice->tension, f, &t->normal[i + l], curvature, &w->rate[i + l]);
    }
}
