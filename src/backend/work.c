/* Fills the record of what a pass works on. */
#include "backend/work.h"

static struct state_work state_make(const struct particles *p)
{
    return (struct state_work){
        .position = particles_position(p),
        .motion = particles_motion(p),
        .density = particles_density(p),
        .position0 = p->before[FIELD_POSITION],
        .motion0 = p->before[FIELD_MOTION],
        .density0 = p->before[FIELD_DENSITY],
        .rate0 = p->before[FIELD_RATE],
    };
}

static struct solve_work solve_make(const struct particles *p, int64_t *residual)
{
    return (struct solve_work){
        .load = p->now[FIELD_LOAD],
        .flux = p->now[FIELD_FLUX],
        .motion = particles_motion(p),
        .factor = p->now[FIELD_FACTOR],
        .warm = p->now[FIELD_WARM],
        .search = p->now[FIELD_SEARCH],
        .remainder = p->now[FIELD_REMAINDER],
        .product = p->now[FIELD_FLUX],
        .block = p->now[FIELD_BLOCK],
        .density = particles_density(p),
        .residual = residual,
    };
}

static struct projection_work projection_make(const struct particles *p)
{
    return (struct projection_work){
        .stencil = p->now[FIELD_STENCIL],
        .unknown = p->now[FIELD_UNKNOWN],
        .trial = p->now[FIELD_TRIAL],
        .surface = p->now[FIELD_SURFACE],
        .direction = p->now[FIELD_DIRECTION],
        .product = p->now[FIELD_PRODUCT],
        .violent = p->before[FIELD_SURFACE],
    };
}

/* The pressure by tension goes where nothing else is yet. */
static float *tension_pressure_of(enum pass_id pass, const struct particles *p)
{
    return pass == PASS_CURVATURE || pass == PASS_JUMP ? p->now[FIELD_DIRECTION] : NULL;
}

/* Whether a pass reads the velocity from before the step: those of the sweeping solver do. */
static bool reads_before(enum pass_id pass)
{
    return pass == PASS_FACTOR || pass == PASS_PUSH || pass == PASS_SWEEP || pass == PASS_PROJECT ||
           pass == PASS_DRAG_DIAGONAL || pass == PASS_DRAG_MATRIX;
}

/* Fluids that differ in density: sweeps read all of theirs, a projection where it has to. */
static float *inverse_of(enum pass_id pass, const struct solver_choice *choice,
                         const struct work_arrays *arrays)
{
    bool projects = pass == PASS_STENCIL || pass == PASS_FLOW;
    return (projects && choice->projection.mixed) || pass == PASS_FACTOR ? arrays->inverse_density
                                                                         : NULL;
}

struct work work_make(enum pass_id pass, enum solve solve, bool looping,
                      const struct solver_choice *choice, const struct solver_choice *there,
                      struct scalars *scalars, const struct particles *p,
                      const struct position *wall, const struct work_arrays *arrays,
                      const struct work_rows *rows)
{
    return (struct work){
        .count = p->count,
        .solve_of = solve,
        .looping = looping,
        .constants = choice->pair,
        .choice = there,
        .scalars = scalars,
        .id = particles_id(p),
        .fluid = p->now[FIELD_FLUID],
        .position = choice->is_implicit ? p->before[FIELD_POSITION] : p->now[FIELD_POSITION],
        .motion = reads_before(pass) ? p->before[FIELD_MOTION] : particles_motion(p),
        .viscosity = p->now[FIELD_VISCOSITY],
        .rest = arrays->rest,
        .density = choice->is_implicit ? NULL : particles_density(p),
        .soft = choice->continuity && choice->mixed,
        .inverse_density = inverse_of(pass, choice, arrays),
        .shift = p->before[FIELD_SHIFT],
        .rate = particles_rate(p),
        .gradient = p->now[FIELD_GRADIENT],
        .number = arrays->number,
        .rows = rows->block,
        .row_count = rows->count,
        .wall = wall,
        .wall_rows = rows->wall_block,
        .wall_row_count = rows->wall_count,
        .state = state_make(p),
        .solve = solve_make(p, arrays->residual),
        .shifting = {.surface = p->before[FIELD_SURFACE],
                     .now = p->now[FIELD_SHIFT],
                     .surface_now = p->now[FIELD_SURFACE]},
        .tension = {.fluid = arrays->fluid,
                    .normal = p->now[FIELD_NORMAL],
                    .pressure = tension_pressure_of(pass, p)},
        .projection = projection_make(p),
    };
}
