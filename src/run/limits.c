/* Computes what limits the time step. */
#include "run/limits.h"

#include "run/simulation.h"

#include <math.h>

const char *const limit_names[LIMIT_COUNT] = {
    [LIMIT_ACOUSTIC] = "acoustic limit (sound across h)",
    [LIMIT_SPEED] = "speed limit (flow across the spacing)",
    [LIMIT_FORCE] = "force limit (acceleration across the spacing)",
    [LIMIT_VISCOUS] = "viscous limit (h^2 rho/mu)",
    [LIMIT_CAPILLARY] = "capillary limit (surface tension, sqrt(rho h^3/sigma))",
    [LIMIT_DAMPING] = "damping limit (1/dissipation)",
    [LIMIT_GROWTH] = "growth limit (a tenth more than the last step)",
    [LIMIT_USER] = "scene's time.step",
};

const char *const limit_words[LIMIT_COUNT] = {
    [LIMIT_ACOUSTIC] = "acoustic", [LIMIT_SPEED] = "speed",         [LIMIT_FORCE] = "force",
    [LIMIT_VISCOUS] = "viscous",   [LIMIT_CAPILLARY] = "capillary", [LIMIT_DAMPING] = "damping",
    [LIMIT_GROWTH] = "growth",     [LIMIT_USER] = "user",
};

const char *const limit_formulas[LIMIT_COUNT] = {
    [LIMIT_ACOUSTIC] = "C h/(c + v), c the fastest sound, h half the support (wcsph, muller)",
    [LIMIT_SPEED] = "0.4 C d/(v + what gravity adds in the step) (isph, dfsph); 0.4 d/v (wcsph, muller)",
    [LIMIT_FORCE] = "0.1 sqrt(d/g) (isph, dfsph); 0.25 sqrt(h/a), a the largest acceleration (wcsph, muller)",
    [LIMIT_VISCOUS] = "h^2 rho/(8 mu), half of it with wcsph and muller, 0.6 of it with isph and weiler",
    [LIMIT_CAPILLARY] = "sqrt(rho h^3/(2 pi sigma))/4",
    [LIMIT_DAMPING] = "1/(2 dissipation)",
};

/* The step in which gravity and the present speed move a particle by cfl 0.4 d (Bender & Koschier
 * 2015), grown slowly. A flow from rest starts with the time that gravity takes for d / 16. */
static void implicit_limits(const struct simulation *s, double speed, double limit[LIMIT_COUNT])
{
    const struct solver_choice *c = &s->plan->choice;
    const double *g = s->plan->scene->gravity;
    double most = c->cfl * 0.4 * c->spacing;
    if (c->implicit_viscosity) /* a wall can drag fluid along in one step */
        speed = fmax(speed, c->wall_speed);
    double force = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]) + c->pull;
    double reached = (sqrt(speed * speed + 4 * force * most) - speed) / 2; /* dt g */
    if (speed + reached > 0)
        limit[LIMIT_SPEED] = most / (speed + reached);
    if (force > 0)
        limit[LIMIT_FORCE] = 0.1 * sqrt(c->spacing / force);
}

static void explicit_limits(const struct simulation *s, double speed, double limit[LIMIT_COUNT])
{
    const struct solver_choice *c = &s->plan->choice;
    double acceleration = sqrt(s->extremes.acceleration2);
    limit[LIMIT_ACOUSTIC] = c->limits.acoustic / (c->sound_speed + speed);
    if (acceleration > 0)
        limit[LIMIT_FORCE] = c->limits.force * sqrt(c->smoothing_length / acceleration);
    if (speed > 0)
        limit[LIMIT_SPEED] = 0.4 * c->spacing / speed; /* well below the half spacing of the guard */
}

void limits_now(const struct simulation *s, double limit[LIMIT_COUNT])
{
    double speed = sqrt(s->extremes.speed2);
    for (int k = 0; k < LIMIT_COUNT; k++)
        limit[k] = INFINITY;
    (s->plan->choice.is_implicit ? implicit_limits : explicit_limits)(s, speed, limit);
    limit[LIMIT_VISCOUS] = s->plan->choice.limits.viscous;
    limit[LIMIT_CAPILLARY] = s->plan->choice.limits.capillary;
    if (!s->plan->choice.is_implicit || s->plan->choice.projects) /* others' kick is exact */
        limit[LIMIT_DAMPING] = s->plan->choice.limits.damping;
    limit[LIMIT_USER] = s->plan->choice.limits.user;
    limit[LIMIT_GROWTH] = 1.1 * s->last_dt;
}

double limits_least(const double limit[LIMIT_COUNT], unsigned mask, enum limit *which)
{
    double least = INFINITY;
    enum limit found = LIMIT_USER;
    for (int k = 0; k < LIMIT_COUNT; k++)
        if (mask & 1u << k && limit[k] < least) {
            least = limit[k];
            found = (enum limit)k;
        }
    if (which)
        *which = found;
    return least;
}
