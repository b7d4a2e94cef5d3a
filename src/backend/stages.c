/* The table of the stages of each pass. */
#include "backend/stages.h"

#define PAIRS(pass) {.is_pair = true, .pair = PAIR_PASS_##pass}
#define RUN(name) {.id = STAGE_##name}
#define WHEN(condition, name) {.id = STAGE_##name, .when = STAGE_##condition}

static const struct pass_stages {
    size_t count;
    struct stage stage[STAGES_MAX];
} table[PASS_COUNT] = {
    [PASS_PREDICT] = {3, {RUN(no_extremes), RUN(predict), WHEN(OBSTACLES, stop)}},
    [PASS_DENSITY] = {1, {PAIRS(DENSITY)}},
    [PASS_PRESSURE] = {1, {RUN(pressure)}},
    [PASS_FORCE] = {1, {PAIRS(FORCE)}},
    [PASS_GRADIENT] = {1, {PAIRS(GRADIENT)}},
    [PASS_DIFFUSION] = {1, {PAIRS(DIFFUSION)}},
    [PASS_EXTERNAL] = {1, {RUN(external)}},
    [PASS_NORMALS] = {2, {WHEN(FLUIDS, fluids), PAIRS(NORMALS)}},
    [PASS_TENSION] = {1, {PAIRS(TENSION)}},
    [PASS_CURVATURE] = {1, {PAIRS(TENSION)}},
    [PASS_JUMP] = {1, {PAIRS(JUMP)}},
    [PASS_WALLS] = {1, {RUN(walls)}},
    [PASS_SHIFT] = {1, {PAIRS(SHIFT)}},
    [PASS_CORRECT] = {1, {RUN(correct)}},
    [PASS_FACTOR] = {4, {WHEN(INVERSE, inverse_densities), PAIRS(FACTOR), WHEN(ENCLOSED, excess),
                         RUN(target)}},
    [PASS_SOLVE_VELOCITY] = {1, {RUN(loop_begins)}},
    [PASS_SOLVE_SHIFT] = {1, {RUN(loop_begins)}},
    [PASS_SOLVE_VISCOSITY] = {1, {RUN(loop_begins)}},
    [PASS_SOLVED] = {1, {RUN(loop_goes_on)}},
    [PASS_PUSH] = {1, {PAIRS(PUSH)}},
    [PASS_SWEEP] = {2, {PAIRS(SWEEP), RUN(swept)}},
    [PASS_PROJECT] = {1, {PAIRS(PROJECT)}},
    [PASS_KICK] = {1, {RUN(kick)}},
    [PASS_DRAG_BEGIN] = {1, {RUN(drag_begin)}},
    [PASS_DRAG_DIAGONAL] = {1, {PAIRS(DRAG_DIAGONAL)}},
    [PASS_DRAG_RESIDUAL] = {2, {RUN(drag_residual), RUN(drag_residual_found)}},
    [PASS_DRAG_MATRIX] = {1, {PAIRS(DRAG)}},
    [PASS_DRAG_STEP] = {5, {RUN(drag_curvature), RUN(drag_length), RUN(drag_ahead), RUN(drag_keep),
                            RUN(drag_turn)}},
    [PASS_DRAG_END] = {1, {RUN(drag_end)}},
    [PASS_RESUME] = {1, {RUN(resume)}},
    [PASS_MOVE] = {3, {RUN(no_extremes), RUN(move), WHEN(OBSTACLES, stop)}},
    [PASS_REWIND] = {1, {RUN(rewind)}},
    [PASS_STENCIL] = {2, {WHEN(INVERSE, inverse_densities), PAIRS(STENCIL)}},
    [PASS_SURFACE] = {1, {PAIRS(SURFACE)}},
    [PASS_ADVANCE] = {1, {RUN(advance)}},
    [PASS_FLOW] = {1, {PAIRS(FLOW)}},
    [PASS_CROWDING] = {3, {WHEN(ENCLOSED, lack), WHEN(ENCLOSED, crowding_mean), RUN(crowding)}},
    [PASS_PRODUCT] = {1, {PAIRS(PRODUCT)}},
    [PASS_RESIDUAL] = {4, {WHEN(ENCLOSED, left), WHEN(ENCLOSED, residual_mean), RUN(residual),
                           RUN(residual_found)}},
    [PASS_DESCENT] = {5, {RUN(curvature), RUN(descent_length), RUN(ahead), RUN(descent_keep),
                          RUN(turn)}},
    [PASS_SLOPES] = {2, {RUN(shifted), PAIRS(SLOPES)}},
    [PASS_DRIFT] = {3, {RUN(no_extremes), RUN(drift), WHEN(OBSTACLES, stop)}},
};

const struct stage *stages_of(enum pass_id pass, size_t *count)
{
    *count = table[pass].count;
    return table[pass].stage;
}

bool stage_is_scalar(const struct stage *stage)
{
    enum { EACH, EXTREMES, BLOCKS, SUMS, FIXED, SCALAR };
    static const char kinds[STAGE_COUNT] = {
#define STAGE(kind, name, terms) kind,
#include "backend/bodies/stage_list.h"
#undef STAGE
    };
    return !stage->is_pair && kinds[stage->id] == SCALAR;
}

bool stage_wanted(const struct stage *stage, const struct solver_choice *choice,
                  const struct work *work)
{
    switch (stage->when) {
    case STAGE_ENCLOSED: return choice->enclosed;
    case STAGE_INVERSE: return work->inverse_density != NULL;
    case STAGE_FLUIDS: return work->tension.fluid != NULL;
    case STAGE_OBSTACLES: return choice->each.obstacles.count > 0;
    case STAGE_ALWAYS: break;
    }
    return true;
}
