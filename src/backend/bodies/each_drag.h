/* What conjugate gradients of implicit viscosity do to particle i, around the matrix products
 * (solver/drag.h). Inner products are weighted by mass. Common subset of C and CUDA. */
#ifndef BACKEND_BODIES_EACH_DRAG_H
#define BACKEND_BODIES_EACH_DRAG_H

#include "backend/work.h"

static inline double each_mass(const struct work *w, size_t i)
{
    return (double)w->choice->each.mass[work_fluid(w, i)];
}

static inline struct drag_block *each_drag_block(const struct work *w, size_t i)
{
    return w->solve.block ? &w->solve.block[i] : NULL;
}

static inline struct drag each_conditioned(const struct work *w, size_t i)
{
    return drag_conditioned(&w->solve.remainder[i], &w->solve.product[i], each_drag_block(w, i));
}

static inline void each_drag_begin(const struct work *w, size_t i)
{
    drag_begin(&w->choice->each, work_fluid(w, i), w->scalars->dt, &w->position[i],
               &w->state.motion[i], &w->solve.search[i], &w->solve.remainder[i],
               each_drag_block(w, i));
}

/* Sums of the residual's squares, preconditioned, of the velocities' and of the residual's. */
static inline void each_drag_residual(const struct work *w, size_t i, double term[SCALAR_SUMS])
{
    struct drag *r = &w->solve.remainder[i], *search = &w->solve.search[i], z;
    double mass = each_mass(w, i);
    term[1] = mass * drag_speed2(w->scalars->dt, search, r, each_drag_block(w, i));
    for (int a = 0; a < 3; a++)
        r->along[a] -= w->solve.product[i].along[a];
    z = each_conditioned(w, i);
    term[2] = mass * drag_dot(r, r);
    term[0] = mass * drag_dot(r, &z);
    for (int a = 0; a < 3; a++)
        search->along[a] = z.along[a];
}

/* Takes a sum over particles. */
static inline double scalar_sum(const struct work *w, int k)
{
    struct exact_sum *sum = &w->scalars->sums.exact[k], none = {{0}, 0};
    double value = exact_value(sum);
    *sum = none;
    return value;
}

/* Residuals are relative to the velocities or to the first residual, which is the change by
 * viscosity, whichever is less; but not to less than rounding leaves. */
static inline void scalar_drag_residual_found(const struct work *w)
{
    double speed2, first;
    w->scalars->product = scalar_sum(w, 0);
    speed2 = scalar_sum(w, 1);
    first = scalar_sum(w, 2);
    w->scalars->scale2 = fmax(fmin(speed2, first), 1e-6 * speed2);
}

/* search . M search */
static inline void each_drag_curvature(const struct work *w, size_t i, double term[SCALAR_SUMS])
{
    term[0] = each_mass(w, i) * drag_dot(&w->solve.search[i], &w->solve.product[i]);
}

/* How far to go along a direction that conjugate gradients minimise along; sums that are not finite make
 * velocities so, and the step is rejected when particles move. */
static inline float scalar_length(double square, double curvature)
{
    return (float)(curvature > 0 ? square / curvature : curvature <= 0 ? 0 : (double)NAN);
}

static inline void scalar_drag_length(const struct work *w)
{
    w->scalars->length = scalar_length(w->scalars->product, scalar_sum(w, 0));
}

/* Goes ahead; sums the residual's squares, preconditioned and not. */
static inline void each_drag_ahead(const struct work *w, size_t i, double term[SCALAR_SUMS])
{
    const float length = w->scalars->length;
    struct drag *r = &w->solve.remainder[i], z;
    for (int a = 0; a < 3; a++) {
        w->state.motion[i].velocity[a] += length * w->solve.search[i].along[a];
        r->along[a] -= length * w->solve.product[i].along[a];
    }
    z = each_conditioned(w, i);
    term[0] = each_mass(w, i) * drag_dot(r, &z);
    term[1] = each_mass(w, i) * drag_dot(r, r);
}

static inline void scalar_drag_keep(const struct work *w)
{
    struct scalars *s = w->scalars;
    double next = scalar_sum(w, 0), square = scalar_sum(w, 1);
    s->keep = s->product > 0 ? (float)(next / s->product) : 0;
    s->product = next;
    s->residual = square == 0 ? 0 : sqrt(square / s->scale2);
}

static inline void each_drag_turn(const struct work *w, size_t i)
{
    struct drag z = each_conditioned(w, i), *search = &w->solve.search[i];
    for (int a = 0; a < 3; a++)
        search->along[a] = z.along[a] + w->scalars->keep * search->along[a];
}

/* v + r = v* + dt (A v + pull): the forces of pairs, as explicit steps add them, cancel in momentum and
 * what they keep of angular momentum; the residual alone would not. */
static inline void each_drag_end(const struct work *w, size_t i)
{
    for (int a = 0; a < 3; a++)
        w->state.motion[i].velocity[a] += w->solve.remainder[i].along[a];
}

#endif
