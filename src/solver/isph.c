/* Incompressible SPH by projection (Cummins & Rudman 1999; Lind et al. 2012). */
#include "scene/key.h"
#include "solver/solver.h"

#include <math.h>

static const struct key keys[] = {
    {.path = "solver.divergence_error", .type = KEY_REAL, .flags = KEY_ABOVE_MIN,
     .fallback = "1e-5", .min = 0, .max = 1, .unit = "", .offset = KEY_OPTION,
     .doc = "mean compression by one step of the velocity"},
    {.path = "solver.density_error", .type = KEY_REAL, .flags = KEY_ABOVE_MIN, .fallback = "1e-3",
     .min = 0, .max = 0.1, .unit = "", .offset = KEY_OPTION,
     .doc = "mean density error (rho - rho0)/rho0 that the equation of the shift may leave"},
    {.path = "solver.sweeps", .type = KEY_INT, .fallback = "300", .min = 1, .max = 10000,
     .unit = "", .offset = KEY_OPTION, .doc = "largest number of iterations of a solve"},
    VISCOSITY_KEYS,
};

static const enum pass_id passes[] = {
    PASS_SORT, PASS_NEIGHBOURS, PASS_REWIND, PASS_STENCIL, PASS_SURFACE, PASS_FORCE, PASS_EXTERNAL,
    PASS_NORMALS, PASS_CURVATURE, PASS_JUMP, PASS_WALLS, PASS_ADVANCE,
    PASS_FLOW, PASS_RESIDUAL,
    PASS_SOLVE_VELOCITY, PASS_PRODUCT, PASS_DESCENT, PASS_SOLVED,
    PASS_CROWDING, PASS_RESIDUAL,
    PASS_SOLVE_SHIFT, PASS_PRODUCT, PASS_DESCENT, PASS_SOLVED,
    PASS_SLOPES,
    PASS_DRAG_BEGIN, PASS_DRAG_DIAGONAL, PASS_DRAG_RESIDUAL,
    PASS_SOLVE_VISCOSITY, PASS_DRAG_MATRIX, PASS_DRAG_STEP, PASS_SOLVED,
    PASS_DRAG_END,
    PASS_DRIFT,
};

static void choose(const struct scene *scene, struct solver_choice *choice)
{
    struct projection_constants *p = &choice->projection;
    double d = choice->spacing, h = choice->smoothing_length, q = d / h;
    int most = (int)scene_integer(scene, "solver.sweeps");
    float first = plane_value(choice->each.planes.volume, (float)(q / 2));
    choice->is_implicit = choice->projects = true;
    choice->sound_speed = 0;
    choice->limits.acoustic = INFINITY;
    choice->limits.force = INFINITY;
    p->gradient = choice->pair.gradient;
    p->laplacian = (float)(-2 * (double)choice->pair.gradient / h);
    p->loose = 0.56f * first; /* first: of a layer of the lattice at a flat surface */
    p->torn = 1.4f * first;
    p->gain = 0.6f;
    p->slack = 0.005f;
    p->most = 0.1f;
    p->fickian = (float)(8 * h);
    p->fringe = 0.3f;
    p->closeness = (float)(1 / choice->kernel->value(q));
    p->slope = (float)choice->kernel->slope(q);
    p->enclosed = choice->enclosed;
    p->whole = (float)kernel_lattice_slope(choice->kernel, choice->support / d);
    p->reference = 0;
    for (size_t f = 0; f < scene->fluid_count; f++) {
        float rest = choice->each.rest_density[f];
        p->mixed = p->mixed || rest != choice->each.rest_density[0];
        p->reference = rest > p->reference ? rest : p->reference;
    }
    for (size_t f = 0; f < scene->fluid_count; f++) {
        p->lighter[f] = p->reference / choice->each.rest_density[f];
        p->volume[f] = choice->implicit.volume[f] =
            choice->each.mass[f] / choice->each.rest_density[f];
    }
    p->whole *= p->laplacian * p->volume[0];
    p->self = p->laplacian * p->volume[0] * (float)choice->kernel->slope(q / 2);
    choice->solves[SOLVE_VELOCITY] = (struct solve_limits){
        scene_real(scene, "solver.divergence_error"), 0, most, 1, 0};
    choice->solves[SOLVE_SHIFT] = (struct solve_limits){
        scene_real(scene, "solver.density_error"), 0, most, 1, 0};
    viscosity_choose(scene, choice);
}

const struct solver_row solver_isph = {
    .variant = {.name = "isph",
                .doc = "incompressible by projection: pressure from Poisson's equation, large steps",
                .keys = keys,
                .key_count = sizeof keys / sizeof *keys},
    .kernel = "wendland-c2",
    .cfl = 0.625,
    .support = 2.6,
    .passes = passes,
    .pass_count = sizeof passes / sizeof *passes,
    .choose = choose,
};
