/* Surface tension as a force on the surface along its curvature (continuum surface force: Brackbill et
 * al. 1992, Morris 2000), with one-sided sums, since there is no air.
 *
 * With c the smoothed indicator of particle i's own fluid, two passes sum over neighbours:
 *   grad c_i = sum_j V_j grad W_ij,   n = grad c/|grad c|,   s = |grad c| at a surface, 0 inside
 *   kappa_i  = sum_j V_j s_j W'/r (n_j - n_i).x_ij / sum_j V_j s_j W'/r |x_ij - n_i (n_i.x_ij)|^2 / 2
 *   a_i      = sigma/(e rho0) kappa_i s_i n_i
 * e is the sum of s over the depth of a plane surface on the lattice, about 1/2 since particles are on
 * one side: the only calibration. W is Wendland C2 on the solver's support. Where s vanishes, disorder
 * inside the fluid passes for no surface. Momentum is kept as far as the sum of kappa n over a closed
 * surface vanishes. Walls belong to every fluid (contact angle 90 degrees). Where two fluids meet each
 * has its own surface: their tensions add. In the common subset of C and CUDA. */
#ifndef SOLVER_TENSION_H
#define SOLVER_TENSION_H

#include "solver/explicit.h"

struct tension_constants {
    bool any;                   /* fluid has surface tension */
    float gradient;             /* h grad c from sum V_j W'/r x */
    float low2, scale;          /* s is 0 below (h |grad c|)^2 = low2, whole above low2 + 1/scale */
    float most;                 /* largest |kappa| h */
    float strength[FLUIDS_MAX]; /* sigma/(e h^2 rho0), m/s^2 */
    float pressure[FLUIDS_MAX]; /* sigma/h, Pa: of kappa h = 1 */
    float inset;                /* of the outermost particles below the surface, d/4h: half of it */
    bool between;               /* there are several fluids */
    struct plane_table planes;  /* of W */
};

/* What the second pass reads of a neighbour. */
struct normal {
    alignas(16) float along[3]; /* n, into the fluid */
    float size;     /* h s */
};

/* h grad c of the closed planes, as if fluid stood behind them. */
static inline void tension_walls(const struct explicit_constants *c,
                                 const struct tension_constants *t, const struct position *x,
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
        float area = part * plane_value(t->planes.area, (float)count * c->q_per_count[n]);
        gradient[n] += face & 1 ? area : -area;
    }
}

/* s / |grad c| at (h |grad c|)^2 = square. */
static inline float tension_part(const struct tension_constants *t, float square)
{
    float u = (square - t->low2) * t->scale;
    return u < 0 ? 0 : u > 1 ? 1 : u;
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
    tension_walls(c, t, x, n.along);
    for (int a = 0; a < 3; a++)
        square += n.along[a] * n.along[a];
    float size = sqrtf(square);
    for (int a = 0; a < 3; a++)
        n.along[a] = size > 0 ? n.along[a] / size : 0;
    n.size = size * tension_part(t, square);
    return n;
}

/* kappa h; turn and spread are its two sums, times h^3. */
static inline float tension_curvature(const struct tension_constants *t, float turn, float spread)
{
    float curvature = spread < -1e-6f ? 2 * turn / spread : 0; /* without neighbours 0 */
    return curvature > t->most ? t->most : curvature < -t->most ? -t->most : curvature;
}

/* sigma kappa of the surface outside particles with that kappa h: a sphere's is d/2 farther out, Pa. */
static inline float tension_pressure(const struct tension_constants *t, int fluid, float curvature)
{
    return t->pressure[fluid] * curvature / (1 + curvature * t->inset);
}

/* Adds the acceleration at the interface to other fluids, whose particles make up for the gradient of the
 * fluid's own: `lacks` is h |grad c| of all fluids, whose tension acts as a pressure p elsewhere. */
static inline void tension_between(const struct tension_constants *t, int fluid,
                                   const struct normal *n, const float lacks[3], float p,
                                   struct rate *rate)
{
    float square = lacks[0] * lacks[0] + lacks[1] * lacks[1] + lacks[2] * lacks[2];
    float part = square > 0 ? tension_part(t, square) : 0;
    float curvature = t->pressure[fluid] > 0 ? p / t->pressure[fluid] : 0;
    for (int a = 0; a < 3; a++)
        rate->acceleration[a] += t->strength[fluid] * curvature *
                                 (n->size * n->along[a] - part * lacks[a]);
}

/* Adds the acceleration. */
static inline void tension_rate(const struct tension_constants *t, int fluid,
                                const struct normal *n, float curvature, struct rate *rate)
{
    float size = t->strength[fluid] * curvature * n->size;
    for (int a = 0; a < 3; a++)
        rate->acceleration[a] += size * n->along[a];
}

#endif
