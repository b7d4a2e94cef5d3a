/* The pair sums of density diffusion by gradients (solver/diffusion.h); in lanes, like solver/pair.h. */
#ifndef SOLVER_PAIR_DIFFUSION_H
#define SOLVER_PAIR_DIFFUSION_H

#include "solver/diffusion.h"
#include "solver/pair_shift.h"

struct pair_gradients {
    real xx, xy, xz, yy, yz, zz; /* sum of V_j W'/r x x^T */
    real x, y, z;                /* sum of V_j W'/r (rho_i - rho_j) x */
};

/* `apart` is rho_i - rho_j. */
static inline __attribute__((always_inline)) void pair_gradient(struct pair_gradients *s,
                              const struct pair *p, real volume, real apart, unsigned flags)
{
    real weight = volume * pair_slope(p, flags), share = weight * apart;
    real x = weight * p->x, y = weight * p->y, z = weight * p->z;
    s->xx = real_fma(x, p->x, s->xx);
    s->xy = real_fma(x, p->y, s->xy);
    s->xz = real_fma(x, p->z, s->xz);
    s->yy = real_fma(y, p->y, s->yy);
    s->yz = real_fma(y, p->z, s->yz);
    s->zz = real_fma(z, p->z, s->zz);
    s->x = real_fma(share, p->x, s->x);
    s->y = real_fma(share, p->y, s->y);
    s->z = real_fma(share, p->z, s->z);
}

/* g h by the adjugate of M / trace M; `stiffness` is c^2. */
static inline __attribute__((always_inline)) void pair_gradient_solve(real g[3],
                              const struct pair_gradients *s, real stiffness)
{
    real zero = real_set(0), one = real_set(1), size = zero - (s->xx + s->yy + s->zz);
    real scale = real_set(-1) / pair_larger(size, real_set(1e-12f));
    real xx = s->xx * scale, xy = s->xy * scale, xz = s->xz * scale;
    real yy = s->yy * scale, yz = s->yz * scale, zz = s->zz * scale;
    real ax = yy * zz - yz * yz, ay = xz * yz - xy * zz, az = xy * yz - xz * yy;
    real by = xx * zz - xz * xz, bz = xy * xz - xx * yz, cz = xx * yy - xy * xy;
    real det = real_fma(xz, az, real_fma(xy, ay, xx * ax)), flat = real_set(GRADIENT_FLAT / 27);
    real part = (det - flat) * real_set(27 / (GRADIENT_ROUND - GRADIENT_FLAT));
    part = one - real_positive(one - real_positive(part));
    real front = part * stiffness * scale / pair_larger(det, flat);
    g[0] = front * real_fma(az, s->z, real_fma(ay, s->y, ax * s->x));
    g[1] = front * real_fma(bz, s->z, real_fma(by, s->y, ay * s->x));
    g[2] = front * real_fma(cz, s->z, real_fma(bz, s->y, az * s->x));
}

/* sum of V_j W'/r ((e_i - e_j) - (g_i + g_j).x_ij / 2); i and j are struct gradient. */
static inline __attribute__((always_inline)) void pair_diffusion(real *sum, const struct pair *p,
                              real volume, const real i[4], const real j[4], unsigned flags)
{
    real gx = i[0] + j[0], gy = i[1] + j[1], gz = i[2] + j[2];
    real twice = real_fma(gz, p->z, real_fma(gy, p->y, gx * p->x));
    real left = real_fma(real_set(-0.5f), twice, i[3] - j[3]);
    *sum = real_fma(volume * pair_slope(p, flags), left, *sum);
}

#endif
