/* Surface tension as the pressure sigma kappa that acts on a fluid's surface (continuum surface force:
 * Brackbill et al. 1992, Morris 2000), in the terms of the pressure force, so that it balances.
 *
 * With c the smoothed indicator of particle i's own fluid, three passes sum over neighbours:
 *   grad c_i = sum_j V_j grad W_ij,   n = grad c / |grad c|
 *   kappa_i  = sum_j V_j s_j W'/r (n_i - n_j).x_ij / sum_j V_j s_j W'/r |x_ij - n_i (n_i.x_ij)|^2 / 2
 *   a_i      = 2 sigma/rho_i <kappa>_i grad c_i,   <kappa> the mean of kappa_j weighed by V_j s_j W_ij
 * s_j is 0 inside and 1 at the surface, by |grad c|. The pressure force of particles that all have the
 * pressure p is -2 p grad c_i/rho_i for any arrangement: a drop of uniform curvature is still,
 * particle by particle, with p = sigma kappa, and its momentum is kept to rounding; elsewhere as far
 * as kappa changes little within h. Curvature is that of the particles, half a spacing inside the
 * surface, and is taken out to it. Walls belong to every fluid (contact angle 90 degrees). Where two
 * fluids meet each has its own surface: their tensions add. In the common subset of C and CUDA. */
#ifndef SOLVER_TENSION_H
#define SOLVER_TENSION_H

#include "solver/explicit.h"

struct tension_constants {
    bool any;                   /* fluid has surface tension */
    float gradient;             /* h times that of struct pair_constants */
    float low, scale;           /* s is 0 below (h |grad c|)^2 = low, 1 above low + 1/scale */
    float most;                 /* |kappa| h that particles resolve */
    float depth;                /* of surface particles below the surface, over h */
    float ripple[FLUIDS_MAX], strength[FLUIDS_MAX]; /* 2 sigma/h^2, Pa/m */
};

/* What the later passes read of a neighbour. */
struct normal {
    float along[3]; /* n, into the fluid */
    float size;     /* h |grad c| */
};

/* h grad c of the closed planes, as if fluid stood behind them: what they push with in explicit_walls. */
static inline void tension_walls(const struct explicit_constants *c, const struct position *x,
                                 float gradient[3])
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
        float area = c->normal * part *
                     plane_value(c->planes.area, (float)count * c->q_per_count[n]);
        gradient[n] += face & 1 ? area : -area;
    }
}

/* From sum = sum V_j W'/r x. */
static inline struct normal tension_normal(const struct explicit_constants *c,
                                           const struct tension_constants *t,
                                           const struct position *x, const float sum[3])
{
    struct normal n;
    float square = 0;
    for (int a = 0; a < 3; a++)
        n.along[a] = t->gradient * sum[a];
    tension_walls(c, x, n.along);
    for (int a = 0; a < 3; a++)
        square += n.along[a] * n.along[a];
    n.size = sqrtf(square);
    for (int a = 0; a < 3; a++)
        n.along[a] = n.size > 0 ? n.along[a] / n.size : 0;
    return n;
}

/* h kappa at the surface, from the two sums; below zero by rounding, or without neighbours, it is 0. */
static inline float tension_curvature(const struct tension_constants *t, float turn, float spread)
{
    float k = spread < -1e-6f ? -2 * turn / spread : 0;
    k = k > t->most ? t->most : k < -t->most ? -t->most : k;
    return k / (1 + t->depth * k);
}

/* From the sums of V_j s_j w, alone and times h kappa_j. */
static inline void tension_rate(const struct tension_constants *t, int fluid, float density,
                                const struct normal *n, float weight, float sum,
                                struct rate *rate)
{
    float size = weight > 1e-6f ? t->strength[fluid] / density * n->size * (sum / weight) : 0;
    for (int a = 0; a < 3; a++)
        rate->acceleration[a] += size * n->along[a];
}

#endif
