/* SPH after Mueller, Charypar & Gross 2003: its kernels, linear pressure, density by summation. */
#include "scene/key.h"
#include "solver/solver.h"

#include <math.h>

static const struct key keys[] = {
    {.path = "solver.stiffness", .type = KEY_REAL, .flags = KEY_AUTO | KEY_ABOVE_MIN,
     .fallback = "\"auto\"", .min = 0, .max = 1e12, .unit = "m^2/s^2", .offset = KEY_OPTION,
     .doc = "k of p = k (rho - rho0), the square of the speed of sound; auto: from the scene"},
    {.path = "solver.clamp_pressure", .type = KEY_BOOL, .fallback = "true", .unit = "",
     .offset = KEY_OPTION, .doc = "set negative pressure to zero: no clumping at a free surface"},
};

/* Artificial viscosity of thin fluid, and the viscosity over rho c0 d from which it needs none. */
#define THIN_ALPHA 0.1
#define THIN (1.0 / 80)

static const enum pass_id passes[] = {
    PASS_SORT,     PASS_NEIGHBOURS, PASS_PREDICT, PASS_DENSITY, PASS_PRESSURE, PASS_FORCE,
    PASS_EXTERNAL, PASS_NORMALS,    PASS_TENSION, PASS_WALLS,   PASS_CORRECT,
};

/* The force (spiky) is no gradient of the density (poly6), and feeds noise however short the step: thin
 * fluid would boil. Artificial viscosity (Monaghan 1997) takes it away. */
static void choose_damping(const struct scene *scene, struct solver_choice *choice)
{
    double lightest = INFINITY;
    bool thin = false;
    for (size_t f = 0; f < scene->fluid_count; f++) {
        const struct scene_fluid *fluid = &scene->fluids[f];
        double needed = THIN * fluid->density * choice->sound_speed * choice->spacing;
        thin = thin || fluid->viscosity < needed;
        lightest = fmin(lightest, fluid->density);
    }
    if (!thin)
        return;
    choice->flags |= PAIR_ARTIFICIAL;
    choice->pair.artificial = (float)(THIN_ALPHA * choice->sound_speed *
                                      (choice->mixed ? 1 : lightest));
}

/* In corners the summed density of the start lattice exceeds that at rest by 5e-4, which a stiff fluid
 * would answer with a burst: masses are lowered so that it starts without pressure. */
static void choose_masses(const struct scene *scene, struct solver_choice *choice)
{
    double excess = kernel_plane_excess(choice->kernel, choice->support / choice->spacing,
                                        &choice->each.planes);
    for (size_t f = 0; f < scene->fluid_count && choice->wall_planes; f++)
        choice->each.mass[f] = (float)(choice->each.mass[f] / (1 + 3 * excess));
}

static void choose(const struct scene *scene, struct solver_choice *choice)
{
    double k = scene_real(scene, "solver.stiffness");
    choice->sound_speed = isnan(k) ? fmax(10 * choice->fastest, 1e-3) : sqrt(k);
    choice->each.clamp = scene_flag(scene, "solver.clamp_pressure");
    for (size_t f = 0; f < scene->fluid_count; f++)
        choice->each.bulk[f] = (float)(scene->fluids[f].density * choice->sound_speed *
                                       choice->sound_speed);
    choice->flags |= PAIR_MULLER;
    solver_mix(choice);
    choose_damping(scene, choice);
    choose_masses(scene, choice);
    /* The pair bodies add mu_i + mu_j; Mueller's viscosity kernel takes the mean. His mean pressure
     * (p_i + p_j)/2 is half the gradient (p_i sum V_j grad W vanishes), so the sum stays. */
    choice->pair.viscosity /= 2;
    choice->pair.inverse_h /= 2;
}

const struct solver_row solver_muller = {
    .variant = {.name = "muller",
                .doc = "Mueller 2003: poly6, spiky and viscosity kernels, linear pressure",
                .keys = keys,
                .key_count = sizeof keys / sizeof *keys},
    .kernel = "poly6",
    .cfl = 0.2,
    .passes = passes,
    .pass_count = sizeof passes / sizeof *passes,
    .choose = choose,
};
