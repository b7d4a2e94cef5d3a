/* Weakly compressible SPH (Monaghan 1994; delta-SPH: Antuono et al. 2010, Fourtakas et al. 2019). */
#include "scene/key.h"
#include "solver/solver.h"

#include <math.h>
#include <string.h>

static const struct key keys[] = {
    {.path = "solver.sound_speed", .type = KEY_REAL, .flags = KEY_AUTO | KEY_ABOVE_MIN,
     .fallback = "\"auto\"", .min = 0, .max = 1e6, .unit = "m/s", .offset = KEY_OPTION,
     .doc = "numerical speed of sound, of the densest fluid; auto: 10 times the fastest expected flow"},
    {.path = "solver.eos", .type = KEY_CHOICE, .fallback = "\"tait\"", .choices = "tait|linear",
     .unit = "", .offset = KEY_OPTION,
     .doc = "equation of state: Tait with exponent 7, or linear in density"},
    {.path = "solver.density", .type = KEY_CHOICE, .fallback = "\"continuity\"",
     .choices = "continuity|summation", .unit = "", .offset = KEY_OPTION,
     .doc = "density by the continuity equation, in the force pass, or by summation"},
    {.path = "solver.diffusion", .type = KEY_REAL, .fallback = "0.1", .min = 0, .max = 1,
     .unit = "", .offset = KEY_OPTION,
     .doc = "delta of delta-SPH density diffusion (continuity only)"},
    {.path = "solver.diffusion_form", .type = KEY_CHOICE, .fallback = "\"fourtakas\"",
     .choices = "fourtakas|antuono", .unit = "", .offset = KEY_OPTION,
     .doc = "what diffuses: pressure but for the hydrostatic, or density but for its gradient"},
    {.path = "solver.artificial_viscosity", .type = KEY_REAL, .fallback = "0.02", .min = 0,
     .max = 10, .unit = "", .offset = KEY_OPTION,
     .doc = "alpha of Monaghan's artificial viscosity, on approaching pairs"},
    {.path = "solver.pressure_form", .type = KEY_CHOICE, .fallback = "\"average\"",
     .choices = "average|symmetric", .unit = "", .offset = KEY_OPTION,
     .doc = "pair pressure: V_j (p_i + p_j), or V_i^2 p_i + V_j^2 p_j"},
    {.path = "solver.clamp_negative", .type = KEY_BOOL, .fallback = "true", .unit = "",
     .offset = KEY_OPTION, .doc = "set negative pressure to zero: no clumping at a free surface"},
    {.path = "solver.shifting", .type = KEY_CHOICE, .fallback = "\"auto\"",
     .choices = "auto|on|off", .unit = "", .offset = KEY_OPTION,
     .doc = "particle shifting; auto: on where one fluid fills a domain without walls"},
};

static const enum pass_id passes[] = {
    PASS_SORT,     PASS_NEIGHBOURS, PASS_PREDICT,  PASS_DENSITY, PASS_PRESSURE, PASS_FORCE,
    PASS_GRADIENT, PASS_DIFFUSION,  PASS_EXTERNAL, PASS_NORMALS, PASS_TENSION,  PASS_WALLS,
    PASS_SHIFT,    PASS_CORRECT,
};

/* A free surface or a wall keeps particles apart by pressure: shifting is no gain there. */
static void choose_shifting(const struct scene *scene, struct solver_choice *choice)
{
    const char *shifting = scene_text(scene, "solver.shifting");
    bool fits = choice->continuity && !(choice->flags & PAIR_SYMMETRIC);
    bool fills = choice->enclosed && !choice->wall_planes && !choice->wall_particles;
    choice->shifting = strcmp(shifting, "on") == 0 ||
                       (strcmp(shifting, "auto") == 0 && fits && fills && scene->fluid_count == 1);
    choice->closeness =
        (float)(1 / choice->kernel->value(choice->spacing / choice->smoothing_length));
}

/* The lighter of two fluids is squeezed by noise of the denser one's pressure unless it is as stiff, but
 * the same bulk modulus, c_l^2 rho_l = c_h^2 rho_h (Colagrossi & Landrini 2003), takes sqrt(rho_h/rho_l)
 * as many steps. c = c0 (rho_h/rho)^(1/4), halfway, was enough at a ratio of 1000. */
static void choose_bulk(const struct scene *scene, double densest, struct solver_choice *choice)
{
    double swiftest = 1;
    for (size_t f = 0; f < scene->fluid_count; f++) {
        double density = scene->fluids[f].density, c0 = choice->sound_speed;
        double bulk = density * c0 * c0, stiffer = sqrt(densest / density);
        choice->softness[f] = (float)(1 / sqrt(stiffer));
        bulk *= stiffer;
        choice->each.bulk[f] = (float)(choice->each.tait ? bulk / 7 : bulk);
        swiftest = fmax(swiftest, sqrt(stiffer));
    }
    choice->limits.acoustic /= swiftest;
}

static void choose(const struct scene *scene, struct solver_choice *choice)
{
    double alpha = scene_real(scene, "solver.artificial_viscosity");
    double delta = scene_real(scene, "solver.diffusion");
    double c0 = scene_real(scene, "solver.sound_speed"), lightest = INFINITY, densest = 0;
    choice->continuity = strcmp(scene_text(scene, "solver.density"), "continuity") == 0;
    choice->sound_speed = isnan(c0) ? fmax(10 * choice->fastest, 1e-3) : c0;
    choice->each.tait = strcmp(scene_text(scene, "solver.eos"), "tait") == 0;
    choice->each.clamp = scene_flag(scene, "solver.clamp_negative");
    for (size_t f = 0; f < scene->fluid_count; f++) {
        lightest = fmin(lightest, scene->fluids[f].density);
        densest = fmax(densest, scene->fluids[f].density);
    }
    choose_bulk(scene, densest, choice);
    bool antuono = strcmp(scene_text(scene, "solver.diffusion_form"), "antuono") == 0;
    choice->gradients = choice->continuity && delta > 0 && antuono;
    if (choice->continuity)
        choice->flags |= PAIR_CONTINUITY | (delta > 0 && !antuono ? PAIR_DIFFUSION : 0);
    if (alpha > 0 || choice->ripple > 0)
        choice->flags |= PAIR_ARTIFICIAL;
    if (strcmp(scene_text(scene, "solver.pressure_form"), "symmetric") == 0)
        choice->flags |= PAIR_SYMMETRIC;
    else
        solver_mix(choice);
    choose_shifting(scene, choice);
    choice->pair.artificial =
        choice->flags & PAIR_MIXED
            ? (float)fmax(alpha * choice->sound_speed, choice->ripple / densest)
            : (float)fmax(alpha * choice->sound_speed * lightest, choice->ripple);
    choice->pair.diffusion = (float)(2 * delta / choice->sound_speed);
}

const struct solver_row solver_wcsph = {
    .variant = {.name = "wcsph",
                .doc = "weakly compressible: Tait or linear pressure, density diffusion",
                .keys = keys,
                .key_count = sizeof keys / sizeof *keys},
    .kernel = "wendland-c2",
    .cfl = 0.25,
    .passes = passes,
    .pass_count = sizeof passes / sizeof *passes,
    .choose = choose,
};
