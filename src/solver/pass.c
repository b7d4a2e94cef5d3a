/* The table of passes. */
#include "solver/pass.h"

#include "particles/particles.h"

enum {
    POSITION = FIELD_BIT(FIELD_POSITION),
    MOTION = FIELD_BIT(FIELD_MOTION),
    DENSITY = FIELD_BIT(FIELD_DENSITY),
    RATE = FIELD_BIT(FIELD_RATE),
    ID = FIELD_BIT(FIELD_ID),
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
};
