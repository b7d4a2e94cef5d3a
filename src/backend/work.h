/* What passes read and write: the arrays and constants that the bodies of every back end see.
 *
 * A plain record of pointers and numbers: a back end that keeps particles elsewhere fills it with
 * addresses there, and hands it over as it is. In the common subset of C and CUDA. */
#ifndef BACKEND_WORK_H
#define BACKEND_WORK_H

#include "backend/scalars.h"
#include "particles/particles.h"
#include "solver/diffusion.h"
#include "solver/pair_constants.h"
#include "solver/pass.h"
#include "solver/shift.h"
#include "solver/solver.h"

#include <stdbool.h>

/* Neighbour rows of one block of 16 particles: entry k of lane l is index[16 k + l]; lanes with
 * fewer than `length` neighbours repeat the particle itself. An entry is twice the neighbour's
 * index, which times 8 is the address of its 16-byte record in one addressing mode. */
struct row_block {
    uint32_t *index;
    float *weight;   /* of each entry, where a solver keeps them */
    uint32_t length;
};

/* What the implicit solver's passes read and write besides. */
struct solve_work {
    struct position *load;
    struct motion *flux, *motion;
    struct factor *factor;
    struct warm *warm;
    struct drag *search, *remainder, *product;
    struct drag_block *block;   /* only with PAIR_CENTRAL */
    float *density;
    int64_t *residual;          /* of each block: error and signed compression, in 2^-40 */
};

/* What the pass of particle shifting reads and writes besides. */
struct shift_work {
    const float *surface; /* l of the last step */
    struct shift *now;
    float *surface_now;
};

/* What the passes of surface tension read and write besides. */
struct tension_work {
    float *fluid;    /* index per particle; NULL: one fluid */
    struct normal *normal;
    float *pressure; /* written by the tension pass, Pa; NULL: an acceleration is */
};

/* What the projection solver's passes read and write besides. */
struct projection_work {
    struct stencil *stencil;
    struct unknown *unknown;
    struct trial *trial;
    float *surface, *direction, *product;
    const float *violent; /* surface, as the step before left it */
};

/* The state before a step and the present one, for the passes over particles. */
struct state_work {
    struct position *position;
    struct motion *motion;
    float *density;
    const struct position *position0;
    const struct motion *motion0;
    const float *density0;
    const struct rate *rate0;
};

/* Arrays are those of struct particles. */
struct work {
    size_t count;
    enum solve solve_of;       /* that the pass belongs to, or comes before */
    bool looping;              /* a sweep of it: nothing to do when it has ended */
    unsigned block;            /* on a GPU: threads of a block of sums over neighbours; 0: as kernels like */
    struct pair_constants constants;
    const struct solver_choice *choice; /* where bodies run */
    struct scalars *scalars;            /* there, too */
    const uint32_t *id;
    const uint8_t *fluid;      /* or NULL */
    const struct position *position; /* that forces are evaluated at */
    const struct motion *motion;
    const float *viscosity;    /* per particle, or NULL */
    float *rest;               /* rest density per particle; only with PAIR_MIXED */
    const float *density;      /* present density, kg/m^3; NULL: at rest density */
    bool soft;                 /* fluids differ in the speed of sound (softness) */
    float *inverse_density;    /* 1 / rest density per particle; NULL: all fluids are alike */
    const struct shift *shift; /* of the last step; NULL: no shifting */
    struct rate *rate;         /* written by the force pass; NULL: gravity alone accelerates */
    struct gradient *gradient; /* of density diffusion by gradients */
    float *vorticity;          /* written by the curl pass, 1/s */
    float *number;             /* written by the density pass: sum w, to be scaled */
    struct position *parted;   /* places of particles that were moved apart */
    const struct row_block *rows;
    const uint32_t *row_count; /* neighbours of each particle, padded to blocks */
    const struct position *wall;         /* wall particles, or NULL */
    const struct row_block *wall_rows;
    const uint32_t *wall_row_count;
    struct state_work state;
    struct solve_work solve;
    struct shift_work shifting;
    struct tension_work tension;
    struct projection_work projection;
};

/* Arrays that back ends make besides those of the particles; each may be NULL. */
struct work_arrays {
    float *number, *inverse_density, *fluid, *rest;
    int64_t *residual;
};

/* Neighbour rows, and those of wall particles. */
struct work_rows {
    const struct row_block *block, *wall_block;
    const uint32_t *count, *wall_count;
};

/* What a pass works on. `choice` is read here, bodies read it at `there`. */
struct work work_make(enum pass_id pass, enum solve solve, bool looping,
                      const struct solver_choice *choice,
                      const struct solver_choice *there, struct scalars *scalars,
                      const struct particles *particles, const struct position *wall,
                      const struct work_arrays *arrays, const struct work_rows *rows);

/* Whether the pass is of a solve that has ended: sweeps may be queued before that is known. */
static inline bool work_ended(const struct work *w)
{
    return w->looping && !w->scalars->loop.again;
}

/* How many particles there are, to divide by. */
static inline double work_particles(const struct work *w)
{
    return w->count ? (double)w->count : 1;
}

/* The fluid of a particle. */
static inline int work_fluid(const struct work *w, size_t i)
{
    return w->fluid ? w->fluid[i] : 0;
}

#endif
