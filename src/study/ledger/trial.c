/* Runs a scene with settings for a number of steps, in this process. */
#include "study/ledger/trial.h"

#include "base/log.h"
#include "base/memory.h"
#include "run/simulation.h"

#include <math.h>
#include <string.h>

/* What the scene or its run says becomes the reason; the ledger goes on. */
static enum status take_reason(struct scene_trial *trial, struct error *e)
{
    const char *text = e->text, *set = strstr(text, ": ");
    if (strncmp(text, "the ledger", 10) == 0 && set) /* the label of the setting */
        text = set + 2;
    snprintf(trial->reason, sizeof trial->reason, "%.390s", text);
    *e = (struct error){STATUS_OK, ""};
    return STATUS_OK;
}

enum status trial_open(struct scene_trial *trial, const char *scene, const struct study_set *set,
                       struct error *e)
{
    struct scene_overrides overrides = {(const char *const *)set->items,
                                        (const char *const *)set->labels, set->count};
    struct run_options options = {.backend = "auto", .renderer = "auto", .isa = "auto"};
    *trial = (struct scene_trial){.ns = INFINITY};
    if (scene_load(&trial->scene, scene, &overrides, &run_vocabulary, e) ||
        plan_make(&trial->plan, trial->scene, &options, e))
        return take_reason(trial, e);
    trial->planned = true;
    return STATUS_OK;
}

enum status trial_run(struct scene_trial *trial, long steps, int threads, struct error *e)
{
    struct simulation s = {0};
    struct run_options options = {.backend = "auto", .isa = "auto", .threads = threads};
    double n = fmax((double)trial->plan.bodies.count, 1), before = (double)memory_now();
    if (trial->reason[0])
        return STATUS_OK;
    if (simulation_open(&s, &trial->plan, &options, e))
        return take_reason(trial, e);
    double start = clock_cpu_seconds();
    for (long k = 0; k < steps; k++)
        if (simulation_step(&s, INFINITY, e)) {
            simulation_close(&s);
            return take_reason(trial, e);
        }
    double ns = (clock_cpu_seconds() - start) * 1e9 / n / (double)steps;
    uint64_t hash;
    if (s.row->hash(s.backend, &hash, e)) {
        simulation_close(&s);
        return e->status;
    }
    if (isfinite(trial->ns) && hash != trial->hash)
        error_set(e, STATUS_RUN, "%s: the same steps ended in another state; this is a defect of the "
                  "program or the machine", trial->scene->source);
    trial->hash = hash;
    trial->ns = fmin(trial->ns, ns);
    trial->step = s.time / (double)steps;
    trial->bytes = ((double)memory_now() - before) / n;
    simulation_close(&s);
    return e->status;
}

void trial_close(struct scene_trial *trial)
{
    if (trial->planned)
        plan_free(&trial->plan);
    scene_free(trial->scene);
    trial->scene = NULL;
    trial->planned = false;
}
