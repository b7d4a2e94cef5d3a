/* The loop around the pair body of vorticity (solver/curl.h); part of pair_bodies.h. Entries that repeat
 * the particle itself, or lie beyond the support, add nothing to the sums. */

#include "solver/curl.h"

struct pair_curls {
    struct pair_gradients x; /* M, and the sum of V_j W'/r (v_i - v_j) x of v's x */
    real y[3], z[3];         /* that sum of its y and z */
};

FORCE_INLINE void curl_add(real sum[3], const struct pair *p, real share)
{
    sum[0] = real_fma(share, p->x, sum[0]);
    sum[1] = real_fma(share, p->y, sum[1]);
    sum[2] = real_fma(share, p->z, sum[2]);
}

FORCE_INLINE void curl_store(const struct work *w, size_t i, const struct pair_curls *s)
{
    struct pair_gradients y = s->x, z = s->x;
    real unit = real_set(w->constants.inverse_h), g[3][3];
    float out[3][3][LANES];
    y.x = s->y[0], y.y = s->y[1], y.z = s->y[2];
    z.x = s->z[0], z.y = s->z[1], z.z = s->z[2];
    pair_gradient_solve(g[0], &s->x, unit);
    pair_gradient_solve(g[1], &y, unit);
    pair_gradient_solve(g[2], &z, unit);
    for (int a = 0; a < 3; a++)
        for (int c = 0; c < 3; c++)
            real_store(out[a][c], g[a][c]);
    for (size_t l = 0; l < LANES && i + l < w->count; l++) {
        float gradient[3][3];
        for (int a = 0; a < 3; a++)
            for (int c = 0; c < 3; c++)
                gradient[a][c] = settled(out[a][c][l]);
        w->vorticity[i + l] = curl_size(gradient);
    }
}

FORCE_INLINE void curl_sum(const struct work *w, size_t i)
{
    const real zero = real_set(0);
    const uint32_t *row = w->rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
    uint32_t length = longest(w->row_count + i);
    struct pair_curls s = {{zero, zero, zero, zero, zero, zero, zero, zero, zero},
                           {zero, zero, zero}, {zero, zero, zero}};
    real volume, own[4], other[4], motion[4];
    struct lane_point point = point_load(w, i, &volume);
    records_own(w->motion + i, own);
    for (uint32_t k = 0; k < length; k++) {
        const uint32_t *index = row + (size_t)k * PARTICLE_BLOCK;
        records_load(w->position, index, other);
        records_load(w->motion, index, motion);
        struct pair p = pair_between(&point, other);
        real weight = other[3] * pair_slope(&p, 0);
        pair_gradient(&s.x, &p, other[3], own[0] - motion[0], 0);
        curl_add(s.y, &p, weight * (own[1] - motion[1]));
        curl_add(s.z, &p, weight * (own[2] - motion[2]));
    }
    curl_store(w, i, &s);
}
