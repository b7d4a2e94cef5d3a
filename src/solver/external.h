/* Accelerations besides uniform gravity: a central force, buoyancy between fluids, dissipation.
 *
 *   a_i = -Omega^2 (x_i - centre)                      not along periodic axes
 *       + b (rho0_i - rho_mean)/rho0_i g               rho_mean: all fluids' mass over their volume,
 *                                                      so that momentum and single fluids feel none
 *       - gamma v_i
 * In the common subset of C and CUDA. */
#ifndef SOLVER_EXTERNAL_H
#define SOLVER_EXTERNAL_H

#include "solver/explicit.h"

struct external_constants {
    bool any;                   /* of the three is there */
    bool central;
    double stiffness[3];        /* Omega^2, 1/s^2; 0 along periodic axes */
    double centre[3];           /* m from the space's origin */
    double unit[3];             /* m per count */
    float lift[FLUIDS_MAX][3];  /* of buoyancy, m/s^2 */
    float dissipation;          /* gamma, 1/s */
};

/* (1 - exp(-z))/z, the mean over a step of what decays to exp(-z); within z^4/720. */
static inline float external_decay(float z)
{
    return 1 / (1 + z * (0.5f + z * (1.0f / 12)));
}

/* Adds to `rate`. `dt` is that of a step that ends with v + dt a, as an implicit solver's kick, which
 * is then exact for any gamma dt; 0 where the rate itself is wanted. */
static inline void external_rate(const struct external_constants *c, int fluid, float dt,
                                 const struct position *x, const struct motion *v,
                                 struct rate *rate)
{
    float mean = external_decay(c->dissipation * dt);
    for (int a = 0; a < 3; a++) {
        double away = (double)x->count[a] * c->unit[a] - c->centre[a];
        float own = rate->acceleration[a] + c->lift[fluid][a];
        if (c->central)
            own -= (float)(c->stiffness[a] * away);
        rate->acceleration[a] = (own - c->dissipation * v->velocity[a]) * mean;
    }
}

#endif
