/* Viscosity by solving, for fluids so thick that explicit steps would be tiny.
 *
 * v = v* + dt A v by backward Euler, where A is the operator that the force pass and the walls apply
 * explicitly (Morris et al. 1997),
 *   (A v)_i = 1/rho0_i sum_j V_j (mu_i + mu_j) W'/r v_ij - wall_i v_i + pull_i
 * wall_i v_i - pull_i being the drag of closed planes and of wall particles. M = 1 - dt A is the same
 * for x, y and z, and symmetric when multiplied by mass, so that conjugate gradients with its
 * diagonal as preconditioner solve M v = v* + dt pull without a matrix (Weiler et al. 2018, who use
 * another operator). No eigenvalue of M is below 1: the error of v is at most the residual.
 * In the common subset of C and CUDA. */
#ifndef SOLVER_DRAG_H
#define SOLVER_DRAG_H

#include "solver/explicit.h"

/* Vectors of the solve: 16-byte records, of which the matrix reads one of each neighbour. */
struct drag {
    float along[3];
    float own; /* search: mu, Pa s; remainder: drag of the closed planes, 1/s; product: diagonal */
};

/* Drag of the closed planes: a = pull - own v. */
static inline struct drag drag_walls(const struct explicit_constants *c, int fluid,
                                     const struct position *x)
{
    struct drag walls = {{0, 0, 0}, 0};
    float open[3];
    if (!c->no_slip || c->viscosity[fluid] == 0 || !explicit_open(c, x, open))
        return walls;
    for (int face = 0; face < 6; face++) {
        int n = face / 2;
        uint32_t count = plane_counts(c, face, x);
        if (count >= c->near[n])
            continue;
        float part = open[(n + 1) % 3] * open[(n + 2) % 3];
        float scale = explicit_drag(c, fluid, (float)count * c->q_per_count[n], part,
                                    c->rest_density[fluid]);
        walls.own += scale;
        for (int a = 0; a < 3; a++)
            walls.along[a] += scale * c->wall_velocity[face][a];
    }
    return walls;
}

/* Before the first product: the search vector becomes v*, the remainder the right-hand side. */
static inline void drag_begin(const struct explicit_constants *c, int fluid, float dt,
                              const struct position *x, const struct motion *v,
                              struct drag *search, struct drag *remainder)
{
    struct drag walls = drag_walls(c, fluid, x);
    for (int a = 0; a < 3; a++) {
        search->along[a] = v->velocity[a];
        remainder->along[a] = v->velocity[a] + dt * walls.along[a];
    }
    search->own = c->viscosity[fluid];
    remainder->own = walls.own;
}

/* The square of the velocities at play: v* and that of the walls near. */
static inline double drag_speed2(float dt, const struct drag *search, const struct drag *remainder)
{
    double sum = 0, drag = (double)dt * (double)remainder->own;
    for (int a = 0; a < 3; a++) {
        double v = (double)search->along[a], pull = (double)remainder->along[a] - v;
        double wall = drag > 0 ? pull / drag : 0;
        sum += v * v + wall * wall;
    }
    return sum;
}

static inline double drag_dot(const struct drag *a, const struct drag *b)
{
    double sum = 0;
    for (int k = 0; k < 3; k++)
        sum += (double)a->along[k] * (double)b->along[k];
    return sum;
}

/* (M search)_i from sum = sum V_j (mu_i + mu_j) slope (search_i - search_j), times front. */
static inline void drag_product(float dt, float front, const struct drag *search, float wall,
                                const float sum[3], struct drag *product)
{
    for (int a = 0; a < 3; a++) {
        float settled = fabsf(sum[a]) < 1e-20f ? 0 : sum[a];
        product->along[a] = search->along[a] + dt * (wall * search->along[a] - front * settled);
    }
}

#endif
