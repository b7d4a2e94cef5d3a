/* The sums over neighbour rows around the pair bodies of solver/, included once per instruction set and by
 * CUDA after its lanes_*.h. Each function works on the LANES particles from i on.
 *
 * Lane = particle: each lane adds its own neighbours one at a time, in the order of its row, so the
 * sum does not depend on how many lanes there are. */
#include "backend/bodies/each_implicit.h"
#include "backend/pairs.h"
#include "solver/pair_shift.h"

#include <math.h>

/* The flags are constants only in an inlined copy. */
#define FORCE_INLINE static inline __attribute__((always_inline))

/* 1/sqrt(x) to the last bit or two, in plain arithmetic, hence the same bits on every target and
 * several times faster than square root and division: the bit guess, one cubic (Halley-like) and
 * one Newton step. Finite at x = 0. */
FORCE_INLINE real real_rsqrt(real x)
{
    real y = real_rsqrt_guess(x);
    real e = (x * y) * y;
    y = y * real_fma(e, real_fma(e, real_set(0.375f), real_set(-1.25f)), real_set(1.875f));
    e = (x * y) * y;
    return y * real_fma(e, real_set(-0.5f), real_set(1.5f));
}

struct lane_point {
    real x, y, z; /* fixed-point bits */
    real sx, sy, sz;
};

FORCE_INLINE struct pair pair_between(const struct lane_point *i, const real other[4])
{
    struct pair p;
    p.x = real_difference(i->x, other[0]) * i->sx;
    p.y = real_difference(i->y, other[1]) * i->sy;
    p.z = real_difference(i->z, other[2]) * i->sz;
    p.q2 = real_fma(p.z, p.z, real_fma(p.y, p.y, p.x * p.x));
    p.inverse = real_rsqrt(p.q2);
    p.q = p.q2 * p.inverse;
    return p;
}

static inline uint32_t longest(const uint32_t *count)
{
    uint32_t most = 0;
    for (int l = 0; l < LANES; l++)
        most = count[l] > most ? count[l] : most;
    return most;
}

FORCE_INLINE struct lane_point point_load(const struct work *w, size_t first, real *volume)
{
    real record[4];
    const float *scale = w->constants.scale;
    records_own(w->position + first, record);
    *volume = record[3];
    return (struct lane_point){record[0],          record[1],          record[2],
                               real_set(scale[0]), real_set(scale[1]), real_set(scale[2])};
}

/* Sum of w over row entries below the count of each lane: padded entries must not count. With
 * `weighted` each entry counts by its volume. */
FORCE_INLINE real density_row(const struct lane_point *point, const struct position *records,
                              const uint32_t *row, const uint32_t *count, bool weighted, real sum,
                              const unsigned flags)
{
    uint32_t length = longest(count);
    for (uint32_t k = 0; k < length; k++) {
        real other[4], far = real_set(16);
        records_load(records, row + (size_t)k * PARTICLE_BLOCK, other);
        struct pair p = pair_between(point, other);
        p.q2 = real_below(k, count, p.q2, far);
        p.q = real_below(k, count, p.q, far);
        pair_density(&sum, &p, weighted ? other[3] : real_set(1), flags);
    }
    return sum;
}

/* Density by summation: number[i] = w(0) + sum_j w(q_ij) + sum_b V_b w(q_ib). */
FORCE_INLINE void density_sum(const struct work *w, size_t i, const unsigned flags)
{
    const size_t block = i / PARTICLE_BLOCK, lane = i % PARTICLE_BLOCK;
    real volume;
    struct lane_point point = point_load(w, i, &volume);
    real sum = density_row(&point, w->position, w->rows[block].index + lane, w->row_count + i,
                           false, real_set(w->constants.self), flags);
    if (w->wall)
        sum = density_row(&point, w->wall, w->wall_rows[block].index + lane,
                          w->wall_row_count + i, true, sum, flags);
    real_store(w->number + i, sum);
}

struct lane_particle {
    struct lane_point point;
    struct pair_state state;
    struct pair_lane_constants constants;
    struct pair_sums sums;
};

/* What i's pressure counts in its sums: p_i + p_j, and deep in shifting fluid p_j - p_i. */
FORCE_INLINE void pressure_load(const struct work *w, size_t i, struct pair_state *state)
{
    state->own = state->pressure;
    state->wall = real_positive(state->pressure);
    if (!w->shift)
        return;
    real shift[4], one = real_set(1);
    records_own(w->shift + i, shift);
    state->own = (one - real_set(2) * shift[3]) * state->pressure;
    state->wall = (one - shift[3]) * (state->pressure + state->wall) - state->own;
}

FORCE_INLINE struct lane_particle particle_load(const struct work *w, size_t i,
                                                 const unsigned flags)
{
    struct lane_particle p;
    real motion[4];
    float rest[LANES], inverse[LANES];
    const float *head = w->constants.head;
    p.point = point_load(w, i, &p.state.volume);
    records_own(w->motion + i, motion);
    p.state.vx = motion[0], p.state.vy = motion[1], p.state.vz = motion[2];
    p.state.pressure = motion[3];
    pressure_load(w, i, &p.state);
    p.state.viscosity = flags & PAIR_OWN_VISCOSITY ? real_load(w->viscosity + i) : real_set(0);
    for (int l = 0; l < LANES; l++) {
        rest[l] = w->choice->each.rest_density[work_fluid(w, i + (size_t)l)];
        inverse[l] = flags & PAIR_SYMMETRIC ? 1 / w->position[i + (size_t)l].volume : 0;
    }
    real rho0 = real_load(rest), zero = real_set(0);
    p.state.inverse_volume = real_load(inverse);
    p.state.rest = rho0;
    p.constants = (struct pair_lane_constants){
        real_set(w->constants.viscosity), real_set(w->constants.inverse_h),
        real_set(w->constants.central),   real_set(w->constants.artificial), rho0 * real_set(head[0]),
        rho0 * real_set(head[1]),         rho0 * real_set(head[2])};
    p.sums = (struct pair_sums){{zero, zero, zero}, zero, zero};
    return p;
}

struct lane_neighbour {
    struct pair_state state;
    struct pair pair;
};

FORCE_INLINE struct lane_neighbour neighbour_load(const struct work *w,
                                                  const struct lane_particle *self,
                                                  const uint32_t *index, const unsigned flags)
{
    struct lane_neighbour n;
    real other[4], motion[4];
    records_load(w->position, index, other);
    records_load(w->motion, index, motion);
    n.pair = pair_between(&self->point, other);
    n.state = (struct pair_state){.volume = other[3], .vx = motion[0], .vy = motion[1],
                                  .vz = motion[2], .pressure = motion[3]};
    n.state.viscosity = flags & PAIR_OWN_VISCOSITY ? lookup_load(w->viscosity, index)
                                                   : real_set(0);
    n.state.rest = flags & PAIR_MIXED ? lookup_load(w->rest, index) : real_set(0);
    return n;
}

/* A sum of rounding errors only; kept, its products would be denormal, and slow. */
static inline float settled(float sum)
{
    return fabsf(sum) < 1e-20f ? 0 : sum;
}

/* dv/dt = g + gradient/rho_i sums; drho/dt = gradient (rho_i divergence + diffusion). */
static inline void rate_store(const struct work *w, size_t i, const struct pair_sums *s)
{
    const struct pair_constants *c = &w->constants;
    float sum[5][LANES];
    for (int a = 0; a < 3; a++)
        real_store(sum[a], s->a[a]);
    real_store(sum[3], s->divergence);
    real_store(sum[4], s->diffusion);
    for (size_t l = 0; l < LANES && i + l < w->count; l++) {
        struct rate *rate = &w->rate[i + l];
        int fluid = work_fluid(w, i + l);
        float rest = w->choice->each.rest_density[fluid];
        float diffusion = w->soft ? c->diffusion * w->choice->softness[fluid] : c->diffusion;
        float density = w->density ? w->density[i + l] : rest, front = c->gradient / density;
        for (int a = 0; a < 3; a++)
            rate->acceleration[a] = c->gravity[a] + front * settled(sum[a][l]);
        rate->density = c->gradient * (density * settled(sum[3][l]) + diffusion * settled(sum[4][l]));
    }
}

FORCE_INLINE void force_sum(const struct work *w, size_t i, const unsigned flags, const bool walls)
{
    const uint32_t *row = w->rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
    uint32_t length = longest(w->row_count + i);
    struct lane_particle self = particle_load(w, i, flags);
    uint32_t k = 0;
    for (; k + 1 < length; k += 2) {
        const uint32_t *index = row + (size_t)k * PARTICLE_BLOCK;
        struct lane_neighbour a = neighbour_load(w, &self, index, flags);
        struct lane_neighbour b = neighbour_load(w, &self, index + PARTICLE_BLOCK, flags);
        pair_force(&self.sums, &self.state, &a.state, &a.pair, &self.constants, flags);
        pair_force(&self.sums, &self.state, &b.state, &b.pair, &self.constants, flags);
    }
    if (k < length) {
        const uint32_t *index = row + (size_t)k * PARTICLE_BLOCK;
        struct lane_neighbour a = neighbour_load(w, &self, index, flags);
        pair_force(&self.sums, &self.state, &a.state, &a.pair, &self.constants, flags);
    }
    if (walls) {
        row = w->wall_rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
        length = longest(w->wall_row_count + i);
        for (k = 0; k < length; k++) {
            real other[4], far = real_set(16);
            records_load(w->wall, row + (size_t)k * PARTICLE_BLOCK, other);
            struct pair p = pair_between(&self.point, other);
            p.q = real_below(k, w->wall_row_count + i, p.q, far);
            pair_wall(&self.sums, &self.state, other[3], &p, &self.constants, flags);
        }
    }
    rate_store(w, i, &self.sums);
}

#include "backend/bodies/diffusion.h"
#include "backend/bodies/curl.h"
#include "backend/bodies/solve.h"
#include "backend/bodies/drag.h"
#include "backend/bodies/shift.h"
#include "backend/bodies/tension.h"
#include "backend/bodies/projection.h"
