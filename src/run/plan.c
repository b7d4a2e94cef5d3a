/* Makes the plan: solver and constants, passes, fields, and what is left out. */
#include "run/plan.h"

#include "base/memory.h"
#include "particles/fill_obstacles.h"
#include "particles/start.h"
#include "run/budget.h"
#include "run/film.h"
#include "run/plan_color.h"
#include "run/plan_obstacles.h"

#include <math.h>
#include <string.h>

void plan_omit(struct plan *plan, const char *what_and_why)
{
    if (plan->omitted_count < sizeof plan->omitted / sizeof *plan->omitted)
        plan->omitted[plan->omitted_count++] = what_and_why;
}

/* Whether a pass has work to do; says why not. */
static bool pass_wanted(struct plan *plan, enum pass_id id)
{
    const struct solver_choice *c = &plan->choice;
    bool viscous = c->flags & (PAIR_VISCOUS | PAIR_OWN_VISCOSITY);
    bool applied = viscous && !c->implicit_viscosity; /* by the passes of explicit solvers */
    bool drags = !c->is_implicit || (applied && c->each.no_slip);
    switch (id) {
    case PASS_DENSITY:
        if (c->continuity)
            plan_omit(plan, "pass density: density follows from the continuity equation in force");
        return !c->continuity;
    case PASS_PRESSURE:
        if (c->continuity)
            plan_omit(plan, "pass pressure: predict evaluates the equation of state");
        return !c->continuity;
    case PASS_FORCE:
        if (c->is_implicit && !applied)
            plan_omit(plan, viscous ? "pass force: viscosity and pressure are solved for"
                               : "pass force: no viscosity, and pressure is solved for");
        return !c->is_implicit || applied;
    case PASS_GRADIENT:
        if (c->flags & PAIR_DIFFUSION)
            plan_omit(plan, "passes gradient, diffusion: force adds Fourtakas's form of diffusion");
        return c->gradients;
    case PASS_DIFFUSION:
        return c->gradients;
    case PASS_NORMALS:
        if (!c->tension.any)
            plan_omit(plan, "passes of surface tension: every fluid has surface tension 0");
        return c->tension.any;
    case PASS_TENSION:
    case PASS_CURVATURE:
    case PASS_JUMP:
        return c->tension.any;
    case PASS_EXTERNAL:
        if (!c->external.any && !(c->tension.any && c->starts_rate))
            plan_omit(plan, "pass external: no central force, buoyancy between fluids or dissipation");
        return c->external.any || (c->tension.any && c->starts_rate);
    case PASS_WALLS:
        if (!c->wall_planes)
            plan_omit(plan, "pass walls: no closed face");
        else if (!drags)
            plan_omit(plan, c->implicit_viscosity
                           ? "pass walls: they drag and push by the solves"
                           : "pass walls: they do not drag, and push by the pressure solve");
        return c->wall_planes && drags;
    case PASS_SHIFT:
        if (!c->shifting)
            plan_omit(plan, strcmp(scene_text(plan->scene, "solver.shifting"), "off") == 0
                           ? "pass shift: not asked for"
                           : "pass shift: not one fluid that fills a domain without walls, with "
                             "density by continuity and average pressure");
        return c->shifting;
    case PASS_DRAG_BEGIN:
        if (viscous && !c->implicit_viscosity)
            plan_omit(plan, "passes of implicit viscosity: it is explicit");
        return c->implicit_viscosity;
    case PASS_DRAG_DIAGONAL:
    case PASS_DRAG_RESIDUAL:
    case PASS_DRAG_END:
    case PASS_SOLVE_VISCOSITY:
        return c->implicit_viscosity;
    default:
        return true;
    }
}

/* A loop that is not wanted is left out to its end. */
static void plan_passes(struct plan *plan)
{
    bool skip = false;
    for (size_t k = 0; k < plan->solver->pass_count; k++) {
        const struct pass_row *pass = &pass_table[plan->solver->passes[k]];
        bool wanted = !skip && pass_wanted(plan, pass->id);
        skip = skip ? pass->kind != PASS_END : pass->kind == PASS_LOOP && !wanted;
        if (wanted)
            plan->passes[plan->pass_count++] = pass;
    }
}

/* Fields that passes and drawing touch; the others are never allocated. Sorting moves what there is. */
static void plan_fields(struct plan *plan)
{
    unsigned fields = 0;
    for (size_t k = 0; k < plan->pass_count; k++)
        fields |= plan->passes[k]->reads |
                  (plan->passes[k]->kind == PASS_ORDER ? 0 : plan->passes[k]->writes);
    if (plan->color)
        fields |= plan->color->reads;
    if (plan->frame_pass)
        fields |= plan->frame_pass->reads | plan->frame_pass->writes;
    fields |= plan->measures.reads;
    if (plan->scene->fluid_count > 1)
        fields |= FIELD_BIT(FIELD_FLUID);
    else
        plan_omit(plan, "field fluid: one fluid");
    if (plan->choice.implicit_viscosity && plan->choice.flags & PAIR_CENTRAL)
        fields |= FIELD_BIT(FIELD_BLOCK);
    if (plan->choice.implicit_viscosity)
        plan_omit(plan, "field viscosity: search holds it");
    else if (plan->choice.flags & PAIR_OWN_VISCOSITY)
        fields |= FIELD_BIT(FIELD_VISCOSITY);
    else
        plan_omit(plan, "field viscosity: all fluids have the same");
    plan->fields = fields;
    for (int f = 0; f < FIELD_COUNT; f++)
        if (fields & FIELD_BIT(f))
            plan->bytes_per_particle += field_bytes(&field_table[f]);
}

/* Every field that a pass reads must be set at the start or written by a pass. */
static enum status check_reads(const struct plan *plan, struct error *e)
{
    unsigned known = FIELD_BIT(FIELD_POSITION) | FIELD_BIT(FIELD_MOTION) |
                     FIELD_BIT(FIELD_DENSITY) | FIELD_BIT(FIELD_ID) | FIELD_BIT(FIELD_FLUID) |
                     FIELD_BIT(FIELD_VISCOSITY);
    for (size_t k = 0; k < plan->pass_count; k++)
        known |= plan->passes[k]->writes;
    for (size_t k = 0; k < plan->pass_count; k++)
        for (int f = 0; f < FIELD_COUNT; f++)
            if (plan->passes[k]->reads & ~known & FIELD_BIT(f))
                return error_set(e, STATUS_RUN, "plan: pass %s reads %s, which nothing writes",
                                 plan->passes[k]->name, field_table[f].name);
    return STATUS_OK;
}

static void omit_terms(struct plan *plan)
{
    unsigned flags = plan->choice.flags;
    if (!(flags & (PAIR_VISCOUS | PAIR_OWN_VISCOSITY)))
        plan_omit(plan, "term viscosity: every fluid has viscosity 0");
    if (!(flags & PAIR_ARTIFICIAL))
        plan_omit(plan, "term artificial viscosity: not asked for");
    if (!(flags & PAIR_DIFFUSION) && !plan->choice.gradients)
        plan_omit(plan, "term density diffusion: not asked for, or density by summation");
    if (!plan->choice.wall_particles)
        plan_omit(plan, "wall particles: no face is made of particles");
}

static enum status plan_measures(struct plan *plan, const struct run_options *options,
                                 struct error *e)
{
    if (film_wants_rows(options->outputs, options->output_count))
        return measures_create(&plan->measures, plan->scene, plan->bodies.count, e);
    plan_omit(plan, plan->scene->measure_count ? "measures of the scene: no output is a csv file"
                                          : "measures: no output is a csv file");
    return STATUS_OK;
}

static enum status check_periods(const struct plan *plan, struct error *e)
{
    double reach = 2 * plan->choice.support * (1 + SKIN_MAX);
    for (int a = 0; a < 3; a++)
        if (plan->space.periodic[a] && plan->space.length[a] < reach)
            return error_set(e, STATUS_USAGE,
                             "%s: the domain is periodic and %g m long in %c, but a particle must "
                             "not reach its own image: make it at least %g m (2.5 support radii), "
                             "or particles.spacing smaller",
                             plan->scene->source, plan->space.length[a], "xyz"[a], reach);
    return STATUS_OK;
}

/* Refuses what the solver cannot do together. */
static enum status check_choice(const struct plan *plan, const struct solver_choice *c,
                                struct error *e)
{
    const struct scene *scene = plan->scene;
    bool antuono = strcmp(scene_text(scene, "solver.diffusion_form"), "antuono") == 0;
    bool symmetric = c->flags & PAIR_SYMMETRIC;
    if (c->is_implicit && !c->projects && c->tension.any) /* drops scatter, as measured */
        return error_set(e, STATUS_USAGE, "%s: solver.method %s has no surface tension; use isph, "
                         "or set fluids[].surface_tension to 0", scene->source,
                         plan->solver->variant.name);
    if (c->shifting && (!c->continuity || symmetric))
        return scene_fail(scene, "solver.shifting", e, "solver.shifting needs solver.density "
                          "continuity and solver.pressure_form average; set it to off");
    if (antuono && !c->continuity)
        return scene_fail(scene, "solver.diffusion_form", e, "solver.diffusion_form antuono needs "
                          "solver.density continuity: by summation nothing diffuses; remove one of "
                          "the two");
    if (antuono && c->mixed && symmetric)
        return scene_fail(scene, "solver.diffusion_form", e, "solver.diffusion_form antuono needs "
                          "solver.pressure_form average where fluids differ in density; remove one "
                          "of the two");
    return STATUS_OK;
}

/* What particles will take, by a plan made as if there were none. */
static enum status plan_budget(const struct plan *plan, const struct run_options *options,
                               struct error *e)
{
    static const double volume[FLUIDS_MAX];
    static const size_t particles[FLUIDS_MAX];
    struct plan trial = *plan;
    solver_choose(plan->solver, plan->scene, &plan->space, volume, particles, &trial.choice);
    if (check_choice(plan, &trial.choice, e) || plan_obstacles(plan->scene, trial.choice.support, e))
        return e->status;
    plan_passes(&trial);
    if (plan_color(&trial, options, e))
        return e->status;
    plan_fields(&trial);
    return budget_check(&trial, !options->elsewhere, e);
}

static enum status plan_rows(struct plan *plan, const struct scene *scene,
                             const struct run_options *options, struct error *e)
{
    bool automatic = strcmp(scene->neighbours, "auto") == 0;
    struct backend_place place;
    *plan = (struct plan){.scene = scene};
    plan->solver = (const struct solver_row *)variant_find(&solver_table, scene->solver.method);
    plan->search = automatic ? &search_index_sort
                             : (const struct search_row *)variant_find(&search_table,
                                                                       scene->neighbours);
    if (backend_find(options->backend ? options->backend : "auto", &place, e))
        return e->status;
    plan->backend = place.row;
    plan->device = place.device;
    plan->block = place.block;
    if (options->strict && isnan(scene->time.step))
        return error_set(e, STATUS_USAGE, "--strict: %s gives no time.step that could be too "
                         "long; give one, or leave out --strict", scene->source);
    return STATUS_OK;
}

/* All that is known before a particle is made; checks that they will fit. */
static enum status plan_start(struct plan *plan, const struct scene *scene,
                              const struct run_options *options, struct error *e)
{
    const struct kernel_row *kernel;
    if (plan_rows(plan, scene, options, e))
        return e->status;
    if (scene->fluid_count > FLUIDS_MAX)
        return error_set(e, STATUS_USAGE, "%s: %zu fluids, but at most %d are supported",
                         scene->source, scene->fluid_count, FLUIDS_MAX);
    double d = scene->particles.spacing, support = solver_support(plan->solver, scene, &kernel);
    plan->space = space_create(scene, ceil(support / d - 1e-6) * d);
    return plan_budget(plan, options, e);
}

static enum status plan_particles(struct plan *plan, struct error *e)
{
    const struct scene *scene = plan->scene;
    const struct kernel_row *kernel;
    double support = solver_support(plan->solver, scene, &kernel), volume[FLUIDS_MAX];
    size_t particles[FLUIDS_MAX];
    if (fill_bodies(scene, &plan->bodies, e) || fill_walls(scene, support, &plan->walls, e) ||
        fill_obstacles(scene, support, &plan->walls, e))
        return e->status;
    start_count(scene, &plan->bodies, volume, particles);
    solver_choose(plan->solver, scene, &plan->space, volume, particles, &plan->choice);
    return check_periods(plan, e);
}

enum status plan_check(const struct scene *scene, const struct run_options *options,
                       struct error *e)
{
    struct plan plan;
    e->status = STATUS_OK;
    return plan_start(&plan, scene, options, e);
}

enum status plan_make(struct plan *plan, const struct scene *scene,
                      const struct run_options *options, struct error *e)
{
    if (plan_start(plan, scene, options, e) || plan_particles(plan, e)) {
        plan_free(plan);
        return e->status;
    }
    plan_passes(plan);
    omit_terms(plan);
    if (!plan_color(plan, options, e) && !plan_color_values(plan, e) && !plan_measures(plan, options, e)) {
        plan_fields(plan);
        check_reads(plan, e);
    }
    if (e->status)
        plan_free(plan);
    return e->status;
}

void plan_free(struct plan *plan)
{
    fill_free(&plan->bodies);
    fill_free(&plan->walls);
    measures_free(&plan->measures);
    memory_free(plan->fixed);
}
