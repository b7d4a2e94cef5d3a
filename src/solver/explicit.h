/* What the explicit solvers do to each particle: integration, equation of state, closed walls.
 *
 * Leapfrog in predict-correct form, one force evaluation a step:
 *   v_half = v + a dt/2;  x += v_half dt;  v* = v_half + a dt/2;  rho* = rho + rho' dt
 *   (a, rho') at (x, v*, rho*)
 *   v = v* + (a_new - a_old) dt/2;  rho = rho* + (rho'_new - rho'_old) dt/2
 * In the common subset of C and CUDA. */
#ifndef SOLVER_EXPLICIT_H
#define SOLVER_EXPLICIT_H

#include "particles/particles.h"
#include "solver/kernel.h"
#include "solver/obstacle.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

enum { FLUIDS_MAX = 16 };

struct explicit_constants {
    double unit[3];           /* m per count */
    float per_metre[3];       /* counts per m */
    uint32_t near[3];         /* 2h in counts: farther from a plane it does not matter */
    float q_per_count[3];     /* unit / h */
    uint32_t low[3], high[3]; /* closed planes, counts */
    bool closed[3];           /* planes stop particles on this axis */
    bool plane[6];            /* and stands for a half space of wall */
    float wall_velocity[6][3]; /* m/s, of each plane along itself */
    float restitution;
    bool no_slip;
    bool tait, clamp;         /* equation of state; negative pressure set to zero */
    float rest_speed;         /* m/s; slower than this is at rest */
    float spacing;            /* d, m */
    float h;                  /* m */
    float gravity[3];         /* that pressure can balance: not along periodic axes, m/s^2 */
    float normal;             /* what makes lattice gradients exact: 1 / moment */
    float number_density;     /* sigma d^3 / h^3: sum of w to V_rest sum W */
    float rest_density[FLUIDS_MAX]; /* kg/m^3 */
    float bulk[FLUIDS_MAX];   /* Pa: B = rho0 c0^2 / 7 (Tait) or rho0 c0^2 (linear) */
    float mass[FLUIDS_MAX];   /* particle mass / d^3, kg/m^3 */
    float viscosity[FLUIDS_MAX]; /* Pa s */
    struct plane_table planes;
    struct obstacles obstacles;
};

/* Largest values over all particles, each exact, so that their order does not matter. */
struct extremes {
    float speed2, acceleration2; /* m^2/s^2, m^2/s^4 */
    float move2;                 /* of the step, m^2 */
    uint32_t bad;                /* smallest id of a non-finite or runaway particle */
};

/* p = B ((rho/rho0)^7 - 1) (Cole 1948; Monaghan 1994) or c0^2 (rho - rho0), and V = m/rho. */
static inline void explicit_state(const struct explicit_constants *c, int fluid, float density,
                                  float *pressure, float *volume)
{
    float ratio = density / c->rest_density[fluid];
    if (c->tait) {
        float r2 = ratio * ratio, r4 = r2 * r2;
        ratio = r4 * (r2 * ratio);
    }
    float p = c->bulk[fluid] * (ratio - 1);
    *pressure = c->clamp && p < 0 ? 0 : p;
    *volume = c->mass[fluid] / density;
}

/* The inverse: the density that has this pressure, half the rest density at least. The seventh root
 * by Newton's method, from above, where it falls to the root steadily. */
static inline float explicit_density(const struct explicit_constants *c, int fluid, float pressure)
{
    double power = 1 + (double)pressure / (double)c->bulk[fluid];
    double least = c->tait ? 0x1p-7 : 0.5, ratio = power > least ? power : least, next = ratio;
    if (c->tait) {
        power = ratio;
        next = 1 + (power - 1) / 7;
        do {
            ratio = next;
            double r2 = ratio * ratio, r6 = r2 * r2 * r2;
            next = ratio - (ratio - power / r6) / 7;
        } while (next < ratio);
    }
    return (float)(ratio * (double)c->rest_density[fluid]);
}

/* Speeds far below what a position can resolve are zero: their products would be denormal numbers,
 * which cost a hundred cycles each and are treated differently by different hardware. */
static inline float explicit_rest(const struct explicit_constants *c, float speed)
{
    return fabsf(speed) < c->rest_speed ? 0 : speed;
}

/* Bounces a coordinate that left the domain off the closed plane it crossed. Coordinates of closed
 * axes are below 2^31, so that beyond the lower plane is negative. */
static inline uint32_t explicit_bounce(const struct explicit_constants *c, int a, uint32_t x,
                                       float *speed)
{
    int64_t low = c->low[a], high = c->high[a], at = (int32_t)x;
    bool below = at < low;
    float beyond = (float)(below ? low - at : at - high) * c->restitution;
    *speed = (below ? 1.0f : -1.0f) * fabsf(*speed) * c->restitution;
    at = below ? low + (int64_t)beyond : high - (int64_t)beyond;
    return (uint32_t)(at < low ? low : at > high ? high : at);
}

/* First half of a step; `shift` (m/s, or NULL) moves the particle besides its velocity. Returns the
 * square of the distance moved, m^2 (INFINITY when runaway). */
static inline float explicit_predict(const struct explicit_constants *c, int fluid, float dt,
                                     const struct position *x0, const struct motion *v0,
                                     const struct rate *rate, float density0, const float *shift,
                                     struct position *x, struct motion *v, float *density)
{
    float move2 = 0;
    for (int a = 0; a < 3; a++) {
        float kick = 0.5f * dt * rate->acceleration[a], half = v0->velocity[a] + kick;
        float move = (shift ? half + shift[a] : half) * dt;
        move2 += move * move;
        if (!(fabsf(move) <= c->spacing)) /* the step is rejected anyway: no overflow below */
            return INFINITY;
        x->count[a] = x0->count[a] + (uint32_t)(int32_t)lrintf(move * c->per_metre[a]);
        if (c->closed[a] && ((int32_t)x->count[a] < (int32_t)c->low[a] || x->count[a] > c->high[a]))
            x->count[a] = explicit_bounce(c, a, x->count[a], &half);
        v->velocity[a] = explicit_rest(c, half + kick);
    }
    /* The continuity equation lets a particle that is torn off thin out without end; the volume m/rho
     * that its neighbours then see grows beyond all bounds. Thinner than half is no fluid. */
    float thinnest = 0.5f * c->rest_density[fluid], next = density0 + dt * rate->density;
    *density = next < thinnest ? thinnest : next;
    explicit_state(c, fluid, *density, &v->pressure, &x->volume);
    return move2;
}

static inline void explicit_correct(const struct explicit_constants *c, float dt,
                                    const struct rate *old, const struct rate *now,
                                    struct motion *v, float *density)
{
    for (int a = 0; a < 3; a++) {
        float change = 0.5f * dt * (now->acceleration[a] - old->acceleration[a]);
        v->velocity[a] = explicit_rest(c, v->velocity[a] + change);
    }
    *density += 0.5f * dt * (now->density - old->density);
}

/* Linear interpolation in a plane table. */
static inline float plane_value(const float *table, float q)
{
    float t = q * (PLANE_STEPS / 2);
    int k = (int)t;
    float f = t - (float)k;
    return table[k] * (1 - f) + table[k + 1] * f;
}

/* Distance to a face in counts; far away for a face that is no plane. */
static inline uint32_t plane_counts(const struct explicit_constants *c, int face,
                                    const struct position *x)
{
    uint32_t count = face & 1 ? c->high[face / 2] - x->count[face / 2]
                              : x->count[face / 2] - c->low[face / 2];
    return c->plane[face] ? count : UINT32_MAX;
}

/* The part of the support that lies between the closed planes of each axis. Half spaces of two axes
 * overlap at edges and corners: what is open to the fluid is nearly the product (exactly, for a
 * separable kernel), so a face counts only for the part that is open along the other axes. Returns
 * whether any plane is near. */
static inline bool explicit_open(const struct explicit_constants *c, const struct position *x,
                                 float open[3])
{
    for (int a = 0; a < 3; a++)
        open[a] = 1;
    bool near = false;
    for (int face = 0; face < 6; face++) {
        uint32_t count = plane_counts(c, face, x);
        if (count >= c->near[face / 2])
            continue;
        open[face / 2] -= plane_value(c->planes.volume, (float)count * c->q_per_count[face / 2]);
        near = true;
    }
    return near;
}

/* Drag of a plane across axis n at q with no_slip, 1/s along each axis, where `part` of it counts. */
static inline void explicit_drag(const struct explicit_constants *c, int fluid, int n, float q,
                                 float part, float density, float drag[3])
{
    float near = 0.5f * c->spacing / c->h, lever = 1 / (q > near ? q : near);
    float scale = 2 * c->viscosity[fluid] / (density * c->h * c->h) * part;
    for (int a = 0; a < 3; a++)
        drag[a] = scale * (plane_value(c->planes.drag[a == n], q) +
                           plane_value(c->planes.lever[a == n], q) * lever);
}

/* Half spaces of wall behind closed faces, by closed integrals. The wall repeats the particle's
 * pressure (never sucks) and, where that pushes, continues it hydrostatically (Adami et al. 2012), or
 * fluid along a wall would sink; its velocity continues the particle's linearly through that of the
 * plane (zero, unless it moves along itself), in the normal direction always, along the plane only
 * with no_slip, so that a linear profile has its exact divergence and no spurious drag. Without
 * `pushes` it only drags; `thrust` is the part of p_i + p_wall that counts (solver/shift.h). */
static inline void explicit_walls(const struct explicit_constants *c, int fluid,
                                  const struct position *x, const struct motion *v, float density,
                                  bool pushes, float thrust, struct rate *rate)
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
        float inward = face & 1 ? -1.0f : 1.0f, near = 0.5f * c->spacing / c->h;
        float lever = 1 / (q > near ? q : near);
        if (pushes) {
            float area = c->normal * part * plane_value(c->planes.area, q) / c->h;
            float p = thrust * (v->pressure + (v->pressure > 0 ? v->pressure : 0));
            float closing = part * plane_value(c->planes.volume, q) * lever / c->h + area;
            rate->acceleration[n] += inward * p * area / density;
            rate->density -= density * inward * v->velocity[n] * closing;
            float share = part * plane_value(c->planes.volume, q);
            for (int a = 0; a < 3 && v->pressure > 0; a++)
                rate->acceleration[a] -=
                    c->gravity[a] * (share + (a == n ? q * c->h * area : 0));
        }
        if (!c->no_slip || c->viscosity[fluid] == 0)
            continue;
        float drag[3];
        explicit_drag(c, fluid, n, q, part, density, drag);
        for (int a = 0; a < 3; a++)
            rate->acceleration[a] -= drag[a] * (v->velocity[a] - c->wall_velocity[face][a]);
    }
}

/* Density by summation from `number` = sum of w, plus the half spaces' share. */
static inline float explicit_summed_density(const struct explicit_constants *c, int fluid,
                                            const struct position *x, float number)
{
    float open[3];
    explicit_open(c, x, open);
    float density = c->mass[fluid] * (c->number_density * number + 1 - open[0] * open[1] * open[2]);
    /* Missing neighbours at a free surface are no expansion: without negative pressure density
     * stays at rest density there, or V = m/rho would multiply every force on the particle. */
    return c->clamp && density < c->rest_density[fluid] ? c->rest_density[fluid] : density;
}

#endif
