/* Measures the rows of a ledger, the scene with and without each feature in turns. */
#include "study/ledger/ledger.h"
#include "study/ledger/looks.h"

#include "base/log.h"
#include "base/memory.h"
#include "particles/fill.h"
#include "study/process.h"
#include "study/ledger/trial.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char *const labels[STRENGTHS] = {"the ledger, off", "the ledger, on", "the ledger, faint"};

/* "KEY=VALUE KEY=VALUE" into the set, a "*" once for each fluid. */
static enum status add_settings(struct study_set *set, const char *settings, const char *label,
                                size_t fluids, struct error *e)
{
    for (size_t length; *settings; settings += length + (settings[length] == ' ')) {
        char key[KEY_TEXT_SIZE], value[KEY_TEXT_SIZE];
        length = strcspn(settings, " ");
        size_t name = strcspn(settings, "=");
        const char *star = memchr(settings, '*', name);
        snprintf(value, sizeof value, "%.*s", (int)(length - name - 1), settings + name + 1);
        for (size_t f = 0; f < (star ? fluids : 1); f++) {
            if (star)
                snprintf(key, sizeof key, "%.*s%zu%.*s", (int)(star - settings), settings, f,
                         (int)(settings + name - star - 1), star + 1);
            else
                snprintf(key, sizeof key, "%.*s", (int)name, settings);
            if (set_say(set, key, value, label, e))
                return e->status;
        }
    }
    return STATUS_OK;
}

/* The value of "fluids" that the feature writes. */
static enum status add_fluids(struct study_set *set, const struct feature_row *feature,
                              enum strength strength, const struct scene *scene, struct error *e)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out)
        return error_set(e, STATUS_RUN, "memory is short");
    feature->fluids(scene, strength, out);
    if (fclose(out) == 0)
        set_say(set, "fluids", text, labels[strength], e);
    free(text);
    return e->status;
}

static enum status scene_set(struct study_set *set, const struct ledger_options *options,
                             struct error *e)
{
    for (size_t k = 0; k < options->set_count; k++) {
        char *key = strdup(options->sets[k]), *value = key ? strchr(key, '=') : NULL;
        if (value)
            *value++ = 0;
        enum status status = value ? set_say(set, key, value, options->sets[k], e)
                             : key ? error_set(e, STATUS_USAGE, "--set %s: give KEY=VALUE", options->sets[k])
                                   : error_set(e, STATUS_RUN, "memory is short");
        free(key);
        if (status)
            return status;
    }
    return STATUS_OK;
}

enum status ledger_check(const struct ledger_options *options, struct error *e)
{
    struct study_set set = {0};
    struct scene *scene = NULL;
    struct run_options run = {.backend = "auto", .renderer = "auto", .isa = "auto"};
    enum status status = scene_set(&set, options, e);
    struct scene_overrides overrides = {(const char *const *)set.items,
                                        (const char *const *)set.labels, set.count};
    if (!status)
        status = scene_load(&scene, options->scene, &overrides, &run_vocabulary, e);
    if (!status)
        status = run_check(scene, &run, e);
    if (!status && (!scene->body_count || fill_bodies_estimate(scene) < 1))
        status = error_set(e, STATUS_USAGE, "%s: there are no particles, and a ledger is of costs per particle; "
                           "give a body, or a smaller particles.spacing", options->scene);
    scene_free(scene);
    set_free(&set);
    return status;
}

static enum status open_variant(struct scene_trial *trial, const struct ledger *ledger,
                                const struct feature_row *feature, enum strength strength,
                                const struct scene *scene, struct error *e)
{
    struct study_set set = {0};
    enum status status = scene_set(&set, ledger->options, e);
    if (!status && feature->fluids)
        status = add_fluids(&set, feature, strength, scene, e);
    else if (!status)
        status = add_settings(&set, feature->settings[strength], labels[strength], scene->fluid_count, e);
    if (!status)
        status = trial_open(trial, ledger->options->scene, &set, e);
    set_free(&set);
    return status;
}

/* What the plan of the scene as it is says of the feature. */
static void read_plan(struct ledger_row *row, const struct plan *plan)
{
    const struct feature_row *feature = row->feature;
    row->absent = true;
    for (size_t k = 0; k < feature->pass_count; k++) {
        for (size_t i = 0; i < plan->pass_count; i++)
            row->absent = row->absent && plan->passes[i]->id != feature->passes[k];
        row->absent = row->absent && !(plan->frame_pass && plan->frame_pass->id == feature->passes[k]);
    }
    for (size_t k = 0; k < 3 && feature->omitted[k] && !row->said[0]; k++)
        for (size_t i = 0; i < plan->omitted_count; i++)
            if (strncmp(plan->omitted[i], feature->omitted[k], strlen(feature->omitted[k])) == 0)
                snprintf(row->said, sizeof row->said, "%s", plan->omitted[i]);
}

static enum answer compare(const struct scene_trial *trial, const struct ledger *ledger)
{
    return !trial->planned || !isfinite(trial->ns) || trial->reason[0] ? ANSWER_NONE
           : trial->hash == ledger->hash                             ? ANSWER_SAME
                                                                     : ANSWER_DIFFERENT;
}

/* Runs the scene, the scene with the feature off and with it on in turns; faint once. */
static enum status take_turns(struct ledger *ledger, struct scene_trial *base, struct scene_trial *trials,
                              struct error *e)
{
    const struct ledger_options *o = ledger->options;
    base->ns = INFINITY;
    for (int k = 0; k < o->repeats; k++)
        if (trial_run(base, o->steps, o->threads, e) ||
            trial_run(&trials[STRENGTH_OFF], o->steps, o->threads, e) ||
            trial_run(&trials[STRENGTH_ON], o->steps, o->threads, e))
            return e->status;
    if (trials[STRENGTH_FAINT].planned &&
        trial_run(&trials[STRENGTH_FAINT], o->steps, o->threads, e))
        return e->status;
    return base->hash == ledger->hash ? STATUS_OK
                                      : error_set(e, STATUS_RUN, "%s: the same steps ended in another "
                                                  "state; this is a defect", o->scene);
}

static void fill(struct ledger_row *row, const struct ledger *ledger, const struct scene_trial *base,
                 const struct scene_trial *trials)
{
    const struct scene_trial *on = &trials[STRENGTH_ON], *off = &trials[STRENGTH_OFF];
    for (int k = 0; k < STRENGTHS; k++)
        row->states[k] = compare(&trials[k], ledger);
    snprintf(row->reason, sizeof row->reason, "%s", on->reason);
    row->without = base->ns;
    row->neutral = row->states[STRENGTH_OFF] ? off->ns : (double)NAN;
    if (!row->states[STRENGTH_ON])
        return;
    row->with = on->ns;
    row->steps = base->step / on->step;
    row->planned = (double)on->plan.bytes_per_particle - (double)base->plan.bytes_per_particle;
    row->bytes = on->bytes - base->bytes;
}

static enum status measure(struct ledger *ledger, struct ledger_row *row, struct scene_trial *base,
                           struct error *e)
{
    const struct feature_row *feature = row->feature;
    struct scene_trial trials[STRENGTHS] = {0};
    enum status status = STATUS_OK;
    for (int k = 0; k < STRENGTHS && !status; k++)
        if (feature->fluids || feature->settings[k])
            status = open_variant(&trials[k], ledger, feature, (enum strength)k, base->scene, e);
    if (!status && !trials[STRENGTH_ON].reason[0])
        status = take_turns(ledger, base, trials, e);
    if (!status)
        fill(row, ledger, base, trials);
    for (int k = 0; k < STRENGTHS; k++)
        trial_close(&trials[k]);
    return status;
}

static enum status open_base(struct ledger *ledger, struct scene_trial *base, struct error *e)
{
    const struct ledger_options *o = ledger->options;
    struct study_set set = {0};
    enum status status = scene_set(&set, o, e);
    if (!status)
        status = trial_open(base, o->scene, &set, e);
    set_free(&set);
    if (!status && base->reason[0])
        return error_set(e, STATUS_USAGE, "%s", base->reason);
    if (status || trial_run(base, o->steps, o->threads, e))
        return e->status;
    if (base->reason[0])
        return error_set(e, STATUS_RUN, "%s", base->reason);
    snprintf(ledger->title, sizeof ledger->title, "%s", base->scene->title);
    snprintf(ledger->method, sizeof ledger->method, "%s", base->scene->solver.method);
    ledger->particles = (double)base->plan.bodies.count;
    ledger->planned = base->plan.bytes_per_particle;
    ledger->bytes = base->bytes;
    ledger->step = base->step;
    ledger->hash = base->hash;
    return STATUS_OK;
}

/* Of the machine: a scene that is said otherwise takes the same time. */
static void find_noise(struct ledger *ledger)
{
    ledger->ns = INFINITY;
    for (size_t k = 0; k < ledger->count; k++) {
        const struct ledger_row *row = &ledger->rows[k];
        if (row->feature->output || isnan(row->neutral))
            continue;
        ledger->noise = fmax(ledger->noise, fabs(row->neutral - row->without));
        ledger->ns = fmin(ledger->ns, row->without);
    }
}

enum status ledger_make(struct ledger *ledger, const struct ledger_options *options, struct error *e)
{
    struct scene_trial base = {0};
    *ledger = (struct ledger){.options = options};
    ledger->rows = memory_create("ledger", feature_table.count, sizeof *ledger->rows, e);
    enum status status = ledger->rows ? open_base(ledger, &base, e) : e->status;
    process_catch_signals();
    for (size_t k = 0; k < feature_table.count && !status; k++) {
        struct ledger_row *row = &ledger->rows[ledger->count++];
        *row = (struct ledger_row){.feature = (const struct feature_row *)feature_table.rows[k],
                                   .without = (double)NAN, .with = (double)NAN, .neutral = (double)NAN,
                                   .steps = (double)NAN, .planned = (double)NAN, .bytes = (double)NAN};
        log_progress((double)k, (double)feature_table.count, row->feature->variant.name);
        row->used = row->feature->used(&base.plan);
        read_plan(row, &base.plan);
        if (process_interrupted())
            status = error_set(e, STATUS_INTERRUPTED, "interrupted; nothing is kept of a ledger");
        else if (!row->used)
            status = row->feature->output
                         ? ledger_frames(ledger, row, base.step * (double)options->steps, e)
                         : measure(ledger, row, &base, e);
    }
    log_progress_end();
    trial_close(&base);
    find_noise(ledger);
    return status;
}

void ledger_free(struct ledger *ledger)
{
    memory_free(ledger->rows);
    ledger->rows = NULL;
}

bool ledger_proved(const struct ledger_row *row)
{
    if (feature_is_look(row->feature)) /* pictures are the same without it, and the state is with it */
        return row->states[STRENGTH_OFF] == ANSWER_SAME && row->states[STRENGTH_ON] == ANSWER_SAME;
    bool neutral = row->feature->output ? row->states[STRENGTH_ON] == ANSWER_SAME
                                        : row->states[STRENGTH_OFF] == ANSWER_SAME;
    return neutral && row->absent && row->said[0];
}

size_t ledger_failures(const struct ledger *ledger)
{
    size_t count = 0;
    for (size_t k = 0; k < ledger->count; k++)
        count += !ledger->rows[k].used && !ledger->rows[k].reason[0] && !ledger_proved(&ledger->rows[k]);
    return count;
}
