/* Passes of a time step: what each is for, reads and writes. The plan orders and checks them. */
#ifndef SOLVER_PASS_H
#define SOLVER_PASS_H

enum pass_kind {
    PASS_EACH, /* one loop over particles; REDUCE when it also finds extremes */
    PASS_PAIR, /* each particle sums over its neighbours */
    PASS_ORDER, /* sorting and neighbour rows */
    PASS_LOOP, /* the passes up to the next PASS_END repeat until their residual is small */
    PASS_END
};

enum pass_id {
    PASS_SORT,
    PASS_NEIGHBOURS,
    PASS_PREDICT,
    PASS_DENSITY,
    PASS_PRESSURE,
    PASS_NORMALS,
    PASS_FORCE,
    PASS_GRADIENT,
    PASS_DIFFUSION,
    PASS_EXTERNAL,
    PASS_TENSION,
    PASS_CURVATURE,
    PASS_JUMP,
    PASS_WALLS,
    PASS_SHIFT,
    PASS_CORRECT,
    PASS_FACTOR,
    PASS_SOLVE_VELOCITY,
    PASS_SOLVE_SHIFT,
    PASS_PUSH,
    PASS_SWEEP,
    PASS_SOLVED,
    PASS_PROJECT,
    PASS_KICK,
    PASS_DRAG_BEGIN,
    PASS_DRAG_DIAGONAL,
    PASS_DRAG_RESIDUAL,
    PASS_SOLVE_VISCOSITY,
    PASS_DRAG_MATRIX,
    PASS_DRAG_STEP,
    PASS_DRAG_END,
    PASS_RESUME,
    PASS_MOVE,
    PASS_REWIND,
    PASS_STENCIL,
    PASS_SURFACE,
    PASS_ADVANCE,
    PASS_FLOW,
    PASS_CROWDING,
    PASS_PRODUCT,
    PASS_RESIDUAL,
    PASS_DESCENT,
    PASS_SLOPES,
    PASS_DRIFT,
    PASS_CURL, /* before a frame, not in a step */
    PASS_COUNT
};

enum { STEP_PASSES_MAX = 32 }; /* of one step; a pass may occur more than once */

struct pass_row {
    enum pass_id id;
    enum pass_kind kind;
    const char *name, *doc;
    unsigned reads, writes;  /* FIELD_BIT masks */
};

extern const struct pass_row pass_table[PASS_COUNT];

#endif
