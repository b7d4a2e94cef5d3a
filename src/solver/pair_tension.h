/* The pair sums of surface tension (solver/tension.h); like solver/pair.h in lanes. */
#ifndef SOLVER_PAIR_TENSION_H
#define SOLVER_PAIR_TENSION_H

#include "solver/pair.h"

/* 1 where both fluids are the same, otherwise 0; fluids are whole numbers. */
static inline __attribute__((always_inline)) real pair_same(real a, real b)
{
    real apart = a - b;
    return real_positive(real_set(1) - apart * apart);
}

static inline __attribute__((always_inline)) real tension_slope(const struct pair *p)
{
    real u = real_set(0.5f) * p->q, t = real_positive(real_set(1) - u), ut = u * t;
#if TSHAPE == 1
    return real_set(0) - u * (ut * ut);
#elif TSHAPE == 2
    return real_set(0) - t * t * u;
#elif TSHAPE == 3
    return real_set(0) - u * ut;
#else
    return real_set(0) - ut * ut;
#endif
}

/* sum V_j grad W. */
static inline __attribute__((always_inline)) void pair_normal(real sum[3], const struct pair *p,
                                                              real volume)
{
    real weight = volume * tension_slope(p);
    sum[0] = real_fma(weight, p->x, sum[0]);
    sum[1] = real_fma(weight, p->y, sum[1]);
    sum[2] = real_fma(weight, p->z, sum[2]);
}

/* sum V_j (T_i + T_j) grad W, T = m (1 - n n); i and j are n and m. */
static inline __attribute__((always_inline)) void pair_tension(real sum[3], const struct pair *p,
                                                               real volume, const real i[4],
                                                               const real j[4])
{
    real weight = volume * tension_slope(p);
    real along_i = real_fma(i[2], p->z, real_fma(i[1], p->y, i[0] * p->x)) * i[3];
    real along_j = real_fma(j[2], p->z, real_fma(j[1], p->y, j[0] * p->x)) * j[3];
    real both = i[3] + j[3];
    sum[0] = real_fma(weight, both * p->x - (along_i * i[0] + along_j * j[0]), sum[0]);
    sum[1] = real_fma(weight, both * p->y - (along_i * i[1] + along_j * j[1]), sum[1]);
    sum[2] = real_fma(weight, both * p->z - (along_i * i[2] + along_j * j[2]), sum[2]);
}

#endif
