/* What the implicit solver's passes do to particle i, around solver/implicit.h. Common subset of C and
 * CUDA. */
#ifndef BACKEND_BODIES_EACH_IMPLICIT_H
#define BACKEND_BODIES_EACH_IMPLICIT_H

#include "backend/bodies/each_explicit.h"

/* The pressure that sweeps begin with, Pa, of a particle and as its neighbours read it. */
static inline void each_begin_pressure(const struct work *w, size_t i, float pressure)
{
    float volume = w->choice->implicit.volume[work_fluid(w, i)];
    w->state.motion[i].pressure = w->solve.warm[i].last = pressure;
    w->solve.load[i].volume = volume * pressure;
}

static inline void each_kick(const struct work *w, size_t i)
{
    const float *a = w->rate ? w->rate[i].acceleration : w->constants.gravity;
    for (int d = 0; d < 3; d++)
        w->state.motion[i].velocity[d] += w->scalars->dt * a[d];
    each_begin_pressure(w, i, w->state.motion0[i].pressure * (1 / w->choice->implicit.pressure));
}

static inline void each_resume(const struct work *w, size_t i)
{
    float dt = w->scalars->dt, part = w->scalars->resume / (dt * dt);
    struct warm *warm = &w->solve.warm[i];
    warm->velocity = w->state.motion[i].pressure;
    each_begin_pressure(w, i, part > 0 ? part * warm->shift : 0);
}

static inline void each_move(const struct work *w, size_t i, struct extremes *own)
{
    const struct implicit_constants *m = &w->choice->implicit;
    const struct explicit_constants *c = &w->choice->each;
    const struct state_work *s = &w->state;
    struct motion *v = &s->motion[i];
    struct warm *warm = &w->solve.warm[i];
    float dt = w->scalars->dt, v2 = 0, a2 = 0, one = 1 / m->volume[work_fluid(w, i)], shift[3];
    for (int d = 0; d < 3; d++)
        shift[d] = one * w->solve.flux[i].velocity[d] / w->solve.factor[i].along[d];
    implicit_bound(c, dt, shift);
    for (int d = 0; d < 3 && warm->velocity == 0; d++)
        shift[d] -= 0.5f * dt * w->constants.gravity[d]; /* falling freely: the mean velocity */
    float move2 = implicit_move(c, dt, &s->position0[i], shift, &s->position[i], v);
    warm->shift = v->pressure * (dt * dt);
    v->pressure = m->pressure * warm->velocity;
    for (int d = 0; d < 3; d++) {
        float a = (v->velocity[d] - s->motion0[i].velocity[d]) / dt;
        v2 += v->velocity[d] * v->velocity[d];
        a2 += a * a;
    }
    own->move2 = move2 > own->move2 ? move2 : own->move2;
    own->speed2 = v2 > own->speed2 ? v2 : own->speed2;
    own->acceleration2 = a2 > own->acceleration2 ? a2 : own->acceleration2;
    if (!(move2 <= each_farthest2(w)) || !(v2 < FLT_MAX) || !(v->pressure < FLT_MAX))
        each_bad(w, i, own);
}

/* Before the first step: what positions carry of rest volumes. */
static inline void each_rest_volumes(const struct work *w, size_t i)
{
    w->state.position[i].volume = w->choice->implicit.volume[work_fluid(w, i)];
}

/* The volume of a wall particle, V_b = 1 / sum_k W_bk over the wall particles (Akinci et al. 2012). Those
 * next to the fluid lack its half of the sum and become too large, by which fluid would stand off, most of
 * all at edges; a projection, and explicit solvers where there are obstacles, take the fluid's volume, so
 * that the lattice goes on in the wall. */
static inline void each_wall_volumes(const struct work *w, size_t i)
{
    const struct explicit_constants *c = &w->choice->each;
    bool lattice = c->obstacles.count > 0 && !w->choice->is_implicit;
    w->state.position[i].volume = w->choice->projects ? w->choice->projection.volume[0]
                                  : lattice           ? c->mass[0] / c->rest_density[0]
                                                      : 1 / (w->constants.density * w->number[i]);
}

/* A part of 1, in 2^-40; what is not a number counts 1. */
static inline int64_t fixed_part(float x)
{
    return (int64_t)((x < -1 ? -1 : x < 1 ? x : 1) * 0x1p40f);
}

static inline int64_t each_excess(const struct work *w, size_t i)
{
    return fixed_part(w->solve.factor[i].ratio - 1);
}

/* A mean over the particles from its fixed-point sum. */
static inline double scalar_fixed_mean(const struct work *w, int k)
{
    int64_t sum = w->scalars->sums.fixed[k];
    w->scalars->sums.fixed[k] = 0;
    return (double)sum * (0x1p-40 / work_particles(w));
}

/* The density ratio to aim at: where fluid fills the domain its mean cannot change. */
static inline void scalar_target(const struct work *w)
{
    double mean = (double)w->scalars->sums.fixed[0] * 0x1p-40 / work_particles(w);
    w->scalars->sums.fixed[0] = 0;
    w->scalars->target = 1;
    if (w->choice->enclosed)
        w->scalars->target += (float)mean;
}

static inline void scalar_swept(const struct work *w)
{
    struct scalars *s = w->scalars;
    double offset;
    s->residual = scalar_fixed_mean(w, 0);
    offset = scalar_fixed_mean(w, 1);
    s->offset = w->choice->enclosed && w->solve_of == SOLVE_VELOCITY ? (float)offset : 0;
}

/* Before the first sweep of a solve, and after each. */
static inline void scalar_loop_begins(const struct work *w)
{
    struct scalars *s = w->scalars;
    s->offset = 0;
    loop_begin(&s->loop);
    s->relax = (float)s->loop.relax;
    s->momentum = loop_momentum(&s->loop);
}

static inline void scalar_loop_goes_on(const struct work *w)
{
    struct scalars *s = w->scalars;
    loop_next(&s->loop, s->residual);
    s->relax = (float)s->loop.relax;
    s->momentum = loop_momentum(&s->loop);
}

#endif
