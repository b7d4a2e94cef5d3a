/* Viscosity by solving, for fluids so thick that explicit steps would be tiny.
 *
 * v = v* + dt A v by backward Euler, where A is the operator that the force pass and the walls apply
 * explicitly (pair_viscosity in solver/pair.h),
 *   (A v)_i = 1/rho0_i sum_j V_j (mu_i + mu_j) W'/r v_ij - wall_i v_i + pull_i        (Morris et al. 1997)
 * or with what lies along x_ij for v_ij (Weiler et al. 2018); wall_i v_i - pull_i is the drag of closed
 * planes and of wall particles. M = 1 - dt A is symmetric when multiplied by mass, so
 * that conjugate gradients solve M v = v* + dt pull without a matrix. What they are preconditioned by
 * is the diagonal, which with Morris's operator is the same for x, y and z, and otherwise blocks of
 * 3 x 3. No eigenvalue of M is below 1: the error of v is at most the residual.
 * In the common subset of C and CUDA. */
#ifndef SOLVER_DRAG_H
#define SOLVER_DRAG_H

#include "solver/drag_block.h"
#include "solver/explicit.h"

/* Vectors of the solve: 16-byte records, of which the matrix reads one of each neighbour. */
struct drag {
    alignas(16) float along[3];
    float own; /* search: mu, Pa s; with Morris's operator remainder: drag of the closed planes, 1/s;
                  product: diagonal */
};

/* Drag of the closed planes: a = pull - own v. */
struct drag_planes {
    float pull[3], own[3];
};

static inline struct drag_planes drag_planes(const struct explicit_constants *c, int fluid,
                                             const struct position *x)
{
    struct drag_planes planes = {{0}, {0}};
    float open[3], drag[3];
    if (!c->no_slip || c->viscosity[fluid] == 0 || !explicit_open(c, x, open))
        return planes;
    for (int face = 0; face < 6; face++) {
        int n = face / 2;
        uint32_t count = plane_counts(c, face, x);
        if (count >= c->near[n])
            continue;
        float part = open[(n + 1) % 3] * open[(n + 2) % 3];
        explicit_drag(c, fluid, n, (float)count * c->q_per_count[n], part, c->rest_density[fluid],
                      drag);
        for (int a = 0; a < 3; a++) {
            planes.own[a] += drag[a];
            planes.pull[a] += drag[a] * c->wall_velocity[face][a];
        }
    }
    return planes;
}

/* Their drag along axis a, 1/s. `block` is NULL with Morris's operator, here and below. */
static inline float drag_wall(const struct drag *remainder, const struct drag_block *block, int a)
{
    return block ? block->wall[a] : remainder->own;
}

/* Before the first product: the search vector becomes v*, the remainder the right-hand side. */
static inline void drag_begin(const struct explicit_constants *c, int fluid, float dt,
                              const struct position *x, const struct motion *v,
                              struct drag *search, struct drag *remainder, struct drag_block *block)
{
    struct drag_planes planes = drag_planes(c, fluid, x);
    for (int a = 0; a < 3; a++) {
        search->along[a] = v->velocity[a];
        remainder->along[a] = v->velocity[a] + dt * planes.pull[a];
        if (block)
            block->wall[a] = planes.own[a];
    }
    search->own = c->viscosity[fluid];
    remainder->own = planes.own[0];
}

/* The square of the velocities at play: v* and that of the walls near. */
static inline double drag_speed2(float dt, const struct drag *search, const struct drag *remainder,
                                 const struct drag_block *block)
{
    double sum = 0;
    for (int a = 0; a < 3; a++) {
        double drag = (double)dt * (double)drag_wall(remainder, block, a);
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
static inline void drag_product(float dt, float front, const struct drag *search,
                                const struct drag *remainder, const struct drag_block *block,
                                const float sum[3], struct drag *product)
{
    for (int a = 0; a < 3; a++) {
        float settled = fabsf(sum[a]) < 1e-20f ? 0 : sum[a];
        float wall = drag_wall(remainder, block, a);
        product->along[a] = search->along[a] + dt * (wall * search->along[a] - front * settled);
    }
}

/* The preconditioner, from the sums of weights of struct pair_drags. */
static inline void drag_diagonal(float dt, float front, const float weight[6],
                                 const struct drag *remainder, struct drag_block *block,
                                 struct drag *product)
{
    if (block)
        drag_block_factor(dt, front, weight, block);
    else
        product->own = 1 + dt * (remainder->own - front * weight[0]);
}

/* The preconditioned residual. */
static inline struct drag drag_conditioned(const struct drag *remainder, const struct drag *product,
                                           const struct drag_block *block)
{
    struct drag z = {{0, 0, 0}, 0};
    if (block)
        drag_block_solve(block, remainder->along, z.along);
    for (int a = 0; a < 3 && !block; a++)
        z.along[a] = remainder->along[a] / product->own;
    return z;
}

#endif
