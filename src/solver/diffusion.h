/* Density gradients of delta-SPH: what diffusion must leave alone (Antuono et al. 2010, 2012).
 *
 *   drho_i/dt = 2 delta h c sum_j V_j ((rho_i - rho_j) - (g_i + g_j).x_ij / 2) W'/r
 *   g_i       = M_i^-1 sum_j V_j (rho_i - rho_j) x_ij W'/r,   M_i = sum_j V_j x_ij x_ij^T W'/r
 * Since g is exact for a linear field wherever M has an inverse, such a field does not diffuse: neither
 * inside, nor at a free surface or a wall, where the sums lack a part of the support. So walls add
 * nothing. What i gives j takes: sum V_i drho_i/dt = 0. Where neighbours lie nearly in a plane or a line
 * g fades to 0. Only neighbours of the same rest density count. Density is kept as c^2 (rho - rho0), Pa,
 * so that the constants are those of the form by pressure (solver/pair.h). In the common subset of C and
 * CUDA; the sums and M^-1 are in solver/pair_diffusion.h. */
#ifndef SOLVER_DIFFUSION_H
#define SOLVER_DIFFUSION_H

#include "solver/explicit.h"

/* What the diffusion pass reads of a particle and its neighbours. */
struct gradient {
    alignas(16) float along[3]; /* h c^2 grad rho, Pa */
    float excess;   /* c^2 (rho - rho0), Pa */
};

/* 27 det M / (trace M)^3, 1 where neighbours lie evenly: g is 0 below the one, whole above the other. */
#define GRADIENT_FLAT 0.01f
#define GRADIENT_ROUND 0.03f

/* c^2 of a fluid, m^2/s^2. */
static inline float gradient_stiffness(const struct explicit_constants *c, int fluid)
{
    return (c->tait ? 7 : 1) * c->bulk[fluid] / c->rest_density[fluid];
}

#endif
