/* The pair sums of surface tension (solver/tension.h); in lanes, like solver/pair.h. */
#ifndef SOLVER_PAIR_TENSION_H
#define SOLVER_PAIR_TENSION_H

#include "solver/pair.h"

/* 1 where both fluids are the same, otherwise 0; fluids are whole numbers. */
static inline __attribute__((always_inline)) real pair_same(real a, real b)
{
    real apart = a - b;
    return real_positive(real_set(1) - apart * apart);
}

/* sum V_j W'/r x. */
static inline __attribute__((always_inline)) void pair_normal(real sum[3], const struct pair *p,
                                                              real volume)
{
    real weight = volume * wendland_slope(p->q);
    sum[0] = real_fma(weight, p->x, sum[0]);
    sum[1] = real_fma(weight, p->y, sum[1]);
    sum[2] = real_fma(weight, p->z, sum[2]);
}

/* sum V_j s_j W'/r (n_j - n_i).x and sum V_j s_j W'/r (x^2 - (n_i.x)^2); i and j are struct normal. */
static inline __attribute__((always_inline)) void pair_curvature(real sum[2], const struct pair *p,
                                                                 real volume, const real i[4],
                                                                 const real j[4])
{
    real weight = (volume * j[3]) * wendland_slope(p->q);
    real own = real_fma(i[2], p->z, real_fma(i[1], p->y, i[0] * p->x));
    real other = real_fma(j[2], p->z, real_fma(j[1], p->y, j[0] * p->x));
    sum[0] = real_fma(weight, other - own, sum[0]);
    sum[1] = real_fma(weight, p->q2 - own * own, sum[1]);
}

#endif
