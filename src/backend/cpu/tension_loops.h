/* The loops around the pair bodies of surface tension; part of pair_loops.h.
 *
 * Entries that repeat the particle itself add nothing, except to the sum of W, and those beyond the
 * support add nothing. */

#include "solver/pair_tension.h"

/* Volume of each neighbour of the same fluid, 0 of others. */
FORCE_INLINE real tension_volume(const float *fluid, real own, const uint32_t *index, real volume)
{
    if (fluid)
        volume = volume * pair_same(own, lookup_load(fluid, index));
    return volume;
}

FORCE_INLINE void normals_row(const struct pair_work *w, const struct lane_point *point, size_t i,
                              real sum[3], const unsigned flags)
{
    const uint32_t *row = w->rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
    const float *fluid = w->tension->fluid;
    real own = fluid ? real_load(fluid + i) : real_set(0);
    uint32_t length = longest(w->row_count + i);
    for (uint32_t k = 0; k < length; k++) {
        const uint32_t *index = row + (size_t)k * PARTICLE_BLOCK;
        real other[4];
        records_load(w->position, index, other);
        struct pair p = pair_between(point, other);
        pair_normal(sum, &p, tension_volume(fluid, own, index, other[3]), flags);
    }
}

/* Wall particles belong to every fluid. */
FORCE_INLINE void normals_wall_row(const struct pair_work *w, const struct lane_point *point,
                                   size_t i, real sum[3], const unsigned flags)
{
    const uint32_t *row = w->wall_rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
    uint32_t length = longest(w->wall_row_count + i);
    for (uint32_t k = 0; k < length; k++) {
        real other[4], far = real_set(16);
        records_load(w->wall, row + (size_t)k * PARTICLE_BLOCK, other);
        struct pair p = pair_between(point, other);
        p.q = real_below(k, w->wall_row_count + i, p.q, far);
        pair_normal(sum, &p, other[3], flags);
    }
}

FORCE_INLINE void normals_blocks(const struct pair_work *w, size_t first_block, size_t last_block,
                                 const unsigned flags)
{
    const struct tension_work *t = w->tension;
    for (size_t i = first_block * PARTICLE_BLOCK; i < last_block * PARTICLE_BLOCK; i += LANES) {
        real volume, zero = real_set(0), sum[3] = {zero, zero, zero};
        float out[3][LANES];
        struct lane_point point = point_load(w, i, &volume);
        normals_row(w, &point, i, sum, flags);
        if (w->wall)
            normals_wall_row(w, &point, i, sum, flags);
        for (int a = 0; a < 3; a++)
            real_store(out[a], sum[a]);
        for (size_t l = 0; l < LANES && i + l < w->count; l++) {
            float own[3] = {settled(out[0][l]), settled(out[1][l]), settled(out[2][l])};
            t->normal[i + l] = tension_normal(t->each, t->constants, &w->position[i + l], own);
        }
    }
}

/* Rows of the second pass, or with `smooth` of the third. */
FORCE_INLINE void surface_row(const struct pair_work *w, const struct lane_point *point, size_t i,
                              const real self[4], bool smooth, const real v[4], real sum[5], const unsigned flags)
{
    const uint32_t *row = w->rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
    const struct tension_work *t = w->tension;
    real own = t->fluid ? real_load(t->fluid + i) : real_set(0), far = real_set(16);
    real low = real_set(t->constants->low), scale = real_set(t->constants->scale);
    real mine = pair_surface(self[3], low, scale);
    uint32_t length = longest(w->row_count + i);
    for (uint32_t k = 0; k < length; k++) {
        const uint32_t *index = row + (size_t)k * PARTICLE_BLOCK;
        real other[4], normal[4];
        records_load(w->position, index, other);
        records_load(t->normal, index, normal);
        struct pair p = pair_between(point, other);
        real volume = tension_volume(t->fluid, own, index, other[3]);
        real surface = pair_surface(normal[3], low, scale), weight = volume * surface;
        if (smooth) {
            p.q = real_below(k, w->row_count + i, p.q, far);
            p.q2 = real_below(k, w->row_count + i, p.q2, far);
            pair_tension(sum, &p, weight, lookup_load(t->curvature, index), flags);
            real vj[4];
            records_load(w->motion, index, vj);
            pair_ripple(sum + 2, &p, volume * (surface + mine), v, vj, flags);
        } else {
            pair_curvature(sum, &p, weight, self, normal, flags);
        }
    }
}

FORCE_INLINE void curvature_blocks(const struct pair_work *w, size_t first_block,
                                   size_t last_block, const unsigned flags)
{
    const struct tension_work *t = w->tension;
    for (size_t i = first_block * PARTICLE_BLOCK; i < last_block * PARTICLE_BLOCK; i += LANES) {
        real volume, self[4], zero = real_set(0), sum[2] = {zero, zero};
        float out[2][LANES];
        struct lane_point point = point_load(w, i, &volume);
        records_load(t->normal + i, lane_ramp, self);
        surface_row(w, &point, i, self, false, self, sum, flags);
        real_store(out[0], sum[0]);
        real_store(out[1], sum[1]);
        for (size_t l = 0; l < LANES && i + l < w->count; l++)
            t->curvature[i + l] = tension_curvature(t->constants, settled(out[0][l]),
                                                    settled(out[1][l]));
    }
}

FORCE_INLINE void tension_blocks(const struct pair_work *w, size_t first_block, size_t last_block,
                                 const unsigned flags)
{
    const struct tension_work *t = w->tension;
    real low = real_set(t->constants->low), scale = real_set(t->constants->scale);
    for (size_t i = first_block * PARTICLE_BLOCK; i < last_block * PARTICLE_BLOCK; i += LANES) {
        real volume, zero = real_set(0), self[4], v[4], sum[5] = {zero, zero, zero, zero, zero};
        float out[5][LANES];
        records_load(w->motion + i, lane_ramp, v);
        struct lane_point point = point_load(w, i, &volume);
        records_load(t->normal + i, lane_ramp, self);
        sum[0] = volume * pair_surface(self[3], low, scale); /* w(0) = 1 */
        sum[1] = sum[0] * real_load(t->curvature + i);
        surface_row(w, &point, i, self, true, v, sum, flags);
        for (int a = 0; a < 5; a++)
            real_store(out[a], sum[a]);
        for (size_t l = 0; l < LANES && i + l < w->count; l++) {
            size_t k = i + l;
            int fluid = w->fluid ? w->fluid[k] : 0;
            float density = w->density ? w->density[k] : w->rest_density[fluid];
            tension_rate(t->constants, fluid, density, &t->normal[k], settled(out[0][l]),
                         settled(out[1][l]), &w->rate[k]);
            for (int a = 0; a < 3; a++)
                w->rate[k].acceleration[a] += t->constants->ripple[fluid] / density * settled(out[2 + a][l]);
        }
    }
}

#define TENSION(name, flags)                                                                       \
    static void normals_##name(const struct pair_work *w, size_t first, size_t last)               \
    {                                                                                              \
        normals_blocks(w, first, last, flags);                                                     \
    }                                                                                              \
    static void curvature_##name(const struct pair_work *w, size_t first, size_t last)             \
    {                                                                                              \
        curvature_blocks(w, first, last, flags);                                                   \
    }                                                                                              \
    static void tension_##name(const struct pair_work *w, size_t first, size_t last)               \
    {                                                                                              \
        tension_blocks(w, first, last, flags);                                                     \
    }
TENSION(wendland, 0)
TENSION(cubic, KERNEL_CUBIC)
TENSION(muller, PAIR_MULLER)
#undef TENSION

static pair_function *tension_find(enum pair_pass pass, unsigned flags)
{
    static pair_function *const table[3][3] = {
        {normals_wendland, normals_cubic, normals_muller},
        {curvature_wendland, curvature_cubic, curvature_muller},
        {tension_wendland, tension_cubic, tension_muller}};
    return table[pass - PAIR_PASS_NORMALS][flags & PAIR_MULLER ? 2 : flags & KERNEL_CUBIC ? 1 : 0];
}
