/* What the explicit solvers' passes do to particle i, around solver/explicit.h. Common subset of C and
 * CUDA. */
#ifndef BACKEND_BODIES_EACH_EXPLICIT_H
#define BACKEND_BODIES_EACH_EXPLICIT_H

#include "backend/work.h"

#include <float.h>

static inline float each_square(const float v[3])
{
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

/* Notes a particle that moved too far or has values that are not finite. */
static inline void each_bad(const struct work *w, size_t i, struct extremes *own)
{
    own->bad = w->id[i] < own->bad ? w->id[i] : own->bad;
}

/* The square of half a spacing, m^2: no particle moves farther in a step. */
static inline float each_farthest2(const struct work *w)
{
    float spacing = w->choice->each.spacing;
    return 0.25f * spacing * spacing;
}

static inline void each_predict(const struct work *w, size_t i, struct extremes *own)
{
    const struct state_work *s = &w->state;
    const struct position x0 = s->position0[i];
    const struct motion v0 = s->motion0[i];
    const struct rate rate0 = s->rate0[i];
    struct position x = x0;
    struct motion v = v0;
    float density = 0;
    float move2 = explicit_predict(&w->choice->each, work_fluid(w, i), w->scalars->dt, &x0, &v0, &rate0,
                                   s->density0[i], w->shift ? w->shift[i].velocity : NULL, &x, &v, &density);
    s->position[i] = x;
    s->motion[i] = v;
    s->density[i] = density;
    own->move2 = move2 > own->move2 ? move2 : own->move2;
    if (!(move2 <= each_farthest2(w)) || !(density > 0))
        each_bad(w, i, own);
}

/* Adds to what predict found. */
static inline void each_correct(const struct work *w, size_t i, struct extremes *own)
{
    const struct state_work *s = &w->state;
    const struct explicit_constants *c = &w->choice->each;
    const struct rate rate0 = s->rate0[i], rate = w->rate[i];
    struct motion v = s->motion[i];
    float density = s->density[i];
    explicit_correct(c, w->scalars->dt, &rate0, &rate, &v, &density);
    s->motion[i] = v;
    s->density[i] = density;
    float v2 = each_square(v.velocity), a2 = each_square(rate.acceleration);
    float ratio = density / c->rest_density[work_fluid(w, i)];
    own->speed2 = v2 > own->speed2 ? v2 : own->speed2;
    own->acceleration2 = a2 > own->acceleration2 ? a2 : own->acceleration2;
    if (!(v2 < FLT_MAX) || !(a2 < FLT_MAX) || !(ratio > 0.05f && ratio < 20))
        each_bad(w, i, own);
}

static inline void each_pressure(const struct work *w, size_t i)
{
    const struct state_work *s = &w->state;
    const struct explicit_constants *c = &w->choice->each;
    struct position *x = &s->position[i];
    int fluid = work_fluid(w, i);
    if (!w->choice->continuity)
        s->density[i] = explicit_summed_density(c, fluid, x, w->number[i]);
    explicit_state(c, fluid, s->density[i], &s->motion[i].pressure, &x->volume);
}

static inline void each_walls(const struct work *w, size_t i)
{
    const struct state_work *s = &w->state;
    const struct explicit_constants *c = &w->choice->each;
    bool pushes = !(w->choice->flags & PAIR_DRAG_ONLY);
    const struct position x = w->position[i];
    const struct motion v = s->motion[i];
    struct rate rate = w->rate[i];
    int fluid = work_fluid(w, i);
    explicit_walls(c, fluid, &x, &v, pushes ? s->density[i] : c->rest_density[fluid], pushes,
                   w->shift ? 1 - w->shift[i].deep : 1, &rate);
    w->rate[i] = rate;
}

/* Adds to the rate, or begins it with gravity. */
static inline void each_external(const struct work *w, size_t i)
{
    const struct solver_choice *c = w->choice;
    const float *gravity = w->constants.gravity;
    float dt = c->is_implicit && !c->projects ? w->scalars->dt : 0;
    struct rate *rate = &w->rate[i];
    if (c->starts_rate) {
        for (int a = 0; a < 3; a++)
            rate->acceleration[a] = gravity[a];
        rate->density = 0;
    }
    if (c->external.any)
        external_rate(&c->external, work_fluid(w, i), dt, &w->position[i], &w->state.motion[i],
                      rate);
}

/* What lanes look up, in the present order of the particles. */
static inline void each_rest_densities(const struct work *w, size_t i)
{
    if (w->rest)
        w->rest[i] = w->choice->each.rest_density[work_fluid(w, i)];
}
static inline void each_inverse_densities(const struct work *w, size_t i)
{
    if (w->inverse_density)
        w->inverse_density[i] = 1 / w->choice->each.rest_density[work_fluid(w, i)];
}
static inline void each_fluids(const struct work *w, size_t i)
{
    if (w->tension.fluid)
        w->tension.fluid[i] = (float)work_fluid(w, i);
}

static inline void scalar_no_extremes(const struct work *w)
{
    struct extremes none = {0, 0, 0, UINT32_MAX};
    w->scalars->extremes = none;
}

#endif
