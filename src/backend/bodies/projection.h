/* The loops around the projection solver's pair bodies; part of pair_bodies.h. */

#include "solver/pair_projection.h"

/* Row of LANES particles and the F_ij beside it. */
struct lane_row {
    const uint32_t *index;
    float *weight;
    uint32_t length;
};

FORCE_INLINE struct lane_row lane_row(const struct work *w, size_t i)
{
    const struct row_block *block = &w->rows[i / PARTICLE_BLOCK];
    return (struct lane_row){block->index + i % PARTICLE_BLOCK, block->weight + i % PARTICLE_BLOCK,
                             longest(w->row_count + i)};
}

/* x_i - x_j, in smoothing lengths. */
FORCE_INLINE void pair_distance(const struct lane_point *i, const real other[4], real x[3])
{
    x[0] = real_difference(i->x, other[0]) * i->sx;
    x[1] = real_difference(i->y, other[1]) * i->sy;
    x[2] = real_difference(i->z, other[2]) * i->sz;
}

FORCE_INLINE void stencil_store(const struct work *w, size_t i, const struct pair_stencils *s,
                                const struct stencil_sums walls[LANES])
{
    const struct projection_work *t = &w->projection;
    float out[14][LANES];
    real_store(out[0], s->number);
    real_store(out[1], s->weight);
    for (int a = 0; a < 3; a++) {
        real_store(out[2 + a], s->toward[a]);
        real_store(out[5 + a], s->crowd[a]);
    }
    for (int k = 0; k < 6; k++)
        real_store(out[8 + k], s->moment[k]);
    for (size_t l = 0; l < LANES && i + l < w->count; l++) {
        size_t k = i + l;
        struct stencil_sums sums = walls[l];
        sums.number += out[0][l];
        sums.weight = out[1][l];
        for (int a = 0; a < 3; a++) {
            sums.toward[a] = settled(out[2 + a][l]);
            sums.crowd[a] = settled(out[5 + a][l]);
        }
        for (int m = 0; m < 6; m++)
            sums.moment[m] = settled(out[8 + m][l]);
        struct stencil stencil = {.inverse = {0}};
        float ratio = projection_stencil(&w->choice->each, &w->choice->projection, &w->position[k],
                                         t->violent[k], &sums, &stencil);
        t->stencil[k] = stencil;
        w->state.density[k] = w->choice->each.rest_density[work_fluid(w, k)] * ratio;
        t->surface[k] = !w->choice->projection.enclosed && stencil.lack > w->choice->projection.loose ? 1 : 0;
    }
}

FORCE_INLINE struct pair_stencils stencils_none(void)
{
    real zero = real_set(0);
    struct pair_stencils s = {.number = zero, .weight = zero};
    for (int a = 0; a < 3; a++)
        s.toward[a] = s.crowd[a] = s.moment[a] = s.moment[3 + a] = zero;
    return s;
}

/* The sums over wall particles. */
FORCE_INLINE void stencil_wall_row(const struct work *w, const struct lane_point *point, size_t i,
                                   struct stencil_sums sums[LANES], const unsigned flags)
{
    const struct projection_constants *c = &w->choice->projection;
    const uint32_t *row = w->wall_rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
    struct pair_stencils s = stencils_none();
    float out[7][LANES];
    for (uint32_t k = 0; k < longest(w->wall_row_count + i); k++) {
        real other[4];
        records_load(w->wall, row + (size_t)k * PARTICLE_BLOCK, other);
        struct pair p = pair_between(point, other);
        p.q = real_below(k, w->wall_row_count + i, p.q, real_set(16));
        pair_stencil(&s, &p, other[3], real_set(c->closeness), real_set(0), flags);
    }
    real_store(out[0], s.number);
    for (int a = 0; a < 3; a++) {
        real_store(out[1 + a], s.toward[a]);
        real_store(out[4 + a], s.moment[a]);
    }
    for (size_t l = 0; l < LANES; l++) {
        sums[l].number = sums[l].wall_number = out[0][l];
        for (int a = 0; a < 3; a++) {
            sums[l].wall_toward[a] = settled(out[1 + a][l]);
            sums[l].wall_moment[a] = settled(out[4 + a][l]);
        }
    }
}

/* `mixed`: fluids differ in density. */
FORCE_INLINE void stencil_sum(const struct work *w, size_t i, const bool mixed,
                              const unsigned flags)
{
    real closeness = real_set(w->choice->projection.closeness), far = real_set(16);
    real laplacian = real_set(w->choice->projection.laplacian);
    real reference = real_set(w->choice->projection.reference);
    struct lane_row row = lane_row(w, i);
    real volume, inverse = mixed ? real_load(w->inverse_density + i) : real_set(0);
    struct lane_point point = point_load(w, i, &volume);
    struct pair_stencils s = stencils_none();
    struct stencil_sums walls[LANES] = {{0}};
    s.number = volume * real_set(w->constants.self);
    for (uint32_t k = 0; k < row.length; k++) {
        real other[4];
        records_load(w->position, row.index + (size_t)k * PARTICLE_BLOCK, other);
        struct pair p = pair_between(&point, other);
        p.q = real_below(k, w->row_count + i, p.q, far);
        real share = laplacian;
        if (mixed)
            share = laplacian * pair_share(reference, inverse,
                                           lookup_load(w->inverse_density,
                                                       row.index + (size_t)k * PARTICLE_BLOCK));
        real f = pair_stencil(&s, &p, other[3], closeness, share, flags);
        real_store(row.weight + (size_t)k * PARTICLE_BLOCK, f);
    }
    if (w->wall)
        stencil_wall_row(w, &point, i, walls, flags);
    stencil_store(w, i, &s, walls);
}

/* Whether the particle or any neighbour is at the surface; neighbours at the rim of the support
 * count less, so that rows may hold more than needed. And sum F f_j of the last step's shift. */
FORCE_INLINE void surface_sum(const struct work *w, size_t i)
{
    const struct projection_work *t = &w->projection;
    real rim = real_set(1e3f * w->choice->each.h * w->choice->each.h), one = real_set(1);
    struct lane_row row = lane_row(w, i);
    real most = real_load(t->surface + i), sum = real_set(0);
    float out[LANES], shift[LANES];
    for (uint32_t k = 0; k < row.length; k++) {
        real f = real_load(row.weight + (size_t)k * PARTICLE_BLOCK);
        real near = one - real_positive(one - rim * f);
        const uint32_t *index = row.index + (size_t)k * PARTICLE_BLOCK;
        most = pair_larger(near * lookup_load(t->surface, index), most);
        sum = real_fma(f, lookup_load(t->direction, index), sum);
    }
    real_store(out, most);
    real_store(shift, sum);
    for (size_t l = 0; l < LANES && i + l < w->count; l++) {
        struct stencil stencil = t->stencil[i + l];
        struct unknown unknown = t->unknown[i + l];
        projection_surface(&w->choice->each, &w->choice->projection, work_fluid(w, i + l), out[l],
                           settled(shift[l]), &stencil, &unknown);
        t->stencil[i + l] = stencil;
        t->unknown[i + l] = unknown;
    }
}

FORCE_INLINE void jump_store(const struct work *w, size_t k, float sum, float weight)
{
    const struct tension_work *t = &w->tension;
    struct stencil *s = &w->projection.stencil[k];
    float own = t->pressure[k], lacks[3], h = w->choice->each.h;
    projection_jump(&w->choice->projection, settled(sum), settled(weight), &t->normal[k], own, s);
    for (int a = 0; a < 3; a++)
        lacks[a] = h * (s->toward[a] + s->wall[a]);
    if (w->choice->tension.between)
        tension_between(&w->choice->tension, work_fluid(w, k), &t->normal[k], lacks, own,
                        &w->rate[k]);
}

/* The pressure that tension gives the surface around: its curvature is known at the surface only,
 * and particles see that of their own fluid. Between fluids tension is a force. */
FORCE_INLINE void jump_sum(const struct work *w, size_t i)
{
    const struct tension_work *t = &w->tension;
    struct lane_row row = lane_row(w, i);
    real sum = real_set(0), weight = sum, own = t->fluid ? real_load(t->fluid + i) : sum;
    float out[2][LANES];
    for (uint32_t k = 0; k < row.length; k++) {
        const uint32_t *index = row.index + (size_t)k * PARTICLE_BLOCK;
        real normal[4], f = real_load(row.weight + (size_t)k * PARTICLE_BLOCK);
        records_load(t->normal, index, normal);
        f = tension_volume(t->fluid, own, index, f) * normal[3];
        sum = real_fma(f, lookup_load(t->pressure, index), sum);
        weight = weight + f;
    }
    real_store(out[0], sum);
    real_store(out[1], weight);
    for (size_t l = 0; l < LANES && i + l < w->count; l++)
        jump_store(w, i + l, out[0][l], out[1][l]);
}

enum { FLOW_SUMS = 15 };

/* The right-hand side, from sums F (u_i - u_j) x, sum F p_j, the largest F |u_ij|^2, sums F (u_i - u_j), and the
 * largest difference to a neighbour in inverse density. */
static inline void flow_store(const struct work *w, size_t k, const float sum[FLOW_SUMS])
{
    const struct projection_work *t = &w->projection;
    const struct projection_constants *c = &w->choice->projection;
    struct stencil stencil = t->stencil[k], *s = &stencil;
    struct unknown unknown = t->unknown[k], *row = &unknown;
    const struct motion motion = w->motion[k];
    float tensor[9], half = 0.5f * w->choice->each.h;
    for (int a = 0; a < 9; a++)
        tensor[a] = half * settled(sum[a]);
    float divergence = projection_divergence(s, tensor, motion.velocity);
    float close = settled(sum[10]) / (c->laplacian * c->volume[0] * c->slope);
    s->speed = sqrtf(close > 0 ? close : 0);
    projection_fickian(c, w->id[k], w->scalars->dt, sum[14] > 0, tensor, s);
    projection_stray(sum[14] > 0, sum + 11, s);
    projection_row(c, s, w->scalars->before, divergence, motion.pressure, settled(sum[9]), row);
    t->stencil[k] = stencil;
    t->unknown[k] = unknown;
}

FORCE_INLINE void flow_sum(const struct work *w, size_t i, const bool mixed)
{
    real reference = real_set(w->choice->projection.reference);
    struct lane_row row = lane_row(w, i);
    real volume, own[4], zero = real_set(0);
    real inverse = mixed ? real_load(w->inverse_density + i) : zero;
    struct lane_point point = point_load(w, i, &volume);
    struct pair_flows s = {
        {zero, zero, zero, zero, zero, zero, zero, zero, zero}, {zero, zero, zero}, zero, zero};
    real apart = zero;
    float out[FLOW_SUMS][LANES];
    records_own(w->motion + i, own);
    for (uint32_t k = 0; k < row.length; k++) {
        const uint32_t *index = row.index + (size_t)k * PARTICLE_BLOCK;
        real other[4], motion[4], x[3], f = real_load(row.weight + (size_t)k * PARTICLE_BLOCK);
        real plain = f;
        records_load(w->position, index, other);
        records_load(w->motion, index, motion);
        if (mixed) {
            real neighbour = lookup_load(w->inverse_density, index);
            plain = f * pair_unshare(reference, inverse, neighbour);
            apart = pair_larger((neighbour - inverse) * (neighbour - inverse), apart);
        }
        pair_distance(&point, other, x);
        pair_flow(&s, x, own, motion, f, plain);
    }
    for (int a = 0; a < 9; a++)
        real_store(out[a], s.tensor[a]);
    real_store(out[9], s.around);
    real_store(out[10], s.speed2);
    for (int a = 0; a < 3; a++)
        real_store(out[11 + a], s.stray[a]);
    real_store(out[14], apart);
    for (size_t l = 0; l < LANES && i + l < w->count; l++) {
        float sum[FLOW_SUMS];
        for (int a = 0; a < FLOW_SUMS; a++)
            sum[a] = out[a][l];
        flow_store(w, i + l, sum);
    }
}

enum { PREFETCH = 1024 }; /* entries ahead, 4 kB: rows do not fit the cache */

/* The matrix times `direction`. */
FORCE_INLINE void product_sum(const struct work *w, size_t i)
{
    const struct projection_work *t = &w->projection;
    struct lane_row row = lane_row(w, i);
    real even = real_set(0), odd = real_set(0);
    float out[LANES];
    uint32_t k = 0;
    for (; k + 1 < row.length; k += 2) {
        const uint32_t *index = row.index + (size_t)k * PARTICLE_BLOCK;
        const float *weight = row.weight + (size_t)k * PARTICLE_BLOCK;
        for (int line = 0; line < 2; line++) { /* beyond the end: the next block's */
            rows_prefetch(index + PREFETCH + line * PARTICLE_BLOCK);
            rows_prefetch(weight + PREFETCH + line * PARTICLE_BLOCK);
        }
        even = real_fma(real_load(weight), lookup_load(t->direction, index), even);
        odd = real_fma(real_load(weight + PARTICLE_BLOCK),
                       lookup_load(t->direction, index + PARTICLE_BLOCK), odd);
    }
    if (k < row.length)
        even = real_fma(real_load(row.weight + (size_t)k * PARTICLE_BLOCK),
                        lookup_load(t->direction, row.index + (size_t)k * PARTICLE_BLOCK), even);
    real_store(out, even + odd);
    for (size_t l = 0; l < LANES && i + l < w->count; l++)
        t->product[i + l] = t->unknown[i + l].diagonal * t->direction[i + l] - settled(out[l]);
}

/* Velocity, acceleration and shift from the sums F (p_i - p_j) x of the three fields. */
static inline void slopes_store(const struct work *w, size_t k, const float sum[9])
{
    const struct projection_work *t = &w->projection;
    struct stencil stencil = t->stencil[k], *s = &stencil;
    struct motion motion = w->state.motion[k], *v = &motion;
    struct rate own = w->rate[k], *rate = &own;
    const struct trial trial = t->trial[k];
    float rest = w->choice->projection.reference, half = 0.5f * w->choice->each.h;
    float lighter = w->choice->projection.lighter[work_fluid(w, k)];
    float d[9], beyond[3], gradient[3][3];
    const float none[3] = {0, 0, 0};
    for (int a = 0; a < 9; a++)
        d[a] = half * settled(sum[a]);
    for (int a = 0; a < 3; a++)
        beyond[a] = w->scalars->before > 0 ? v->velocity[a] * (2 * rest / w->scalars->before) : 0;
    projection_gradient(s, lighter, trial.pressure - s->jump, d, beyond, gradient[0]);
    for (int a = 0; a < 3; a++)
        beyond[a] = rest * rate->acceleration[a];
    projection_gradient(s, lighter, trial.mean - s->jump, d + 3, beyond, gradient[1]);
    projection_gradient(s, lighter, trial.shift, d + 6, none, gradient[2]);
    projection_lift(&w->choice->each, gradient[2], s->crowd);
    float violent = t->violent[k], part;
    part = projection_trust(&w->choice->each, w->scalars->before, w->scalars->dt, gradient[0],
                            gradient[1], rest, &violent);
    t->surface[k] = violent;
    for (int a = 0; a < 3; a++) {
        rate->acceleration[a] -= part * gradient[1][a] / rest;
        v->velocity[a] += s->carried[a] + 0.5f * (w->scalars->dt * rate->acceleration[a] -
                                                  w->scalars->before / rest * gradient[0][a]);
    }
    rate->density = trial.shift;
    v->pressure = trial.mean;
    t->stencil[k] = stencil;
    w->state.motion[k] = motion;
    w->rate[k] = own;
}

FORCE_INLINE void slopes_sum(const struct work *w, size_t i)
{
    const struct projection_work *t = &w->projection;
    struct lane_row row = lane_row(w, i);
    real volume, own[4], zero = real_set(0);
    real sum[9] = {zero, zero, zero, zero, zero, zero, zero, zero, zero};
    struct lane_point point = point_load(w, i, &volume);
    float out[9][LANES];
    records_own(t->trial + i, own);
    for (uint32_t k = 0; k < row.length; k++) {
        const uint32_t *index = row.index + (size_t)k * PARTICLE_BLOCK;
        real other[4], trial[4], x[3];
        records_load(w->position, index, other);
        records_load(t->trial, index, trial);
        pair_distance(&point, other, x);
        pair_slopes(sum, x, own, trial, real_load(row.weight + (size_t)k * PARTICLE_BLOCK));
    }
    for (int a = 0; a < 9; a++)
        real_store(out[a], sum[a]);
    for (size_t l = 0; l < LANES && i + l < w->count; l++) {
        float one[9];
        for (int a = 0; a < 9; a++)
            one[a] = out[a][l];
        slopes_store(w, i + l, one);
    }
}
