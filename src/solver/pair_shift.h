/* The pair sums of particle shifting (solver/shift.h); in lanes, like solver/pair.h. */
#ifndef SOLVER_PAIR_SHIFT_H
#define SOLVER_PAIR_SHIFT_H

#include "solver/pair.h"

struct pair_shifts {
    real x, y, z;    /* sum of V_j (1 + 0.2 (W/W(d))^4) W'/r x */
    real divergence; /* -sum of V_j W'/r x^2 */
    real speed2;     /* largest W/W(d) v_ij^2 */
    real surface;    /* largest l_j, fading where W/W(d) < 1/32, at about 2 d */
};

static inline __attribute__((always_inline)) real pair_larger(real a, real b)
{
    return b + real_positive(a - b);
}

/* `velocity` is v_j, `surface` l_j, and `closeness` 1/w(d). */
static inline __attribute__((always_inline)) void pair_shift(struct pair_shifts *s,
                              const struct pair *p, real volume, const real own[4],
                              const real velocity[4], real surface, real closeness, unsigned flags)
{
    real one = real_set(1), weight = volume * pair_slope(p, flags);
    real close = closeness * pair_value(p, flags), close2 = close * close;
    real push = weight * real_fma(real_set(0.2f) * close2, close2, one);
    real vx = velocity[0] - own[0], vy = velocity[1] - own[1], vz = velocity[2] - own[2];
    real v2 = real_fma(vz, vz, real_fma(vy, vy, vx * vx));
    real within = one - real_positive(one - real_set(32) * close);
    s->x = real_fma(push, p->x, s->x);
    s->y = real_fma(push, p->y, s->y);
    s->z = real_fma(push, p->z, s->z);
    s->divergence = s->divergence - weight * p->q2;
    s->speed2 = pair_larger(close * v2, s->speed2);
    s->surface = pair_larger(within * surface, s->surface);
}

#endif
