/* The pair sums of the projection solver (solver/projection.h); in lanes, like solver/pair.h.
 *
 * The kernel is evaluated once a step, in the stencil; later passes read its F_ij from the row, from
 * which V_j grad W = -F_ij (x_i - x_j)/2 follows. */
#ifndef SOLVER_PAIR_PROJECTION_H
#define SOLVER_PAIR_PROJECTION_H

#include "solver/pair_shift.h"

struct pair_stencils {
    real number, weight;
    real toward[3], crowd[3];
    real moment[6]; /* xx yy zz xy xz yz */
};

/* Adds a neighbour; returns F_ij. */
static inline __attribute__((always_inline)) real pair_stencil(struct pair_stencils *s,
                              const struct pair *p, real volume, real closeness, real laplacian,
                              unsigned flags)
{
    real weight = volume * pair_slope(p, flags), value = pair_value(p, flags);
    real close = closeness * value, close2 = close * close;
    real push = weight * real_fma(real_set(0.2f) * close2, close2, real_set(1));
    real wx = weight * p->x, wy = weight * p->y, wz = weight * p->z, f = laplacian * weight;
    s->number = real_fma(volume, value, s->number);
    s->toward[0] = s->toward[0] + wx;
    s->toward[1] = s->toward[1] + wy;
    s->toward[2] = s->toward[2] + wz;
    s->crowd[0] = real_fma(push, p->x, s->crowd[0]);
    s->crowd[1] = real_fma(push, p->y, s->crowd[1]);
    s->crowd[2] = real_fma(push, p->z, s->crowd[2]);
    s->moment[0] = real_fma(wx, p->x, s->moment[0]);
    s->moment[1] = real_fma(wy, p->y, s->moment[1]);
    s->moment[2] = real_fma(wz, p->z, s->moment[2]);
    s->moment[3] = real_fma(wx, p->y, s->moment[3]);
    s->moment[4] = real_fma(wx, p->z, s->moment[4]);
    s->moment[5] = real_fma(wy, p->z, s->moment[5]);
    s->weight = s->weight + f;
    return f;
}

/* 2 R / (rho_i + rho_j) from the inverse densities, and its inverse. */
static inline __attribute__((always_inline)) real pair_share(real reference, real own, real other)
{
    return real_set(2) * reference * (own * other) / (own + other);
}
static inline __attribute__((always_inline)) real pair_unshare(real reference, real own, real other)
{
    return real_set(0.5f) * (own + other) / (reference * (own * other));
}

/* Sums F (u_i - u_j)_a x_b, F (u_i - u_j) and F p_j, and the largest F |u_ij|^2; `plain` is F without the share of
 * densities. */
struct pair_flows {
    real tensor[9], stray[3], around, speed2;
};

static inline __attribute__((always_inline)) void pair_flow(struct pair_flows *s,
                              const real x[3], const real own[4], const real other[4], real f, real plain)
{
    real u = own[0] - other[0], v = own[1] - other[1], w = own[2] - other[2];
    real square = real_fma(w, w, real_fma(v, v, u * u));
    real fx = plain * x[0], fy = plain * x[1], fz = plain * x[2];
    s->tensor[0] = real_fma(fx, u, s->tensor[0]);
    s->tensor[1] = real_fma(fy, u, s->tensor[1]);
    s->tensor[2] = real_fma(fz, u, s->tensor[2]);
    s->tensor[3] = real_fma(fx, v, s->tensor[3]);
    s->tensor[4] = real_fma(fy, v, s->tensor[4]);
    s->tensor[5] = real_fma(fz, v, s->tensor[5]);
    s->tensor[6] = real_fma(fx, w, s->tensor[6]);
    s->tensor[7] = real_fma(fy, w, s->tensor[7]);
    s->tensor[8] = real_fma(fz, w, s->tensor[8]);
    s->stray[0] = real_fma(plain, u, s->stray[0]);
    s->stray[1] = real_fma(plain, v, s->stray[1]);
    s->stray[2] = real_fma(plain, w, s->stray[2]);
    s->around = real_fma(f, other[3], s->around);
    s->speed2 = pair_larger(plain * square, s->speed2);
}

/* sum F (p_i - p_j) x of the three fields of struct trial. */
static inline __attribute__((always_inline)) void pair_slopes(real sum[9], const real x[3],
                              const real own[4], const real other[4], real f)
{
    real fx = f * x[0], fy = f * x[1], fz = f * x[2];
    real p = own[0] - other[0], q = own[1] - other[1], r = own[2] - other[2];
    sum[0] = real_fma(fx, p, sum[0]);
    sum[1] = real_fma(fy, p, sum[1]);
    sum[2] = real_fma(fz, p, sum[2]);
    sum[3] = real_fma(fx, q, sum[3]);
    sum[4] = real_fma(fy, q, sum[4]);
    sum[5] = real_fma(fz, q, sum[5]);
    sum[6] = real_fma(fx, r, sum[6]);
    sum[7] = real_fma(fy, r, sum[7]);
    sum[8] = real_fma(fz, r, sum[8]);
}

#endif
