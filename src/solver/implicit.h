/* What the implicit pressure solver does to each particle, around the sums over its neighbours.
 *
 * DFSPH (Bender & Koschier 2015, 2017) with P = rho0^2 kappa, in Pa, so that a pressure keeps its
 * meaning when the time step changes. At fixed positions, for a velocity u:
 *   divergence  D_i(u) = S u_i . G_i - sum_j V_j S u_j . grad W_ij
 *   with        G_i = sum_j V_j grad W_ij + twice the wall's: fluid mirrored in the plane comes closer
 *                     at twice the speed and has the particle's pressure
 *               S   = along each axis, 1 / what other axes' walls leave open: the mirrored fluid
 *                     flows and pushes along the wall as the fluid does
 *   push        a_i(P) = -S_i/rho0_i (P_i G_i + sum_j V_j P_j grad W_ij)
 * which is minus the adjoint of D. Both solves look for P >= 0 with
 *   C_i = base_i + dt D_i(u + dt a(P)) <= 0
 * by sweeps P_i <- max(0, P_i + omega C_i / (dt^2 diag_i)). The velocity is made divergence-free
 * (u = v, base a small part of the density error); where the fluid is dense C_i = 0 and P may be
 * negative, so that a column at rest does not bounce like sand; where it is loose base is what is left
 * up to rest density. Too much density is taken back by shifting particles (u = 0, base
 * rho/rho0 - 1), which no velocity sees (Cornelis et al. 2019: else a density error delta in a column
 * of height H throws its top with delta H / dt). In the common subset of C and CUDA. */
#ifndef SOLVER_IMPLICIT_H
#define SOLVER_IMPLICIT_H

#include "solver/drag.h"

/* Which solve a sweep belongs to; that of viscosity is another kind (solver/drag.h). */
enum solve { SOLVE_VELOCITY, SOLVE_SHIFT, SOLVE_VISCOSITY, SOLVE_COUNT };

struct implicit_constants {
    float volume[FLUIDS_MAX]; /* V = m / rho0, in d^3 */
    float gradient;           /* struct pair_constants */
    float omega;              /* relaxation of the sweeps */
    float pressure;           /* of a solve's P: the moment of its gradients (solver/kernel.h) */
    float most;               /* compression that one step takes back: overlaps part gently */
    float slack;              /* of density, below which fluid is loose */
    float restore;            /* part of a density error that velocity takes back in a step */
};

/* 8 words of what does not change during a step's solves. */
struct factor {
    alignas(16) float gradient[3]; /* G, 1/m */
    float inverse;     /* 1 / diag: m^2 kg/m^3; 0 where nothing pushes back */
    float along[3];    /* S: what walls add to flow and push along them, 1 away from walls */
    float ratio;       /* rho / rho0 */
};

/* What solves hand on. */
struct warm {
    float velocity; /* Pa, of the step's velocity solve */
    float shift;    /* Pa s^2: as a displacement, it keeps its meaning when the step changes */
    float last;     /* Pa, of the sweep before, within a solve */
};

/* Wall part of the density and of G, and S. Returns the density share. */
static inline float implicit_wall(const struct explicit_constants *c, const struct position *x,
                                  float gradient[3], float along[3])
{
    float open[3];
    bool near = explicit_open(c, x, open);
    for (int a = 0; a < 3; a++)
        along[a] = 1 / (open[(a + 1) % 3] * open[(a + 2) % 3]);
    if (!near)
        return 0;
    for (int face = 0; face < 6; face++) {
        int n = face / 2;
        uint32_t count = plane_counts(c, face, x);
        if (count >= c->near[n])
            continue;
        float part = open[(n + 1) % 3] * open[(n + 2) % 3];
        float area = part * plane_value(c->planes.area, (float)count * c->q_per_count[n]) / c->h;
        gradient[n] -= 2 * (face & 1 ? -area : area);
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
    float share = implicit_wall(c, x, f->gradient, f->along), widest = 1;
    for (int a = 0; a < 3; a++)
        g2 += f->gradient[a] * f->gradient[a] * (f->along[a] * f->along[a]);
    for (int a = 0; a < 3; a++)
        widest = f->along[a] > widest ? f->along[a] : widest;
    f->ratio = c->number_density * number + share;
    *density = rest * f->ratio;
    /* Dense by walls alone, as a drop in an edge of the tank, is loose: it must be able to fall off. */
    float others = c->number_density * (number - m->volume[fluid]), loose = 0.99f * (1 - m->slack);
    if (others < 0.15f && f->ratio > loose)
        f->ratio = loose;
    float diagonal = g2 / rest + m->volume[fluid] * (m->gradient * m->gradient) *
                                     (widest * widest) * squares;
    bool weak = !(diagonal * rest * c->h * c->h > 1e-5f);
    /* Crowded particles have more neighbours than the lattice, whose window omega is. */
    float crowd = f->ratio > 1.1f ? f->ratio : 1;
    f->inverse = weak ? 0 : 1 / (diagonal * widest * crowd);
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
        acceleration[a] = front * f->along[a] * (pressure * f->gradient[a] +
                                   m->gradient * implicit_settled(sum[a]));
}

/* Whether the fluid is dense here, so that it resists expansion as well: P may then be negative. A
 * surface, a splash, a torn sheet resists compression only. */
static inline bool implicit_holds(const struct implicit_constants *m, enum solve solve, float ratio)
{
    return solve == SOLVE_VELOCITY && ratio >= 1 - m->slack;
}

/* The compression before the step, as a solve counts it. The target ratio is 1; where no fluid is
 * loose it is the mean, since disorder alone raises summed density and there is nowhere to go. */
static inline float implicit_base(const struct implicit_constants *m, enum solve solve, float ratio,
                                  float target)
{
    float base = ratio - (solve == SOLVE_VELOCITY ? target : 1);
    if (solve == SOLVE_VELOCITY)
        return implicit_holds(m, solve, ratio) ? m->restore * base : base + m->slack;
    return base < m->most ? base : m->most;
}

/* One relaxation of P; `flux` is V (v + dt a), sum = sum flux_j . slope x. Returns |C|, or max(0, C)
 * where expansion is free; C counts from `offset`, which only fluid without a surface has: its mean
 * compression cannot change. */
static inline float implicit_sweep(const struct implicit_constants *m, int fluid, float dt,
                                   float base, float offset, float *raw, const struct factor *f, const float flux[3],
                                   float sum, bool holds, float relax, float momentum,
                                   float *last, float *pressure)
{
    float dot = 0;
    for (int a = 0; a < 3; a++)
        dot += flux[a] * f->gradient[a];
    float divergence = dot / m->volume[fluid] - m->gradient * implicit_settled(sum);
    float excess = base + dt * divergence - offset;
    *raw = base + dt * divergence;
    float next = *pressure + relax * m->omega * f->inverse / (dt * dt) * excess;
    next = f->inverse > 0 && (next > 0 || holds) ? next : 0;
    float ahead = next + momentum * (next - *last);
    *last = next;
    *pressure = f->inverse > 0 && (ahead > 0 || holds) ? ahead : 0;
    float error = holds ? fabsf(excess) : excess;
    return error > 0 && f->inverse > 0 ? error : 0;
}

/* A shift, as a velocity, of at most a tenth of a spacing: what is left is taken back in later steps. */
static inline void implicit_bound(const struct explicit_constants *c, float dt, float shift[3])
{
    float most = 0.1f * c->spacing / dt;
    float size2 = shift[0] * shift[0] + shift[1] * shift[1] + shift[2] * shift[2];
    if (!(size2 > most * most))
        return;
    float part = most / sqrtf(size2);
    for (int a = 0; a < 3; a++)
        shift[a] = isfinite(part) ? part * shift[a] : 0;
}

/* Moves a particle by (v + shift) dt, off closed planes; returns the square of the distance, m^2 (INFINITY
 * when runaway). */
static inline float implicit_move(const struct explicit_constants *c, float dt,
                                  const struct position *x0, const float shift[3],
                                  struct position *x, struct motion *v)
{
    float move2 = 0;
    for (int a = 0; a < 3; a++) {
        float speed = explicit_rest(c, v->velocity[a]), move = (speed + shift[a]) * dt;
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
