/* Stages of passes: what back ends run one after the other for a pass. */
#ifndef BACKEND_STAGES_H
#define BACKEND_STAGES_H

#include "backend/pairs.h"
#include "backend/work.h"

enum stage_id {
#define STAGE(kind, name, terms) STAGE_##name,
#include "backend/bodies/stage_list.h"
#undef STAGE
    STAGE_COUNT
};

/* When a stage has work to do. */
enum stage_when {
    STAGE_ALWAYS,
    STAGE_ENCLOSED, /* fluid has no surface */
    STAGE_INVERSE,  /* fluids differ in density, and the pass reads its inverse */
    STAGE_FLUIDS,   /* there are several */
    STAGE_OBSTACLES /* there is any */
};

struct stage {
    bool is_pair;       /* one of the pair passes, else a row of stage_list.h */
    enum pair_pass pair;
    enum stage_id id;
    enum stage_when when;
};

enum { STAGES_MAX = 6 };

/* Stages of a pass in order; *count is 0 for passes that back ends do in their own ways. */
const struct stage *stages_of(enum pass_id pass, size_t *count);

/* Whether a stage works on the scalars alone. */
bool stage_is_scalar(const struct stage *stage);

/* Whether a stage of a pass on `work` is to be run. */
bool stage_wanted(const struct stage *stage, const struct solver_choice *choice,
                  const struct work *work);

#endif
