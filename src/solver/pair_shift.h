/* Sums of particle shifting over pairs: how crowded a place is, how near a surface, and how the
 * fields change along the shift. Lanes as in solver/pair.h. */
#ifndef SOLVER_PAIR_SHIFT_H
#define SOLVER_PAIR_SHIFT_H

#include "solver/pair.h"

struct pair_shift {
    real cx, cy, cz;    /* sum of V_j [1 + R (W/W(d))^4] grad W */
    real place;         /* -sum of V_j x_ij . grad W: 3 inside, less near a surface */
    real number;        /* sum of w */
    real fast;          /* largest v_ij^2 */
    real ax, ay, az;    /* sum of V_j v_ji (u_i . grad W), u_i the shift velocity */
    real pressure;      /* sum of V_j p_ji (u_i . grad W) */
};

struct pair_shift_self {
    real vx, vy, vz, pressure;
    real ux, uy, uz; /* shift velocity so far */
    real crowd;      /* 1 / w(d) */
};

static inline __attribute__((always_inline)) real pair_larger(real a, real b)
{
    return b + real_positive(a - b);
}

/* Sun et al. 2017, eq. 7, and the rates of change along the shift (Sun et al. 2019). */
static inline __attribute__((always_inline)) void pair_shift(struct pair_shift *s, const struct pair_shift_self *i,
                               real volume, const real motion[4], const struct pair *p,
                               unsigned flags)
{
    real weight = volume * pair_slope(p, flags);
    real value = pair_value(p, flags), crowd = value * i->crowd, c2 = crowd * crowd;
    s->number = s->number + value;
    real push = weight * real_fma(real_set(0.2f) * c2, c2, real_set(1));
    real vx = motion[0] - i->vx, vy = motion[1] - i->vy, vz = motion[2] - i->vz;
    real along = weight * real_fma(i->uz, p->z, real_fma(i->uy, p->y, i->ux * p->x));
    s->cx = real_fma(push, p->x, s->cx);
    s->cy = real_fma(push, p->y, s->cy);
    s->cz = real_fma(push, p->z, s->cz);
    s->place = s->place - weight * p->q2;
    s->fast = pair_larger(s->fast, real_fma(vz, vz, real_fma(vy, vy, vx * vx)));
    s->ax = real_fma(along, vx, s->ax);
    s->ay = real_fma(along, vy, s->ay);
    s->az = real_fma(along, vz, s->az);
    s->pressure = real_fma(along, motion[3] - i->pressure, s->pressure);
}

#endif
