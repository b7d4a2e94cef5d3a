/* What the implicit pressure solver does to each particle, around the sums over its neighbours.
 *
 * DFSPH (Bender & Koschier 2015, 2017) with P = rho0^2 kappa, in Pa, so that a pressure keeps its
 * meaning when the time step changes. At fixed positions, for a velocity u:
 *   divergence  D_i(u) = sum_j V_j (u_i - u_j) . grad W_ij + u_i . (wall gradient)
 *                      = u_i . G_i - sum_j V_j u_j . grad W_ij,  G_i = sum_j V_j grad W_ij + walls
 *   push        a_i(P) = -1/rho0_i (P_i G_i + sum_j V_j P_j grad W_ij)
 * which is minus the adjoint of D, so momentum and symmetry are kept; a wall answers with the
 * particle's own pressure (Bender et al. 2023). Both solves look for P >= 0 with
 *   C_i = base_i + dt D_i(v + dt a(P)) <= 0, base_i = rho_i/rho0_i - 1 or 0 (divergence-free),
 * by sweeps P_i <- max(0, P_i + omega C_i / (dt^2 diag_i)). In the common subset of C and CUDA. */
#ifndef SOLVER_IMPLICIT_H
#define SOLVER_IMPLICIT_H

#include "solver/explicit.h"

/* Which of the two solves a sweep belongs to. */
enum solve { SOLVE_DIVERGENCE, SOLVE_DENSITY };

struct implicit_constants {
    float volume[FLUIDS_MAX]; /* V = m / rho0, in d^3 */
    float gradient;           /* struct pair_constants */
    float omega;              /* relaxation of the sweeps */
    float pressure;           /* of a solve's P: the moment of its gradients (solver/kernel.h) */
    float most;               /* compression that one step takes back: overlaps part gently */
    float sparse;             /* rho/rho0 below which divergence is not resisted: spray, surfaces */
};

/* 4 words of what does not change during a step's solves. */
struct factor {
    float gradient[3]; /* G, 1/m */
    float inverse;     /* 1 / diag: m^2 kg/m^3; 0 where nothing pushes back */
};

/* Pressures to start from in the next step, Pa. */
struct warm {
    float divergence, density;
};

/* Wall part of the density and of G. Returns the density share. */
static inline float implicit_wall(const struct explicit_constants *c, const struct position *x,
                                  float gradient[3])
{
    float open[3];
    if (!explicit_open(c, x, open))
        return 0;
    for (int face = 0; face < 6; face++) {
        int n = face / 2;
        uint32_t count = plane_counts(c, face, x);
        if (count >= c->near[n])
            continue;
        float part = open[(n + 1) % 3] * open[(n + 2) % 3];
        float area = part * plane_value(c->planes.area, (float)count * c->q_per_count[n]) / c->h;
        gradient[n] -= face & 1 ? -area : area;
    }
    return 1 - open[0] * open[1] * open[2];
}

/* From the sums: number = sum V_j w, sum = sum V_j slope x, squares = sum V_j (slope q)^2 / rho0_j. */
static inline void implicit_factor(const struct explicit_constants *c,
                                   const struct implicit_constants *m, int fluid,
                                   const struct position *x, float number, const float sum[3],
                                   float squares, struct factor *f, float *density)
{
    float g2 = 0, rest = c->rest_density[fluid];
    for (int a = 0; a < 3; a++)
        f->gradient[a] = m->gradient * sum[a];
    float share = implicit_wall(c, x, f->gradient);
    for (int a = 0; a < 3; a++)
        g2 += f->gradient[a] * f->gradient[a];
    *density = rest * (c->number_density * number + share);
    float diagonal = g2 / rest + m->volume[fluid] * (m->gradient * m->gradient) * squares;
    bool weak = !(diagonal * rest * c->h * c->h > 1e-5f);
    f->inverse = weak ? 0 : 1 / diagonal;
}

/* A sum of rounding errors only; kept, its products would be denormal, and slow. */
static inline float implicit_settled(float sum)
{
    return fabsf(sum) < 1e-20f ? 0 : sum;
}

/* The acceleration by pressure, from sum = sum V_j P_j slope x. */
static inline void implicit_push(const struct explicit_constants *c,
                                 const struct implicit_constants *m, int fluid,
                                 const struct factor *f, float pressure, const float sum[3],
                                 float acceleration[3])
{
    float front = -1 / c->rest_density[fluid];
    for (int a = 0; a < 3; a++)
        acceleration[a] = front * (pressure * f->gradient[a] +
                                   m->gradient * implicit_settled(sum[a]));
}

/* The compression before the step that a solve takes back. */
static inline float implicit_base(const struct implicit_constants *m, enum solve solve, float ratio)
{
    float base = ratio - 1;
    return solve == SOLVE_DIVERGENCE ? 0 : base < m->most ? base : m->most;
}

/* One relaxation of P; `flux` is V (v + dt a), sum = sum flux_j . slope x. Returns max(0, C). */
static inline float implicit_sweep(const struct implicit_constants *m, int fluid, float dt,
                                   float base, const struct factor *f, const float flux[3],
                                   float sum, float *pressure)
{
    float dot = 0;
    for (int a = 0; a < 3; a++)
        dot += flux[a] * f->gradient[a];
    float divergence = dot / m->volume[fluid] - m->gradient * implicit_settled(sum);
    float excess = base + dt * divergence;
    float next = *pressure + m->omega * f->inverse / (dt * dt) * excess;
    *pressure = next > 0 ? next : 0;
    return excess > 0 && f->inverse > 0 ? excess : 0;
}

/* Moves a particle by v dt, off closed planes; returns the square of the distance, m^2 (INFINITY
 * when runaway). */
static inline float implicit_move(const struct explicit_constants *c, float dt,
                                  const struct position *x0, struct position *x,
                                  struct motion *v)
{
    float move2 = 0;
    for (int a = 0; a < 3; a++) {
        float speed = explicit_rest(c, v->velocity[a]), move = speed * dt;
        move2 += move * move;
        if (!(fabsf(move) <= c->spacing))
            return INFINITY;
        x->count[a] = x0->count[a] + (uint32_t)(int32_t)lrintf(move * c->per_metre[a]);
        if (c->closed[a] && ((int32_t)x->count[a] < (int32_t)c->low[a] || x->count[a] > c->high[a]))
            x->count[a] = explicit_bounce(c, a, x->count[a], &speed);
        v->velocity[a] = speed;
    }
    x->volume = x0->volume;
    return move2;
}

#endif
