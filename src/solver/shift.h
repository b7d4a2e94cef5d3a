/* Particle shifting: deep inside the fluid particles drift towards emptier places, so that they stay
 * evenly spread where the flow would draw them out into threads (Sun et al. 2017, delta-plus-SPH).
 *
 *   u_i = -2 U h 2 sum_j V_j (1 + 0.2 (W_ij/W(d))^4) grad W_ij + 0.2 U r_i,   |u_i| <= U
 * moves the particle besides its velocity. U is local, the largest sqrt(W_ij/W(d)) |v_ij|: nothing
 * shifts in fluid at rest or in uniform motion. r_i is a direction of the particle's own: a lattice
 * under strain is in balance by symmetry, and collapses late and violently unless it is disturbed.
 * Particles that shift no longer need the repulsion of the pressure form p_i + p_j, which turns
 * disorder and negative pressure into noise: deep inside, the form is p_j - p_i.
 *
 * Near a free surface all of this fades: l_i goes from 0 to 1 as the divergence of position (Lee et
 * al. 2008), -sum_j V_j x_ij . grad W, falls, and what counts is the largest l among the particle and
 * its neighbours. In the common subset of C and CUDA. */
#ifndef SOLVER_SHIFT_H
#define SOLVER_SHIFT_H

#include "solver/explicit.h"
#include "solver/stir.h"

struct shift {
    alignas(16) float velocity[3]; /* u, m/s */
    float deep;        /* 1 where no surface is within reach, 0 near one */
};

struct shift_sums {
    float crowd[3];   /* sum of V_j (1 + ...) grad W */
    float divergence; /* of position */
    float speed2;     /* U^2, m^2/s^2 */
    float surface;    /* largest l_j of the last step */
};

#define SHIFT_SURFACE 2.5f /* divergence of position at which l = 1 */
#define SHIFT_INSIDE 2.7f  /* and 0; whole fluid has 3 */
#define SHIFT_SIZE 4       /* 2 * 2 above */
#define SHIFT_STIR 0.2f    /* part of r */

/* Adds the closed planes, as if fluid stood behind them. */
static inline void shift_walls(const struct explicit_constants *c, const struct position *x,
                               struct shift_sums *s)
{
    float open[3];
    if (!explicit_open(c, x, open))
        return;
    for (int face = 0; face < 6; face++) {
        int n = face / 2;
        uint32_t count = plane_counts(c, face, x);
        if (count >= c->near[n])
            continue;
        float q = (float)count * c->q_per_count[n];
        float part = open[(n + 1) % 3] * open[(n + 2) % 3];
        float area = c->normal * part * plane_value(c->planes.area, q) / c->h;
        s->crowd[n] -= face & 1 ? -area : area;
        s->divergence += 3 * part * plane_value(c->planes.volume, q) + area * q * c->h;
    }
}

/* From the sums without walls; returns l. */
static inline float shift_choose(const struct explicit_constants *c, const struct position *x,
                                 uint32_t id, struct shift_sums s, struct shift *shift)
{
    shift_walls(c, x, &s);
    float lack = (SHIFT_INSIDE - s.divergence) / (SHIFT_INSIDE - SHIFT_SURFACE);
    lack = lack < 0 ? 0 : lack > 1 ? 1 : lack;
    shift->deep = 1 - (s.surface > lack ? s.surface : lack);
    float most = sqrtf(s.speed2) * shift->deep, square = 0;
    for (uint32_t a = 0; a < 3; a++) {
        float stir = SHIFT_STIR * stir_component(3 * id + a);
        shift->velocity[a] = most * (stir - SHIFT_SIZE * c->h * s.crowd[a]);
        square += shift->velocity[a] * shift->velocity[a];
    }
    float limit = square > most * most ? most / sqrtf(square) : 1;
    for (int a = 0; a < 3; a++)
        shift->velocity[a] = explicit_rest(c, limit * shift->velocity[a]);
    return lack;
}

#endif
