/* The pair interactions of all explicit solvers: particle i, particle j, and i's sums.
 *
 * In the common subset of C and CUDA: `real` is a float or a vector of lanes, one particle a lane.
 * Lengths are in units of the smoothing length h, volumes in units of d^3; the constants in front of
 * the sums are applied once per particle (solver/pair_constants.h). Every term is exactly zero for
 * a pair beyond the support and for a particle with itself, so lists may hold more than needed. */
#ifndef SOLVER_PAIR_H
#define SOLVER_PAIR_H

#include "solver/kernels/bodies.h"
#include "solver/pair_constants.h"

#include <stdbool.h>

/* Geometry of a pair: (x_i - x_j)/h, its square, length q, and 1/q. */
struct pair {
    real x, y, z, q2, q, inverse;
};

/* What is read of a particle. */
struct pair_state {
    real volume, vx, vy, vz, pressure, viscosity;
    real rest;           /* rest density; only with PAIR_MIXED */
    real own, wall;      /* only of i: its pressure as the sum p_i + p_j has it, and a wall's */
    real inverse_volume; /* only of i, only with PAIR_SYMMETRIC */
};

/* struct pair_constants, and i's share of them, in lanes. */
struct pair_lane_constants {
    real viscosity, inverse_h, central, artificial;
    real head_x, head_y, head_z; /* rho0_i g h, Pa: hydrostatic difference per unit of q */
};

/* The sums that i collects. */
struct pair_sums {
    real a[3];       /* sum of V_j (...) gradient */
    real divergence; /* sum V_j v_ij . gradient */
    real diffusion;  /* sum V_j psi_ij . gradient */
};

static inline __attribute__((always_inline)) real pair_slope(const struct pair *p, unsigned flags)
{
    if (flags & PAIR_MULLER)
        return spiky_slope(p->q, p->inverse);
    return flags & KERNEL_CUBIC ? cubic_slope(p->q, p->inverse) : wendland_slope(p->q);
}

static inline __attribute__((always_inline)) real pair_value(const struct pair *p, unsigned flags)
{
    if (flags & PAIR_MULLER)
        return poly6_value(p->q2);
    return flags & KERNEL_CUBIC ? cubic_value(p->q) : wendland_value(p->q);
}

/* Number density sum_j W_ij (Hu & Adams 2006): rho_i = m_i times it. */
static inline __attribute__((always_inline)) void pair_density(real *sum, const struct pair *p, real weight,
                                                               unsigned flags)
{
    *sum = real_fma(weight, pair_value(p, flags), *sum);
}

/* p_i + p_j where rest densities differ: twice the pressure midway at which p falls by the same g in
 * both, 2 (rho_j p_i + rho_i p_j)/(rho_i + rho_j) (Hu & Adams 2007). */
static inline __attribute__((always_inline)) real pair_pressure(const struct pair_state *i,
                              const struct pair_state *j, unsigned flags)
{
    if (!(flags & PAIR_MIXED))
        return i->own + j->pressure;
    real both = real_fma(j->rest, i->own, i->rest * j->pressure);
    return (both + both) / (i->rest + j->rest);
}

/* Harmonic mean of the rest densities: of light and heavy, about twice the light one. */
static inline __attribute__((always_inline)) real pair_harmonic(const struct pair_state *i,
                              const struct pair_state *j)
{
    real product = i->rest * j->rest;
    return (product + product) / (i->rest + j->rest);
}

/* 1 between particles of one rest density, 0 otherwise: density diffuses in one fluid only. */
static inline __attribute__((always_inline)) real pair_alike(const struct pair_state *i,
                              const struct pair_state *j)
{
    real apart = real_positive(i->rest - j->rest) + real_positive(j->rest - i->rest);
    return real_positive(real_fma(apart, real_set(-1e12f), real_set(1)));
}

/* Adds `weight` v (Morris et al. 1997) or, with PAIR_CENTRAL, `central` times (v . x) x, in which a pair
 * counts q^2 times as much as in Weiler et al. 2018 (and Monaghan & Gingold 1983): without it the lattice
 * resists shear along its axes by 11 to 30 % too little. With v = v_ij the latter is 0 for any motion of
 * a rigid body: it keeps angular momentum and leaves a surface free of stress. A mix, Morris's where no
 * surface is near, would be symmetric, too, but brakes rotation where the two meet. */
static inline __attribute__((always_inline)) void pair_viscosity(real sum[3], const struct pair *p, real weight,
                                                                 const real v[3], real central,
                                                                 unsigned flags)
{
    if (flags & PAIR_CENTRAL) {
        real dot = real_fma(v[2], p->z, real_fma(v[1], p->y, v[0] * p->x));
        real along = central * weight * dot;
        sum[0] = real_fma(along, p->x, sum[0]);
        sum[1] = real_fma(along, p->y, sum[1]);
        sum[2] = real_fma(along, p->z, sum[2]);
    } else {
        for (int a = 0; a < 3; a++)
            sum[a] = real_fma(weight, v[a], sum[a]);
    }
}

/* Momentum and continuity of weakly compressible SPH:
 *   dv_i/dt   = -1/rho_i sum V_j (p_i + p_j) grad W                     (Colagrossi & Landrini 2003;
 *               deep in shifting fluid (p_j - p_i), solver/shift.h)
 *            or -1/m_i sum (V_i^2 p_i + V_j^2 p_j) grad W               (Hu & Adams 2006)
 *             + 1/rho_i sum V_j (mu_i + mu_j) W'/r v_ij, or along x_ij  (pair_viscosity)
 *   drho_i/dt = rho_i sum V_j v_ij . grad W
 *             + 2 delta h/c0 sum V_j (p_i - p_j - rho_i g.x_ij) W'/r    (Fourtakas et al. 2019, in
 *               terms of pressure, which is continuous where two fluids meet)
 * and the artificial viscosity of Monaghan 1997 for approaching pairs, as a pressure
 * alpha c0 rho0 (-v_ij . x_ij / r), with PAIR_MIXED rho0 the harmonic mean of both. */
static inline __attribute__((always_inline)) void pair_force(struct pair_sums *s, const struct pair_state *i,
                              const struct pair_state *j, const struct pair *p,
                              const struct pair_lane_constants *c, unsigned flags)
{
    real slope = pair_slope(p, flags), weight = j->volume * slope;
    real vx = i->vx - j->vx, vy = i->vy - j->vy, vz = i->vz - j->vz;
    real dot = real_fma(vz, p->z, real_fma(vy, p->y, vx * p->x));
    real push = weight * pair_pressure(i, j, flags);
    if (flags & PAIR_SYMMETRIC) /* 1/m_i = 1/(rho_i V_i), and 1/rho_i is applied in front */
        push = slope * real_fma(i->volume, i->pressure,
                                j->volume * j->volume * j->pressure * i->inverse_volume);
    if (flags & PAIR_ARTIFICIAL) {
        real stiffness = c->artificial * weight;
        if (flags & PAIR_MIXED)
            stiffness = stiffness * pair_harmonic(i, j);
        push = real_fma(stiffness, real_positive(real_set(0) - dot * p->inverse), push);
    }
    if (!(flags & PAIR_DRAG_ONLY)) {
        s->a[0] = s->a[0] - push * p->x;
        s->a[1] = s->a[1] - push * p->y;
        s->a[2] = s->a[2] - push * p->z;
    }
    if (flags & (PAIR_VISCOUS | PAIR_OWN_VISCOSITY)) {
        real mu = c->viscosity;
        if (flags & PAIR_OWN_VISCOSITY)
            mu = (i->viscosity + j->viscosity) * c->inverse_h;
        real drag = mu * weight;
        if (flags & PAIR_MULLER)
            drag = mu * ((real_set(0) - j->volume) * viscosity_laplacian(p->q));
        const real v[3] = {vx, vy, vz};
        pair_viscosity(s->a, p, drag, v, c->central, flags);
    }
    if (flags & PAIR_CONTINUITY)
        s->divergence = real_fma(weight, dot, s->divergence);
    if (flags & PAIR_DIFFUSION) {
        real hydrostatic =
            real_fma(c->head_z, p->z, real_fma(c->head_y, p->y, c->head_x * p->x));
        real share = weight;
        if (flags & PAIR_MIXED)
            share = weight * pair_alike(i, j);
        s->diffusion = real_fma(share, (i->pressure - j->pressure) - hydrostatic, s->diffusion);
    }
}

/* Hydrostatic difference from i to a wall particle, Pa, as far as i has pressure: none of a particle
 * that falls towards the wall, and nothing that would suck. */
static inline __attribute__((always_inline)) real pair_wall_head(const struct pair_state *i,
                             const struct pair *p, const struct pair_lane_constants *c)
{
    real zero = real_set(0), own = real_positive(i->pressure), most = real_set(8) * own;
    real head = real_fma(c->head_z, p->z, real_fma(c->head_y, p->y, c->head_x * p->x));
    real rise = most - real_positive(most + head); /* the smaller of most and -head */
    return real_positive(rise + own) + (zero - own);
}

/* A wall particle continues i's pressure hydrostatically (Adami et al. 2012; never sucks), stands
 * still, and drags with i's viscosity (Akinci et al. 2012). */
static inline __attribute__((always_inline)) void pair_wall(struct pair_sums *s, const struct pair_state *i, real volume,
                             const struct pair *p, const struct pair_lane_constants *c,
                             unsigned flags)
{
    real zero = real_set(0);
    struct pair_state wall = {.volume = volume, .vx = zero, .vy = zero, .vz = zero,
                              .pressure = i->wall + pair_wall_head(i, p, c),
                              .viscosity = i->viscosity, .rest = i->rest};
    /* No density diffuses through the wall. */
    pair_force(s, i, &wall, p, c, flags & ~(unsigned)(PAIR_DIFFUSION | PAIR_SYMMETRIC));
}

/* Sums of the implicit solver's factors: number and gradient of the density at i, and the squares
 * that make the diagonal, each weighted by V_j (and there by the inverse rest density of j). */
struct pair_factors {
    real number, gx, gy, gz, squares;
};

static inline __attribute__((always_inline)) void pair_factor(struct pair_factors *s, const struct pair *p, real volume,
                                                              real inverse_density, unsigned flags)
{
    real slope = pair_slope(p, flags), weight = volume * slope;
    s->number = real_fma(volume, pair_value(p, flags), s->number);
    s->gx = real_fma(weight, p->x, s->gx);
    s->gy = real_fma(weight, p->y, s->gy);
    s->gz = real_fma(weight, p->z, s->gz);
    s->squares = real_fma(weight * inverse_density, slope * p->q2, s->squares);
}

/* sum V_j P_j grad W. */
static inline __attribute__((always_inline)) void pair_push(real sum[3], const struct pair *p, real load,
                                                            unsigned flags)
{
    real weight = load * pair_slope(p, flags);
    sum[0] = real_fma(weight, p->x, sum[0]);
    sum[1] = real_fma(weight, p->y, sum[1]);
    sum[2] = real_fma(weight, p->z, sum[2]);
}

/* sum V_j u_j . grad W. */
static inline __attribute__((always_inline)) void pair_sweep(real *sum, const struct pair *p, const real flux[4],
                                                             unsigned flags)
{
    real dot = real_fma(flux[2], p->z, real_fma(flux[1], p->y, flux[0] * p->x));
    *sum = real_fma(pair_slope(p, flags), dot, *sum);
}

/* Sums of implicit viscosity: the product, and V_j (mu_i + mu_j) W'/r alone for the diagonal: [0] with
 * Morris's operator; else xx yy zz xy xz yz of the block of 3 x 3. */
struct pair_drags {
    real along[3], weight[6];
};

/* i and j: vector, viscosity. */
static inline __attribute__((always_inline)) void pair_drag(struct pair_drags *s, const struct pair *p, real volume,
                                                            const real i[4], const real j[4],
                                                            real central, bool diagonal,
                                                            unsigned flags)
{
    real weight = (i[3] + j[3]) * (volume * pair_slope(p, flags));
    const real v[3] = {i[0] - j[0], i[1] - j[1], i[2] - j[2]};
    pair_viscosity(s->along, p, weight, v, central, flags);
    if (!diagonal)
        return;
    if (!(flags & PAIR_CENTRAL)) {
        s->weight[0] = s->weight[0] + weight;
        return;
    }
    real wx = central * weight * p->x, wy = central * weight * p->y, wz = central * weight * p->z;
    s->weight[0] = real_fma(wx, p->x, s->weight[0]);
    s->weight[1] = real_fma(wy, p->y, s->weight[1]);
    s->weight[2] = real_fma(wz, p->z, s->weight[2]);
    s->weight[3] = real_fma(wx, p->y, s->weight[3]);
    s->weight[4] = real_fma(wx, p->z, s->weight[4]);
    s->weight[5] = real_fma(wy, p->z, s->weight[5]);
}

#endif
