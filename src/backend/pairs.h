/* The pair passes: which body of bodies/ each one runs, for the flags of a solver. */
#ifndef BACKEND_PAIRS_H
#define BACKEND_PAIRS_H

#include "backend/work.h"

enum pair_pass {
    PAIR_PASS_DENSITY,
    PAIR_PASS_FORCE,
    PAIR_PASS_GRADIENT,  /* writes gradient */
    PAIR_PASS_DIFFUSION, /* adds to rate */
    PAIR_PASS_SHIFT,   /* writes shifting.now, surface_now */
    PAIR_PASS_NORMALS, /* writes tension.normal */
    PAIR_PASS_TENSION, /* adds to rate, or writes tension.pressure */
    PAIR_PASS_FACTOR,
    PAIR_PASS_PUSH,    /* writes solve.flux */
    PAIR_PASS_PROJECT, /* adds the push to solve.motion */
    PAIR_PASS_SWEEP,
    PAIR_PASS_DRAG_DIAGONAL, /* writes solve.product, block */
    PAIR_PASS_DRAG,
    PAIR_PASS_STENCIL, /* writes projection.stencil, density, surface and the rows' weights */
    PAIR_PASS_SURFACE, /* completes projection.stencil, begins unknown */
    PAIR_PASS_JUMP,    /* writes stencil->jump */
    PAIR_PASS_FLOW,    /* writes the rows of Poisson's equation and direction */
    PAIR_PASS_PRODUCT, /* writes projection.product */
    PAIR_PASS_SLOPES,  /* writes state.motion, rate, stencil->crowd */
    PAIR_PASS_CURL,    /* writes vorticity */
    PAIR_PASS_COUNT
};

enum pair_body {
#define PAIR(name, call) BODY_##name,
#include "backend/bodies/pair_list.h"
#undef PAIR
#define FORCE(flags) BODY_force_##flags, BODY_force_walls_##flags,
#include "backend/bodies/force_list.h"
#undef FORCE
    BODY_COUNT
};

/* The body of a pass; BODY_COUNT when a solver never asks for it. */
enum pair_body pair_find(enum pair_pass pass, const struct work *work, unsigned flags);

#endif
