/* Divergence-free SPH (Bender & Koschier 2015, 2017): incompressible, pressure by solving. */
#include "scene/key.h"
#include "solver/solver.h"

#include <math.h>

static const struct key keys[] = {
    {.path = "solver.density_error", .type = KEY_REAL, .flags = KEY_ABOVE_MIN, .fallback = "1e-4",
     .min = 0, .max = 0.1, .unit = "", .offset = KEY_OPTION,
     .doc = "mean compression (rho - rho0)/rho0 that shifting may leave"},
    {.path = "solver.divergence_error", .type = KEY_REAL, .flags = KEY_ABOVE_MIN,
     .fallback = "1e-5", .min = 0, .max = 1, .unit = "", .offset = KEY_OPTION,
     .doc = "mean compression by one step of the velocity"},
    {.path = "solver.sweeps", .type = KEY_INT, .fallback = "100", .min = 1, .max = 10000,
     .unit = "", .offset = KEY_OPTION, .doc = "largest number of sweeps of a solve"},
    VISCOSITY_KEYS,
};

static const enum pass_id passes[] = {
    PASS_SORT,  PASS_NEIGHBOURS, PASS_FACTOR, PASS_FORCE, PASS_EXTERNAL,
    PASS_NORMALS, PASS_TENSION, PASS_WALLS, PASS_KICK,
    PASS_DRAG_BEGIN, PASS_DRAG_DIAGONAL, PASS_DRAG_RESIDUAL,
    PASS_SOLVE_VISCOSITY, PASS_DRAG_MATRIX, PASS_DRAG_STEP, PASS_SOLVED,
    PASS_DRAG_END,
    PASS_SOLVE_VELOCITY, PASS_PUSH, PASS_SWEEP, PASS_SOLVED, PASS_PROJECT,
    PASS_RESUME, PASS_SOLVE_SHIFT, PASS_PUSH, PASS_SWEEP, PASS_SOLVED, PASS_PUSH, PASS_MOVE,
};

static void choose(const struct scene *scene, struct solver_choice *choice)
{
    double radius = kernel_jacobi_radius(choice->kernel, choice->support / choice->spacing);
    int most = (int)scene_integer(scene, "solver.sweeps");
    choice->is_implicit = true;
    choice->sound_speed = 0;
    choice->limits.acoustic = INFINITY;
    choice->limits.force = INFINITY;
    choice->implicit.gradient = choice->pair.gradient * (float)choice->moment;
    choice->implicit.omega = (float)(DFSPH_WINDOW_PART * 2 / radius);
    choice->implicit.pressure = (float)choice->moment;
    choice->implicit.most = 0.02f;
    choice->implicit.slack = choice->enclosed ? 1 : 0.03f; /* nothing is loose there */
    choice->implicit.restore = 0.03f;
    for (size_t f = 0; f < scene->fluid_count; f++)
        choice->implicit.volume[f] = choice->each.mass[f] / choice->each.rest_density[f];
    choice->solves[SOLVE_VELOCITY] = (struct solve_limits){
        scene_real(scene, "solver.divergence_error"), 1, most, 1, 0.9};
    choice->solves[SOLVE_SHIFT] = (struct solve_limits){
        scene_real(scene, "solver.density_error"), 1, most, 0.9, 0.9};
    viscosity_choose(scene, choice);
}

const struct solver_row solver_dfsph = {
    .variant = {.name = "dfsph",
                .doc = "divergence-free SPH: incompressible, pressure solved for, large steps",
                .keys = keys,
                .key_count = sizeof keys / sizeof *keys},
    .kernel = "cubic-spline",
    .cfl = 0.5,
    .support = 2.0,
    .passes = passes,
    .pass_count = sizeof passes / sizeof *passes,
    .choose = choose,
};
