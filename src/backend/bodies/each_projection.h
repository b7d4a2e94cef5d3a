/* What the projection solver's passes do to particle i, around solver/projection.h, with the conjugate
 * gradients of its two equations. Common subset of C and CUDA. */
#ifndef BACKEND_BODIES_EACH_PROJECTION_H
#define BACKEND_BODIES_EACH_PROJECTION_H

#include "backend/bodies/each_drag.h"
#include "backend/bodies/each_explicit.h"

static inline void each_rewind(const struct work *w, size_t i)
{
    const struct state_work *s = &w->state;
    const float half = 0.5f * w->scalars->before;
    const struct rate rate0 = s->rate0[i];
    struct motion motion = s->motion0[i];
    struct rate rate = w->rate[i];
    for (int a = 0; a < 3; a++) {
        motion.velocity[a] -= half * rate0.acceleration[a];
        rate.acceleration[a] = w->constants.gravity[a];
    }
    s->motion[i] = motion;
    w->rate[i] = rate;
    w->projection.direction[i] = w->scalars->resume * rate0.density;
}

static inline void each_advance(const struct work *w, size_t i)
{
    const float half = 0.5f * w->scalars->before;
    const struct rate rate = w->rate[i];
    struct motion motion = w->state.motion[i];
    for (int a = 0; a < 3; a++)
        motion.velocity[a] += half * rate.acceleration[a];
    w->state.motion[i] = motion;
}

/* Means over the particles; only where fluid is enclosed. */
static inline void each_lack(const struct work *w, size_t i, double term[SCALAR_SUMS])
{
    term[0] = (double)w->projection.stencil[i].lack;
}
static inline void scalar_crowding_mean(const struct work *w)
{
    w->scalars->mean = -(float)(scalar_sum(w, 0) / work_particles(w));
}
static inline void each_left(const struct work *w, size_t i, double term[SCALAR_SUMS])
{
    term[0] = (double)w->projection.unknown[i].residual;
}
static inline void scalar_residual_mean(const struct work *w)
{
    w->scalars->mean = (float)(scalar_sum(w, 0) / work_particles(w));
}

static inline void each_crowding(const struct work *w, size_t i)
{
    const struct scalars *s = w->scalars;
    const struct stencil stencil = w->projection.stencil[i];
    struct unknown unknown = w->projection.unknown[i];
    struct trial trial = w->projection.trial[i];
    projection_pressures(&w->choice->projection, w->choice->each.h, &stencil, s->mean, s->before,
                         w->state.motion[i].pressure, s->resume * w->state.rate0[i].density, &unknown, &trial);
    w->projection.unknown[i] = unknown;
    w->projection.trial[i] = trial;
}

/* Keeps the solution of the equation of the shift for the slopes. */
static inline void each_shifted(const struct work *w, size_t i)
{
    w->projection.trial[i].shift = w->projection.unknown[i].value;
}

/* Residuals as a solve's tolerance counts them. */
static inline double scalar_residual_scale(const struct work *w)
{
    const struct projection_constants *c = &w->choice->projection;
    double n = work_particles(w), dt = (double)w->scalars->before;
    if (w->solve_of == SOLVE_SHIFT)
        return 1 / ((double)c->gain * n);
    return dt * dt / (2 * (double)c->reference * n);
}

/* The residual's square and size, of a row that is no longer touched. */
static inline void each_row_left(const struct unknown *u, double term[SCALAR_SUMS])
{
    term[0] = (double)u->residual * (double)(u->residual * u->inverse);
    term[1] = fabs((double)u->residual);
}

/* Where nothing is fixed the pressure is known but for a constant: the residual has no mean. */
static inline void each_residual(const struct work *w, size_t i, double term[SCALAR_SUMS])
{
    struct unknown u = w->projection.unknown[i];
    u.residual = u.inverse > 0 ? u.residual - w->scalars->mean : 0;
    w->projection.unknown[i] = u;
    w->projection.direction[i] = u.residual * u.inverse;
    each_row_left(&u, term);
}

static inline void scalar_residual_found(const struct work *w)
{
    w->scalars->descent = scalar_sum(w, 0);
    w->scalars->residual = scalar_sum(w, 1) * scalar_residual_scale(w);
}

/* direction . matrix . direction */
static inline void each_curvature(const struct work *w, size_t i, double term[SCALAR_SUMS])
{
    term[0] = (double)w->projection.direction[i] * (double)w->projection.product[i];
}

static inline void scalar_descent_length(const struct work *w)
{
    w->scalars->length = scalar_length(w->scalars->descent, scalar_sum(w, 0));
}

static inline void each_ahead(const struct work *w, size_t i, double term[SCALAR_SUMS])
{
    const float length = w->scalars->length;
    struct unknown u = w->projection.unknown[i];
    u.value += length * w->projection.direction[i];
    u.residual = u.inverse > 0 ? u.residual - length * w->projection.product[i] : 0;
    w->projection.unknown[i] = u;
    each_row_left(&u, term);
}

static inline void scalar_descent_keep(const struct work *w)
{
    struct scalars *s = w->scalars;
    double before = s->descent;
    s->descent = scalar_sum(w, 0);
    s->keep = before > 0 ? (float)(s->descent / before) : 0;
    s->residual = scalar_sum(w, 1) * scalar_residual_scale(w);
}

static inline void each_turn(const struct work *w, size_t i)
{
    const struct unknown u = w->projection.unknown[i];
    float *direction = &w->projection.direction[i];
    *direction = u.residual * u.inverse + w->scalars->keep * *direction;
}

static inline void each_drift(const struct work *w, size_t i, struct extremes *own)
{
    const struct state_work *s = &w->state;
    const struct stencil stencil = w->projection.stencil[i];
    const struct position x0 = s->position0[i];
    const struct rate rate = w->rate[i];
    struct position x = x0;
    struct motion v = s->motion[i];
    float move2 = projection_move(&w->choice->each, w->scalars->dt, &x0, rate.acceleration, stencil.crowd, &x, &v);
    float v2 = each_square(v.velocity), a2 = each_square(rate.acceleration);
    s->position[i] = x;
    s->motion[i] = v;
    own->move2 = move2 > own->move2 ? move2 : own->move2;
    own->speed2 = v2 > own->speed2 ? v2 : own->speed2;
    own->acceleration2 = a2 > own->acceleration2 ? a2 : own->acceleration2;
    if (!(move2 <= each_farthest2(w)) || !(v2 < FLT_MAX) || !(fabsf(v.pressure) < FLT_MAX))
        each_bad(w, i, own);
}

#endif
