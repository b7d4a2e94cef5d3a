/* Instruction sets: one row each, all compiled from the same loops (pair_loops.h). */
#ifndef BACKEND_CPU_ISA_H
#define BACKEND_CPU_ISA_H

#include "base/variant.h"
#include "grid/search.h"
#include "particles/particles.h"
#include "solver/diffusion.h"
#include "solver/implicit.h"
#include "solver/pair_constants.h"
#include "solver/projection.h"
#include "solver/shift.h"
#include "solver/tension.h"

#include <stdbool.h>

/* Neighbour rows of one block of 16 particles: entry k of lane l is index[16 k + l]; lanes with
 * fewer than `length` neighbours repeat the particle itself. An entry is twice the neighbour's
 * index, which times 8 is the address of its 16-byte record in one addressing mode. */
struct row_block {
    uint32_t *index;
    float *weight;   /* of each entry, where a solver keeps them (struct rows) */
    uint32_t length;
};

/* What a row build reads. `points` are the particles that get rows, `axis` the candidates. */
struct row_build {
    const struct cells *cells;
    const struct search_row *search;
    const struct position *points;
    size_t point_count;
    const uint32_t *axis[3];  /* candidates' coordinates, padded by a block */
    size_t candidate_count;
    bool same;                /* candidates are the points: leave the particle itself out */
    float scale[3];           /* counts to smoothing lengths */
    float limit;              /* square of the list radius, in smoothing lengths */
    float coincident;         /* and of the distance below which two share a place; 0: none does */
};

/* Rows of one block as they are being built: 16 lists of `room` entries each. */
struct row_scratch {
    uint32_t *list;
    size_t room;
    bool coincident; /* whether any neighbour so far is so near */
    uint32_t count[PARTICLE_BLOCK];
};

/* What the implicit solver's passes read and write besides. */
struct solve_work {
    const struct explicit_constants *each;
    const struct implicit_constants *implicit;
    enum solve solve;
    float dt;                   /* s */
    float relax;                /* times the solver's relaxation */
    float momentum;             /* of the sweeps */
    float target, offset;       /* density ratio, and compression that sweeps count from */
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
    const struct explicit_constants *each;
    const uint32_t *id;
    const float *surface; /* l of the last step */
    struct shift *now;
    float *surface_now;
    float closeness;      /* 1 / w(d) */
};

/* What the passes of density diffusion by gradients read and write besides. */
struct diffusion_work {
    const struct explicit_constants *each;
    struct gradient *gradient;
};

/* What the passes of surface tension read and write besides. */
struct tension_work {
    const struct explicit_constants *each;
    const struct tension_constants *constants;
    const float *fluid; /* index per particle; NULL: one fluid */
    struct normal *normal;
    float *pressure; /* written by the tension pass, Pa; NULL: an acceleration is */
};

/* What the projection solver's passes read and write besides. */
struct projection_work {
    const struct explicit_constants *each;
    const struct projection_constants *constants;
    const uint32_t *id;
    float before, dt; /* s: the step that led to these positions, and the one that leaves them */
    struct stencil *stencil;
    struct unknown *unknown;
    struct trial *trial;
    struct motion *motion;
    float *density, *surface, *direction, *product;
    const float *violent; /* surface, as the step before left it */
};

/* What a pair pass reads and writes; arrays are those of struct particles. */
struct pair_work {
    struct pair_constants constants;
    const struct position *position;
    const struct motion *motion;
    const float *viscosity;    /* per particle, or NULL */
    const float *rest;         /* rest density per particle; only with PAIR_MIXED */
    const float *density;      /* present density, kg/m^3; NULL: at rest density */
    const float *rest_density; /* of each fluid, kg/m^3 */
    const float *softness;     /* c0 / speed of sound of each fluid; NULL: all 1 */
    const float *inverse_density; /* 1 / rest density per particle; NULL: all fluids are alike */
    const uint8_t *fluid;      /* or NULL */
    const struct shift *shift; /* of the last step; NULL: no shifting */
    struct rate *rate;         /* written by the force pass */
    float *vorticity;          /* written by the curl pass, 1/s */
    float *number;             /* written by the density pass: sum w, to be scaled */
    const struct row_block *rows;
    const uint32_t *row_count; /* neighbours of each particle, padded to blocks */
    const struct position *wall;         /* wall particles, or NULL */
    const struct row_block *wall_rows;
    const uint32_t *wall_row_count;
    size_t count;
    const struct solve_work *solve;      /* of the implicit solver's passes, or NULL */
    const struct diffusion_work *diffusion; /* of the passes of diffusion by gradients, or NULL */
    const struct shift_work *shifting;   /* of the shifting pass, or NULL */
    const struct projection_work *projection; /* of the projection solver's passes, or NULL */
    const struct tension_work *tension;  /* of the passes of surface tension, or NULL */
};

typedef void pair_function(const struct pair_work *work, size_t first_block, size_t last_block);

enum pair_pass {
    PAIR_PASS_DENSITY,
    PAIR_PASS_FORCE,
    PAIR_PASS_GRADIENT,  /* writes diffusion->gradient */
    PAIR_PASS_DIFFUSION, /* adds to rate */
    PAIR_PASS_SHIFT,   /* writes shifting->now, surface_now */
    PAIR_PASS_NORMALS, /* writes tension->normal */
    PAIR_PASS_TENSION, /* adds to rate, or writes tension->pressure */
    PAIR_PASS_FACTOR,
    PAIR_PASS_PUSH,    /* writes solve->flux */
    PAIR_PASS_PROJECT, /* adds the push to solve->motion */
    PAIR_PASS_SWEEP,
    PAIR_PASS_DRAG_DIAGONAL, /* writes solve->product, block */
    PAIR_PASS_DRAG,
    PAIR_PASS_STENCIL, /* writes projection->stencil, density, surface and the rows' weights */
    PAIR_PASS_SURFACE, /* completes projection->stencil, begins unknown */
    PAIR_PASS_JUMP,    /* writes stencil->jump */
    PAIR_PASS_FLOW,    /* writes the rows of Poisson's equation and direction */
    PAIR_PASS_PRODUCT, /* writes projection->product */
    PAIR_PASS_SLOPES,  /* writes projection->motion, rate, stencil->crowd */
    PAIR_PASS_CURL     /* writes vorticity */
};

struct isa_row {
    struct variant variant;
    bool (*supported)(void);
    /* Lists of the particles of `block`; returns 0, or the room that the lists need. */
    size_t (*build)(const struct row_build *work, size_t block, struct row_scratch *scratch);
    /* Turns 16 lists into rows[k][16], k up to `length` rounded up to 4. */
    void (*interleave)(const struct row_scratch *scratch, uint32_t length, uint32_t *rows);
    pair_function *(*find)(enum pair_pass pass, unsigned flags, bool walls);
    /* Seconds-free peak probe: `rounds` dependent chains of FMA in all lanes; returns the FLOPs. */
    double (*peak)(long rounds, float *sink);
};

extern const struct variant_table isa_table; /* "isas" */
extern const struct isa_row isa_scalar, isa_avx2, isa_avx512;

#endif
