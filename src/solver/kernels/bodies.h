/* Bodies of the kernels for the pair passes, in the common subset of C and CUDA.
 *
 * `real` is a float or a vector of lanes; real_* are the few operations that operators do not give.
 * Each returns zero beyond the support by truncated powers, without a branch. slope is w'(q)/q,
 * finite at q = 0; `inverse` is 1/q (any finite number at q = 0). */
#ifndef SOLVER_KERNELS_BODIES_H
#define SOLVER_KERNELS_BODIES_H

#include "solver/pair_constants.h"

/* Cubic spline (Monaghan & Lattanzio 1985): w = [(2-q)^3 - 4 (1-q)^3] / 4. */
static inline __attribute__((always_inline)) real cubic_value(real q)
{
    real a = real_positive(real_set(2) - q), b = real_positive(real_set(1) - q);
    return real_set(0.25f) * (a * a * a - real_set(4) * (b * b * b));
}

static inline __attribute__((always_inline)) real cubic_slope(real q, real inverse)
{
    real a = real_positive(real_set(2) - q), b = real_positive(real_set(1) - q);
    return (real_set(-0.75f) * inverse) * real_fma(a, a, real_set(-4) * (b * b));
}

/* Wendland C2 (Wendland 1995): w = (1 - q/2)^4 (1 + 2q), w'/q = -5 (1 - q/2)^3. */
static inline __attribute__((always_inline)) real wendland_value(real q)
{
    real t = real_positive(real_fma(q, real_set(-0.5f), real_set(1)));
    real t2 = t * t;
    return t2 * t2 * real_fma(q, real_set(2), real_set(1));
}

static inline __attribute__((always_inline)) real wendland_slope(real q)
{
    real t = real_positive(real_fma(q, real_set(-0.5f), real_set(1)));
    return (real_set(-5) * t) * (t * t);
}

/* Mueller et al. 2003, eqs. 20-22, with support radius 2h and u = q/2, over poly6's sigma
 * 315 / (512 pi): poly6 w = (1 - u^2)^3; spiky w'/q = -(32/7) (1-u)^2 / q; h^2 lap w of the
 * viscosity kernel = (16/7) (1-u). */
static inline __attribute__((always_inline)) real poly6_value(real q2)
{
    real t = real_positive(real_fma(q2, real_set(-0.25f), real_set(1)));
    return t * t * t;
}

static inline __attribute__((always_inline)) real spiky_slope(real q, real inverse)
{
    real t = real_positive(real_fma(q, real_set(-0.5f), real_set(1)));
    return (real_set(-32.0f / 7.0f) * inverse) * (t * t);
}

static inline __attribute__((always_inline)) real viscosity_laplacian(real q)
{
    return real_set(16.0f / 7.0f) * real_positive(real_fma(q, real_set(-0.5f), real_set(1)));
}

#endif
