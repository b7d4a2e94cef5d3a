/* The loops around the pair bodies of density diffusion by gradients; part of pair_bodies.h. Entries that
 * repeat the particle itself, or lie beyond the support, add nothing to the sums. */

#include "solver/pair_diffusion.h"

/* Volume and geometry of the neighbours at row entries; no volume if their rest density is another. */
FORCE_INLINE real diffusion_pair(const struct work *w, const struct lane_point *point, real rest,
                                 const uint32_t *index, struct pair *p, const unsigned flags)
{
    real other[4];
    records_load(w->position, index, other);
    *p = pair_between(point, other);
    if (!(flags & PAIR_MIXED))
        return other[3];
    const struct pair_state own = {.rest = rest}, j = {.rest = lookup_load(w->rest, index)};
    return other[3] * pair_alike(&own, &j);
}

FORCE_INLINE void gradient_store(const struct work *w, size_t i, const struct pair_gradients *s)
{
    const struct explicit_constants *each = &w->choice->each;
    float stiffness[LANES], rest[LANES], out[3][LANES];
    real g[3];
    for (size_t l = 0; l < LANES; l++) {
        int fluid = work_fluid(w, i + l);
        stiffness[l] = gradient_stiffness(each, fluid);
        rest[l] = each->rest_density[fluid];
    }
    pair_gradient_solve(g, s, real_load(stiffness));
    for (int a = 0; a < 3; a++)
        real_store(out[a], g[a]);
    for (size_t l = 0; l < LANES && i + l < w->count; l++)
        w->gradient[i + l] = (struct gradient){
            {settled(out[0][l]), settled(out[1][l]), settled(out[2][l])},
            stiffness[l] * (w->density[i + l] - rest[l])};
}

FORCE_INLINE void gradient_sum(const struct work *w, size_t i, const unsigned flags)
{
    const uint32_t *row = w->rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
    uint32_t length = longest(w->row_count + i);
    real volume, zero = real_set(0), density = real_load(w->density + i);
    real rest = flags & PAIR_MIXED ? real_load(w->rest + i) : zero;
    struct pair_gradients s = {zero, zero, zero, zero, zero, zero, zero, zero, zero};
    struct lane_point point = point_load(w, i, &volume);
    for (uint32_t k = 0; k < length; k++) {
        const uint32_t *index = row + (size_t)k * PARTICLE_BLOCK;
        struct pair p;
        volume = diffusion_pair(w, &point, rest, index, &p, flags);
        pair_gradient(&s, &p, volume, density - lookup_load(w->density, index), flags);
    }
    gradient_store(w, i, &s);
}

FORCE_INLINE void diffusion_sum(const struct work *w, size_t i, const unsigned flags)
{
    const struct pair_constants *c = &w->constants;
    const struct gradient *gradient = w->gradient;
    const uint32_t *row = w->rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
    uint32_t length = longest(w->row_count + i);
    real volume, own[4], sum = real_set(0);
    real rest = flags & PAIR_MIXED ? real_load(w->rest + i) : sum;
    struct lane_point point = point_load(w, i, &volume);
    float out[LANES];
    records_own(gradient + i, own);
    for (uint32_t k = 0; k < length; k++) {
        const uint32_t *index = row + (size_t)k * PARTICLE_BLOCK;
        real other[4];
        struct pair p;
        volume = diffusion_pair(w, &point, rest, index, &p, flags);
        records_load(gradient, index, other);
        pair_diffusion(&sum, &p, volume, own, other, flags);
    }
    real_store(out, sum);
    for (size_t l = 0; l < LANES && i + l < w->count; l++) {
        float softness = w->soft ? w->choice->softness[work_fluid(w, i + l)] : 1;
        w->rate[i + l].density += c->gradient * (c->diffusion * softness * settled(out[l]));
    }
}
