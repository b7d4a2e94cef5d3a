/* Writes the plan in words. */
#include "run/plan.h"

#include "run/plan_color.h"

#include <math.h>
#include <string.h>

static const char *const kinds[] = {
    [PASS_EACH] = "each", [PASS_PAIR] = "pair", [PASS_ORDER] = "order",
    [PASS_LOOP] = "loop", [PASS_END] = "end"};

static void write_fields(unsigned mask, FILE *out)
{
    const char *comma = "";
    if (!mask)
        fputs("-", out);
    for (int f = 0; f < FIELD_COUNT; f++)
        if (mask & FIELD_BIT(f)) {
            fprintf(out, "%s%s", comma, field_table[f].name);
            comma = ",";
        }
}

/* How an implicit solver treats viscosity, and why. */
static void write_viscosity(const struct solver_choice *c, FILE *out)
{
    bool below = VISCOSITY_STEPS * c->viscous_step < c->other_step;
    fprintf(out, "viscosity      %s: explicit steps could be %.4g s, %s 1/%d of the %.4g s of other limits%s",
            c->implicit_viscosity ? "implicit" : "explicit", c->viscous_step,
            below ? "below" : "not below", VISCOSITY_STEPS, c->other_step,
            below == c->implicit_viscosity ? "" : ", but the scene says so");
    if (c->implicit_viscosity)
        fprintf(out, "; to a residual of %g, at most %d iterations",
                c->solves[SOLVE_VISCOSITY].tolerance, c->solves[SOLVE_VISCOSITY].most);
    fprintf(out, "\n               %s: %s\n",
            c->flags & PAIR_CENTRAL ? "weiler, along the line of centres, free of stress at surfaces"
                                    : "morris, a Laplacian",
            c->form_asked ? "the scene says so"
            : c->enclosed ? "fluid fills the domain"
                          : "fluid does not fill the domain");
}

static void write_solves(const struct solver_choice *c, FILE *out)
{
    fprintf(out, "pressure       solved for; velocity to a mean compression of %g a step, shift to %g, at "
                 "most %d %s\n",
            c->solves[SOLVE_VELOCITY].tolerance, c->solves[SOLVE_SHIFT].tolerance,
            c->solves[SOLVE_SHIFT].most, c->projects ? "iterations" : "sweeps");
    if (!c->projects)
        fprintf(out, "relaxation     %.3f (%.2g of the Jacobi window of this kernel and support)\n",
                c->implicit.omega, DFSPH_WINDOW_PART);
    if (c->flags & (PAIR_VISCOUS | PAIR_OWN_VISCOSITY))
        write_viscosity(c, out);
    fprintf(out, "time step      %.3g d / fastest", c->cfl * 0.4);
    if (isfinite(c->limits.viscous))
        fprintf(out, ", viscous %.4g s", c->limits.viscous);
    if (isfinite(c->limits.capillary))
        fprintf(out, ", capillary %.4g s", c->limits.capillary);
    if (isfinite(c->limits.user))
        fprintf(out, ", scene %.4g s", c->limits.user);
    fputs("\n", out);
}

static void write_limits(const struct solver_choice *c, FILE *out)
{
    fprintf(out, "sound speed    %.4g m/s\n", c->sound_speed);
    double acoustic = c->limits.acoustic / (c->sound_speed + c->fastest);
    double other = fmin(c->limits.viscous, fmin(c->limits.capillary, c->limits.damping));
    fprintf(out, "time step      at most %.4g s (acoustic", fmin(c->limits.user,
            fmin(acoustic, other)));
    fprintf(out, " %.4g at %.4g m/s", acoustic, c->fastest);
    if (isfinite(c->limits.viscous))
        fprintf(out, ", viscous %.4g", c->limits.viscous);
    if (isfinite(c->limits.capillary))
        fprintf(out, ", capillary %.4g", c->limits.capillary);
    if (isfinite(c->limits.damping))
        fprintf(out, ", damping %.4g", c->limits.damping);
    if (isfinite(c->limits.user))
        fprintf(out, ", scene %.4g", c->limits.user);
    fprintf(out, "; force %.2g sqrt(h/a))\n", c->limits.force);
}

static void write_terms(const struct solver_choice *c, FILE *out)
{
    fprintf(out, "terms          pressure (%s)", c->is_implicit             ? "implicit"
                                                 : c->flags & PAIR_SYMMETRIC ? "symmetric"
                                                                              : "average");
    if (c->flags & (PAIR_VISCOUS | PAIR_OWN_VISCOSITY))
        fprintf(out, ", viscosity%s", c->flags & PAIR_OWN_VISCOSITY ? " per fluid" : "");
    if (c->flags & PAIR_ARTIFICIAL)
        fputs(", artificial viscosity", out);
    if (c->flags & PAIR_CONTINUITY)
        fputs(", continuity", out);
    if (c->flags & PAIR_DIFFUSION || c->gradients)
        fprintf(out, ", density diffusion (%s)", c->gradients ? "Antuono" : "Fourtakas");
    if (c->shifting)
        fputs(", particle shifting", out);
    if (c->tension.any)
        fputs(", surface tension", out);
    if (c->external.any)
        fputs(", external", out);
    fputs("\n", out);
}

/* What a csv output holds; the time is its first column. */
static void write_measures(const struct measures *measures, FILE *out)
{
    if (!measures->count)
        return;
    fprintf(out, "\nmeasured every %.4g s, %zu columns\n", measures->interval,
            measures->column_count);
    for (size_t i = 0; i < measures->count; i++) {
        const struct measure *item = &measures->items[i];
        const char *name = item->asked->name, *quantity = item->row->variant.name;
        bool own = strcmp(name, quantity) != 0;
        fprintf(out, "  %s%s%s: %s; reads ", own ? name : "", own ? ", " : "", quantity,
                item->row->variant.doc);
        write_fields(item->row->reads, out);
        fprintf(out, "; %zu column%s from %s\n", item->columns, item->columns == 1 ? "" : "s",
                measures->columns[item->first]);
    }
}

static void write_pass(const struct pass_row *pass, size_t number, FILE *out)
{
    fprintf(out, "  %zu %-11s %-6s %s; reads ", number, pass->name, kinds[pass->kind], pass->doc);
    write_fields(pass->reads, out);
    fputs(", writes ", out);
    write_fields(pass->writes, out);
    fputs("\n", out);
}

void plan_write(const struct plan *plan, FILE *out)
{
    const struct solver_choice *c = &plan->choice;
    double ratio = c->support / c->spacing;
    fprintf(out, "scene          %s\n", plan->scene->title);
    fprintf(out, "particles      %zu, spacing %.4g m", plan->bodies.count, c->spacing);
    if (plan->walls.count)
        fprintf(out, "; %zu wall particles", plan->walls.count);
    if (plan->scene->obstacle_count)
        fprintf(out, ", %zu obstacle%s", plan->scene->obstacle_count, plan->scene->obstacle_count > 1 ? "s" : "");
    fprintf(out, "\nsolver         %s, kernel %s, support radius %.4g m (%.3g spacings, %d lattice "
                 "neighbours)\n",
            plan->solver->variant.name, c->kernel->variant.name, c->support, ratio,
            kernel_lattice_neighbours(ratio));
    if (plan->bodies.count)
        (c->is_implicit ? write_solves : write_limits)(c, out);
    write_terms(c, out);
    fprintf(out, "neighbours     %s\n", plan->search->variant.name);
    if (plan->draws)
        plan_color_write(plan, out);
    fprintf(out, "memory         %zu bytes a particle:", plan->bytes_per_particle);
    for (int f = 0; f < FIELD_COUNT; f++)
        if (plan->fields & FIELD_BIT(f))
            fprintf(out, " %s %zu", field_table[f].name,
                    field_bytes(&field_table[f]));
    fprintf(out, "; and %d bytes a neighbour\n\npasses of a step\n",
            solver_row_bytes(c));
    for (size_t k = 0; k < plan->pass_count; k++)
        write_pass(plan->passes[k], k + 1, out);
    if (plan->frame_pass) {
        fprintf(out, "\nbefore each frame\n");
        write_pass(plan->frame_pass, 1, out);
    }
    write_measures(&plan->measures, out);
    fprintf(out, "\nleft out\n");
    for (size_t k = 0; k < plan->omitted_count; k++)
        fprintf(out, "  %s\n", plan->omitted[k]);
}
