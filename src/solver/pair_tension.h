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

/* How far h |grad c| is that of a surface: 0 below a, 1 above b; `scale` is 1/(b^2 - a^2), `low` a^2. */
static inline __attribute__((always_inline)) real pair_surface(real size, real low, real scale)
{
    real u = real_positive((size * size - low) * scale);
    return real_set(1) - real_positive(real_set(1) - u);
}

/* sum V_j grad W. */
static inline __attribute__((always_inline)) void pair_normal(real sum[3], const struct pair *p,
                                                              real volume, unsigned flags)
{
    real weight = volume * pair_slope(p, flags);
    sum[0] = real_fma(weight, p->x, sum[0]);
    sum[1] = real_fma(weight, p->y, sum[1]);
    sum[2] = real_fma(weight, p->z, sum[2]);
}

/* Over neighbours at a surface, of weight V_j s_j: sum W'/r (n_i - n_j).x and
 * sum W'/r (x^2 - (n_i.x)^2). i and j begin with n. */
static inline __attribute__((always_inline)) void pair_curvature(real sum[2], const struct pair *p,
                                                                 real weight, const real i[4],
                                                                 const real j[4], unsigned flags)
{
    real own = real_fma(i[2], p->z, real_fma(i[1], p->y, i[0] * p->x));
    real other = real_fma(j[2], p->z, real_fma(j[1], p->y, j[0] * p->x));
    weight = weight * pair_slope(p, flags);
    sum[0] = real_fma(weight, own - other, sum[0]);
    sum[1] = real_fma(weight, p->q2 - own * own, sum[1]);
}

/* The same neighbours: sum W, sum W kappa_j. */
static inline __attribute__((always_inline)) void pair_tension(real sum[2], const struct pair *p,
                                                               real weight, real curvature,
                                                               unsigned flags)
{
    weight = weight * pair_value(p, flags);
    sum[0] = sum[0] + weight;
    sum[1] = real_fma(weight, curvature, sum[1]);
}

/* sum V_j (s_i + s_j) W'/r (v_ij.x) x/r^2. */
static inline __attribute__((always_inline)) void pair_ripple(real sum[3], const struct pair *p,
                                                              real weight, const real i[4],
                                                              const real j[4], unsigned flags)
{
    real vx = i[0] - j[0], vy = i[1] - j[1], vz = i[2] - j[2];
    real dot = real_fma(vz, p->z, real_fma(vy, p->y, vx * p->x)) * p->inverse;
    real drag = (weight * pair_slope(p, flags)) * (dot * p->inverse);
    sum[0] = real_fma(drag, p->x, sum[0]);
    sum[1] = real_fma(drag, p->y, sum[1]);
    sum[2] = real_fma(drag, p->z, sum[2]);
}

#endif
