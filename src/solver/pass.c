/* The table of passes. */
#include "solver/pass.h"

#include "particles/particles.h"

enum {
    POSITION = FIELD_BIT(FIELD_POSITION),
    MOTION = FIELD_BIT(FIELD_MOTION),
    DENSITY = FIELD_BIT(FIELD_DENSITY),
    RATE = FIELD_BIT(FIELD_RATE),
    ID = FIELD_BIT(FIELD_ID),
    LOAD = FIELD_BIT(FIELD_LOAD),
    FLUX = FIELD_BIT(FIELD_FLUX),
    FACTOR = FIELD_BIT(FIELD_FACTOR),
    WARM = FIELD_BIT(FIELD_WARM),
};

const struct pass_row pass_table[PASS_COUNT] = {
    [PASS_SORT] = {PASS_SORT, PASS_ORDER, "sort", "particles into canonical order, when they moved far",
                   POSITION | ID, POSITION | MOTION | DENSITY | RATE | ID},
    [PASS_NEIGHBOURS] = {PASS_NEIGHBOURS, PASS_ORDER, "neighbours", "rows of neighbours, after a sort",
                         POSITION, 0},
    [PASS_PREDICT] = {PASS_PREDICT, PASS_EACH, "predict", "half kick, drift, bounce; extremes",
                      POSITION | MOTION | DENSITY | RATE, POSITION | MOTION | DENSITY},
    [PASS_DENSITY] = {PASS_DENSITY, PASS_PAIR, "density", "density by summation", POSITION, DENSITY},
    [PASS_PRESSURE] = {PASS_PRESSURE, PASS_EACH, "pressure", "wall share of density, equation of state",
                       POSITION | DENSITY, POSITION | MOTION | DENSITY},
    [PASS_FORCE] = {PASS_FORCE, PASS_PAIR, "force", "acceleration and density rate",
                    POSITION | MOTION | DENSITY, RATE},
    [PASS_WALLS] = {PASS_WALLS, PASS_EACH, "walls", "half spaces behind closed faces",
                    POSITION | MOTION | DENSITY, RATE},
    [PASS_CORRECT] = {PASS_CORRECT, PASS_EACH, "correct", "second half kick; extremes",
                      MOTION | DENSITY | RATE, MOTION | DENSITY},
    [PASS_FACTOR] = {PASS_FACTOR, PASS_PAIR, "factor", "density by summation, gradient sums, diagonal",
                     POSITION | MOTION, DENSITY | FACTOR | MOTION | LOAD},
    [PASS_SOLVE_VELOCITY] = {PASS_SOLVE_VELOCITY, PASS_LOOP, "velocity",
                             "until the velocity is divergence-free", 0, 0},
    [PASS_SOLVE_SHIFT] = {PASS_SOLVE_SHIFT, PASS_LOOP, "shift",
                          "until no density exceeds the rest density", 0, 0},
    [PASS_PUSH] = {PASS_PUSH, PASS_PAIR, "push", "trial velocity from the trial pressure",
                   POSITION | MOTION | LOAD | FACTOR, FLUX},
    [PASS_SWEEP] = {PASS_SWEEP, PASS_PAIR, "sweep", "compression of the trial velocity, pressure",
                    POSITION | MOTION | DENSITY | FLUX | FACTOR, MOTION | LOAD},
    [PASS_SOLVED] = {PASS_SOLVED, PASS_END, "solved", "end of the loop", 0, 0},
    [PASS_PROJECT] = {PASS_PROJECT, PASS_PAIR, "project", "velocity by pressure",
                      POSITION | MOTION | LOAD | FACTOR, MOTION | FLUX | WARM},
    [PASS_KICK] = {PASS_KICK, PASS_EACH, "kick", "gravity and viscosity; pressure of the last step",
                   MOTION | WARM, MOTION | LOAD},
    [PASS_RESUME] = {PASS_RESUME, PASS_EACH, "resume", "the last step's shift, to start from",
                     WARM, MOTION | LOAD | WARM},
    [PASS_MOVE] = {PASS_MOVE, PASS_EACH, "move", "drift and shift, bounce; extremes",
                   POSITION | MOTION | FLUX | WARM, POSITION | MOTION},
};
