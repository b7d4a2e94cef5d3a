/* The table of features that a scene can leave out. */
#include "study/ledger/looks.h"

#include "base/quote.h"

#include <string.h>

static bool uses_viscosity(const struct plan *plan)
{
    for (size_t f = 0; f < plan->scene->fluid_count; f++)
        if (plan->scene->fluids[f].viscosity > 0)
            return true;
    return false;
}

static bool uses_implicit(const struct plan *plan) { return plan->choice.implicit_viscosity; }
static bool uses_artificial(const struct plan *plan) { return plan->choice.flags & PAIR_ARTIFICIAL; }
static bool uses_fourtakas(const struct plan *plan) { return plan->choice.flags & PAIR_DIFFUSION; }
static bool uses_antuono(const struct plan *plan) { return plan->choice.gradients; }
static bool uses_shifting(const struct plan *plan) { return plan->choice.shifting; }
static bool uses_tension(const struct plan *plan) { return plan->choice.tension.any; }
static bool uses_central(const struct plan *plan) { return plan->choice.external.central; }
static bool uses_dissipation(const struct plan *plan) { return plan->scene->dissipation > 0; }
static bool uses_fluids(const struct plan *plan) { return plan->scene->fluid_count > 1; }
static bool uses_walls(const struct plan *plan) { return plan->choice.wall_particles; }
static bool never(const struct plan *plan) { (void)plan; return false; } /* of a run without outputs */

static bool uses_summation(const struct plan *plan)
{
    return !plan->choice.continuity && !plan->choice.is_implicit;
}

static bool uses_buoyancy(const struct plan *plan)
{
    return plan->scene->buoyancy > 0 && plan->scene->fluid_count > 1;
}

/* The scene's fluid, and switched on one more that no body is of: half as dense, or faintly the same. */
static void second_fluid(const struct scene *scene, enum strength strength, FILE *out)
{
    const struct scene_fluid *fluid = &scene->fluids[0];
    char name[2 * sizeof fluid->name + 3];
    json_quote(fluid->name, name, sizeof name);
    fprintf(out, "[{\"name\": %s, \"density\": %.17g, \"viscosity\": %.17g, \"surface_tension\": %.17g}",
            name, fluid->density, fluid->viscosity, fluid->surface_tension);
    if (strength != STRENGTH_OFF)
        fprintf(out, ", {\"name\": \"of the ledger\", \"density\": %.17g, \"viscosity\": %.17g, "
                     "\"surface_tension\": %.17g}",
                (strength == STRENGTH_ON ? 0.5 : 1) * fluid->density, fluid->viscosity,
                fluid->surface_tension);
    fputs("]", out);
}

static const struct feature_row viscosity = {
    {"viscosity", "viscous forces of pairs and walls", NULL, 0, NULL},
    {"fluids.*.viscosity=0", "fluids.*.viscosity=0.1", "fluids.*.viscosity=1e-30"}, NULL, NULL,
    {"term viscosity"}, {0}, 0, uses_viscosity, NULL, NULL, NULL};

static const struct feature_row implicit_viscosity = {
    {"implicit viscosity", "viscosity by solving", NULL, 0, NULL},
    {"solver.viscosity=\"explicit\"", "solver.viscosity=\"implicit\"", NULL},
    "explicit and implicit steps round differently", NULL,
    {"passes of implicit viscosity", "term viscosity"}, {PASS_DRAG_BEGIN, PASS_SOLVE_VISCOSITY, PASS_DRAG_END},
    3, uses_implicit, NULL, NULL, NULL};

static const struct feature_row artificial = {
    {"artificial viscosity", "Monaghan's, of approaching pairs", NULL, 0, NULL},
    {"solver.artificial_viscosity=0", "solver.artificial_viscosity=0.02",
     "solver.artificial_viscosity=1e-30"}, NULL, NULL,
    {"term artificial viscosity"}, {0}, 0, uses_artificial, NULL, NULL, NULL};

static const struct feature_row fourtakas = {
    {"density diffusion", "delta-SPH, Fourtakas's form, in the force pass", NULL, 0, NULL},
    {"solver.diffusion=0", "solver.diffusion=0.1", "solver.diffusion=1e-30"}, NULL, NULL,
    {"term density diffusion"}, {0}, 0, uses_fourtakas, NULL, NULL, NULL};

static const struct feature_row antuono = {
    {"diffusion by gradients", "delta-SPH, Antuono's form, in passes of its own", NULL, 0, NULL},
    {"solver.diffusion_form=\"fourtakas\"", "solver.diffusion=0.1 solver.diffusion_form=\"antuono\"", NULL},
    "it replaces the other form of diffusion", NULL,
    {"passes gradient, diffusion", "term density diffusion"}, {PASS_GRADIENT, PASS_DIFFUSION}, 2,
    uses_antuono, NULL, NULL, NULL};

static const struct feature_row summation = {
    {"density by summation", "a pass of its own instead of the continuity equation", NULL, 0, NULL},
    {"solver.density=\"continuity\"", "solver.density=\"summation\"", NULL},
    "it replaces the continuity equation", NULL,
    {"pass density"}, {PASS_DENSITY, PASS_PRESSURE}, 2, uses_summation, NULL, NULL, NULL};

static const struct feature_row shifting = {
    {"particle shifting", "drift towards emptier places", NULL, 0, NULL},
    {"solver.shifting=\"off\"", "solver.shifting=\"on\"", NULL}, "it has no strength", NULL,
    {"pass shift"}, {PASS_SHIFT}, 1, uses_shifting, NULL, NULL, NULL};

static const struct feature_row tension = {
    {"surface tension", "normals, curvature and forces of surfaces", NULL, 0, NULL},
    {"fluids.*.surface_tension=0", "fluids.*.surface_tension=0.07", "fluids.*.surface_tension=1e-30"},
    NULL, NULL, {"passes of surface tension"}, {PASS_NORMALS, PASS_TENSION, PASS_CURVATURE, PASS_JUMP}, 4,
    uses_tension, NULL, NULL, NULL};

static const struct feature_row central = {
    {"central force", "a spring to a point", NULL, 0, NULL},
    {"central_force.frequency=0", "central_force.frequency=1", "central_force.frequency=1e-30"}, NULL,
    NULL, {"pass external"}, {PASS_EXTERNAL}, 1, uses_central, NULL, NULL, NULL};

static const struct feature_row dissipation = {
    {"dissipation", "decay of every velocity", NULL, 0, NULL},
    {"dissipation=0", "dissipation=0.1", "dissipation=1e-30"}, NULL, NULL,
    {"pass external"}, {PASS_EXTERNAL}, 1, uses_dissipation, NULL, NULL, NULL};

static const struct feature_row buoyancy = {
    {"buoyancy", "lift of fluids among each other", NULL, 0, NULL},
    {"buoyancy=0", "buoyancy=1", "buoyancy=1e-30"}, NULL, NULL,
    {"pass external"}, {PASS_EXTERNAL}, 1, uses_buoyancy, NULL, NULL, NULL};

static const struct feature_row fluids = {
    {"second fluid", "which fluid a particle is of, and pairs of unequal density", NULL, 0, NULL},
    {NULL, NULL, NULL}, NULL, second_fluid, {"field fluid"}, {0}, 0, uses_fluids, NULL, NULL, NULL};

static const struct feature_row walls = {
    {"wall particles", "boundary particles at the lower face", NULL, 0, NULL},
    {"domain.walls.-y=\"closed\"", "domain.walls.-y=\"particles\"", NULL},
    "a wall is of particles or not", NULL, {"wall particles"}, {0}, 0, uses_walls, NULL, NULL, NULL};

static const struct feature_row measures = {
    {"measured rows", "energy, momentum ... as csv, a row a frame", NULL, 0, NULL},
    {NULL, NULL, NULL}, NULL, NULL, {"measures"}, {0}, 0, never, "rows.csv", NULL, "measure"};

static const struct feature_row drawing = {
    {"drawing", "a picture of each frame", NULL, 0, NULL},
    {NULL, NULL, NULL}, NULL, NULL, {"drawing"}, {0}, 0, never, "frame-%04d.png", "velocity",
    "draw|encode"};

static const struct feature_row vorticity = {
    {"vorticity", "its pass before each frame, to colour by", NULL, 0, NULL},
    {NULL, NULL, NULL}, NULL, NULL, {"drawing"}, {PASS_CURL}, 1, never, "frame-%04d.png", "vorticity",
    "curl"};

static const struct variant *const rows[] = {
    &viscosity.variant, &implicit_viscosity.variant, &artificial.variant, &fourtakas.variant,
    &antuono.variant, &summation.variant, &shifting.variant, &tension.variant, &central.variant,
    &dissipation.variant, &buoyancy.variant, &fluids.variant, &walls.variant, &measures.variant,
    &drawing.variant, &vorticity.variant,
    &look_surface.variant, &look_samples.variant, &look_occlusion.variant, &look_shadow.variant,
    &look_outline.variant, &look_alpha.variant, &look_fade.variant, &look_box.variant, &look_floor.variant,
    &look_legend.variant, &look_title.variant, &look_time.variant, &look_scale_bar.variant, &look_axes.variant,
    &look_labels.variant,
};

const struct variant_table feature_table = {
    "features", "what a scene can leave out, and the ledger switches on", rows,
    sizeof rows / sizeof *rows};
