/* Surface tension by the energy of each fluid's surface.
 *
 * With c the smoothed indicator of particle i's own fluid, grad c_i = sum_j V_j grad W_ij, the integral
 * of |grad c| across a plane surface is 1, and 1/2 on the side where particles are. So
 *   E = (sigma/e) sum_i V_i (sqrt(|grad c_i|^2 + s^2) - s)
 * is sigma times the area, e being that sum for a plane surface of area 1 on the lattice: the only
 * calibration. The small s lets the disorder of the inside pass for no surface. The force is exactly
 * -dE/dx_i at fixed V:
 *   F_i = -(sigma/e) V_i sum_j V_j H_ij (n_i - n_j),   n = grad c / sqrt(|grad c|^2 + s^2)
 * H the second derivatives of W, so that linear and angular momentum are conserved to rounding, and a
 * plane surface feels nothing. Walls belong to every fluid (contact angle 90 degrees). Where two
 * fluids meet each has its own surface: their tensions add. W is Wendland C2 on the solver's support.
 * In the common subset of C and CUDA. */
#ifndef SOLVER_TENSION_H
#define SOLVER_TENSION_H

#include "solver/explicit.h"

struct tension_constants {
    bool any;                   /* fluid has surface tension */
    float gradient;             /* sigma_W (d/h)^3: h grad c from the sums, V in d^3 */
    float floor, floor2, most;               /* (h s)^2 */
    float strength[FLUIDS_MAX]; /* sigma/e / (h^2 m_i/d^3), m^2... times V_i: m/s^2 */
    struct plane_table planes;  /* of the kernel W */
};

/* What the second pass reads of a neighbour. */
struct normal {
    float along[3]; /* n, into the fluid */
    float size;     /* h (sqrt(|grad c|^2 + s^2) - s) */
};

/* h grad c of the closed planes, as if fluid stood behind them. */
static inline void tension_wall_gradient(const struct explicit_constants *c,
                                         const struct tension_constants *t,
                                         const struct position *x, float gradient[3])
{
    float open[3];
    if (!explicit_open(c, x, open))
        return;
    for (int face = 0; face < 6; face++) {
        int n = face / 2;
        uint32_t count = plane_counts(c, face, x);
        if (count >= c->near[n])
            continue;
        float part = open[(n + 1) % 3] * open[(n + 2) % 3];
        float area = part * plane_value(t->planes.area, (float)count * c->q_per_count[n]);
        gradient[n] += face & 1 ? area : -area;
    }
}

/* How far a gradient of that square is one of a surface, 0..1. */
static inline float tension_sure(const struct tension_constants *t, float square)
{
    float low = t->floor2, high = 4 * low, u = (square - low) / (high - low);
    return u < 0 ? 0 : u > 1 ? 1 : u;
}

static inline struct normal tension_normal(const struct explicit_constants *c,
                                           const struct tension_constants *t,
                                           const struct position *x, const float sum[3])
{
    struct normal n = {{0, 0, 0}, 0};
    float square = 0;
    for (int a = 0; a < 3; a++)
        n.along[a] = t->gradient * sum[a];
    tension_wall_gradient(c, t, x, n.along);
    for (int a = 0; a < 3; a++)
        square += n.along[a] * n.along[a];
    float size = sqrtf(square), one = size > 0 ? 1 / size : 0;
    for (int a = 0; a < 3; a++)
        n.along[a] *= one;
    n.size = tension_sure(t, square) * size;
    return n;
}

/* Adds the acceleration by curvature from the sums over neighbours (solver/pair_tension.h). */
static inline void tension_rate(const struct tension_constants *t, int fluid,
                                const struct position *x, const struct normal *n,
                                const float sum[2], struct rate *rate)
{
    float curvature = sum[1] < -1e-12f ? -2 * sum[0] / sum[1] : 0; /* times h */
    curvature = curvature > t->most ? t->most : curvature < -t->most ? -t->most : curvature;
    (void)x;
    float size = t->strength[fluid] * curvature * n->size;
    for (int a = 0; a < 3; a++)
        rate->acceleration[a] += size * n->along[a];
}

#endif
