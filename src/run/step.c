/* One try of a time step: the planned passes in order, loops until they are solved. */
#include "run/step.h"

#include <math.h>

enum { ENCLOSED_SWEEPS = 3 }; /* of a shift that evens out, but cannot lower, the density */

#define RELAX_GROWTH 1.02 /* a solve, after sweeps had to be relaxed more */

enum status step_pass(struct simulation *s, enum pass_id pass, struct step *step, struct error *e)
{
    return s->row->run(s->backend, pass, step, e);
}

enum status step_settle(struct simulation *s, struct step *step, struct error *e)
{
    return s->row->settle ? s->row->settle(s->backend, step, e) : STATUS_OK;
}

/* Runs passes k.. of the plan up to the next one of kind `end`, once. */
static enum status run_passes(struct simulation *s, size_t first, size_t last, struct step *step,
                              struct error *e)
{
    for (size_t k = first; k < last; k++)
        if (step_pass(s, s->plan->passes[k]->id, step, e))
            return e->status;
    return STATUS_OK;
}

static enum solve solve_of(enum pass_id loop)
{
    return loop == PASS_SOLVE_SHIFT       ? SOLVE_SHIFT
           : loop == PASS_SOLVE_VISCOSITY ? SOLVE_VISCOSITY
                                          : SOLVE_VELOCITY;
}

/* How a solve of the plan goes on; it begins with the relaxation of the last step's, eased. */
static struct loop loop_of(struct simulation *s, enum solve solve)
{
    const struct solver_choice *c = &s->plan->choice;
    const struct solve_limits *limit = &c->solves[solve];
    bool evens = c->enclosed && !c->projects && solve == SOLVE_SHIFT;
    return (struct loop){.tolerance = limit->tolerance, .least = limit->least, .most = limit->most,
                         .exactly = evens ? ENCLOSED_SWEEPS : 0, .momentum = limit->momentum,
                         .adapts = !c->projects,
                         .relax = fmin(1, RELAX_GROWTH * s->relax[solve])};
}

static void count_loop(struct simulation *s, const struct step *step)
{
    struct solve_stats *stats = &s->stats.solves[step->solve];
    s->relax[step->solve] = step->loop.relax;
    stats->sweeps += step->loop.sweeps;
    stats->last = step->loop.sweeps;
    stats->unsolved += step->loop.unsolved;
    stats->most = step->loop.sweeps > stats->most ? step->loop.sweeps : stats->most;
    stats->residual = step->residual;
}

/* Sweeps to queue before their residual is known: as many as the last solve took, then a few. */
static int sweeps_ahead(const struct simulation *s, const struct step *step)
{
    enum { AHEAD = 4 };
    int last = s->stats.solves[step->solve].last;
    if (!s->queues)
        return 1;
    return step->loop.sweeps == 0 && last > 0 ? last : AHEAD;
}

/* Repeats the loop that begins at pass `loop`; sets *end to its last. */
static enum status run_loop(struct simulation *s, size_t loop, size_t *end, struct step *step,
                            struct error *e)
{
    const struct plan *plan = s->plan;
    *end = loop + 1;
    while (plan->passes[*end]->kind != PASS_END)
        ++*end;
    step->solve = solve_of(plan->passes[loop]->id);
    step->loop = loop_of(s, step->solve);
    if (step_pass(s, plan->passes[loop]->id, step, e))
        return e->status;
    step->looping = true;
    do {
        for (int sweep = 0; sweep < sweeps_ahead(s, step); sweep++)
            if (run_passes(s, loop + 1, *end + 1, step, e))
                return e->status;
        if (step_settle(s, step, e))
            return e->status;
    } while (step->loop.again);
    step->looping = false;
    count_loop(s, step);
    return STATUS_OK;
}

/* Whether a pass reports extremes, hence particles that must not move so. */
static bool reports(enum pass_id id)
{
    return id == PASS_PREDICT || id == PASS_CORRECT || id == PASS_MOVE || id == PASS_DRIFT;
}

enum status step_try(struct simulation *s, double dt, bool redo, uint32_t *bad, struct error *e)
{
    const struct plan *plan = s->plan;
    /* A step that is redone starts its shift from nothing: what it had may be the cause. */
    float resume = redo ? 0 : (float)plan->choice.solves[SOLVE_SHIFT].resume;
    struct step step = {.dt = (float)dt, .before = (float)s->dt, .resume = resume};
    *bad = UINT32_MAX;
    s->row->begin(s->backend);
    for (size_t k = 0; k < plan->pass_count && *bad == UINT32_MAX; k++) {
        const struct pass_row *pass = plan->passes[k];
        if (pass->kind == PASS_ORDER)
            continue;
        if (pass->id == PASS_FLOW || pass->id == PASS_CROWDING)
            step.solve = pass->id == PASS_FLOW ? SOLVE_VELOCITY : SOLVE_SHIFT;
        if (pass->kind == PASS_LOOP ? run_loop(s, k, &k, &step, e)
                                    : step_pass(s, pass->id, &step, e))
            return e->status;
        if (reports(pass->id) && !s->row->settle)
            *bad = step.extremes.bad;
    }
    if (step_settle(s, &step, e))
        return e->status;
    *bad = step.extremes.bad;
    if (*bad != UINT32_MAX) {
        s->row->reject(s->backend);
        s->stats.rejected++;
        return STATUS_OK;
    }
    s->moved += sqrt((double)step.extremes.move2);
    s->dt = dt;
    s->extremes = step.extremes;
    return STATUS_OK;
}

enum status step_forces(struct simulation *s, struct step *step, struct error *e)
{
    size_t first = 0, last = 0;
    for (size_t k = 0; k < s->plan->pass_count; k++) {
        enum pass_id id = s->plan->passes[k]->id;
        first = id == PASS_PREDICT ? k + 1 : first;
        last = id == PASS_CORRECT ? k : last;
    }
    return run_passes(s, first, last, step, e) || step_settle(s, step, e) ? e->status : STATUS_OK;
}
