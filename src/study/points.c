/* Makes the points of a study: the scene of each run, with what it measures, checked. */
#include "base/fnv.h"
#include "base/memory.h"
#include "particles/fill.h"
#include "run/measure.h"
#include "run/run.h"
#include "study/ensemble.h"
#include "study/set.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Besides what errors need, of every run: conservation, and whether the box leaks. */
static const char kept[] = "{\"quantity\": \"energy\", \"name\": \"kept-energy\"}, "
                           "{\"quantity\": \"momentum\", \"name\": \"kept-momentum\"}, "
                           "{\"quantity\": \"extent\", \"name\": \"kept-extent\"}";

/* A small picture of the last state. */
static const char picture[] = "[480, 270]";

/* What is between the quotes. */
static void take_word(char *out, size_t size, const char *quoted)
{
    snprintf(out, size, "%.*s", (int)strcspn(quoted + 1, "\""), quoted + 1);
}

/* Takes the run's own settings, which no scene has, out of a set. */
static enum status take_run_settings(struct study_point *point, const struct study_set *set,
                                     struct study_set *rest, struct error *e)
{
    for (size_t k = 0; k < set->count; k++) {
        const char *item = set->items[k], *value = strchr(item, '=') + 1;
        struct study_set one = {&set->items[k], &set->labels[k], 1};
        if (strncmp(item, "threads=", 8) == 0) {
            char *end;
            long threads = strtol(value, &end, 10);
            if (*end || threads < 0 || threads > 4096)
                return error_set(e, STATUS_USAGE, "%s is %s; give a whole number from 0 (all "
                                 "processors) to 4096", set->labels[k], value);
            point->threads = (int)threads;
        } else if (strncmp(item, "isa=", 4) == 0) {
            take_word(point->isa, sizeof point->isa, value);
        } else if (strncmp(item, "backend=", 8) == 0) {
            take_word(point->backend, sizeof point->backend, value);
        } else if (set_append(rest, &one, e)) {
            return e->status;
        }
    }
    return STATUS_OK;
}

static enum status load(struct study_point *point, const struct study *study,
                        const struct study_set *set, struct error *e)
{
    struct scene_overrides overrides = {(const char *const *)set->items,
                                        (const char *const *)set->labels, set->count};
    scene_free(point->scene);
    return scene_load(&point->scene, study->scene, &overrides, &run_vocabulary, e);
}

/* "[...]" of all that is measured; malloc. */
static char *measure_text(const struct study *study, const struct scene *scene)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out)
        return NULL;
    fprintf(out, "[%s", kept);
    if (study->known) {
        fputs(", ", out);
        study->known->measure(scene, out);
    }
    if (study->measure && study->measure[strspn(study->measure, " \t\r\n")])
        fprintf(out, ", %s", study->measure);
    fputs("]", out);
    return fclose(out) == 0 ? text : NULL;
}

/* What a run measures and draws, said as settings of its scene. */
static enum status set_products(const struct study *study, const struct scene *scene,
                                struct study_set *set, struct error *e)
{
    static const char label[] = "what the study measures";
    char number[32];
    double interval = !isnan(study->interval) ? study->interval
                      : study->known          ? study->known->interval(scene) : 0;
    char *text = measure_text(study, scene);
    if (!text)
        return error_set(e, STATUS_RUN, "memory is short");
    enum status status = set_say(set, "measure", text, label, e);
    free(text);
    snprintf(number, sizeof number, "%.17g", interval);
    if (!status && interval > 0)
        status = set_say(set, "time.measure", number, label, e);
    snprintf(number, sizeof number, "%.17g", scene->time.end);
    if (!status)
        status = set_say(set, "movie.start", number, label, e);
    return status ? status : set_say(set, "movie.size", picture, label, e);
}

/* Of this program's file, so that another build does not take over its results. */
static uint64_t program_hash(void)
{
    static uint64_t hash;
    unsigned char block[1 << 16];
    size_t size;
    FILE *file = hash ? NULL : fopen("/proc/self/exe", "rb");
    if (!file)
        return hash;
    hash = FNV_START;
    while ((size = fread(block, 1, sizeof block, file)) > 0)
        hash = fnv_bytes(hash, block, size);
    fclose(file);
    return hash;
}

/* Runs of the same scene in the same way share their folder, and so their results. */
static enum status name_folder(struct study_point *point, const char *method, struct error *e)
{
    char plain[64];
    uint64_t hash = fnv_bytes(program_hash() ^ scene_hash(point->scene, &run_vocabulary),
                               &point->threads, sizeof point->threads);
    hash = fnv_bytes(hash, point->isa, strlen(point->isa));
    hash = fnv_bytes(hash, point->backend, strlen(point->backend));
    snprintf(plain, sizeof plain, "%.60s", method);
    for (char *p = plain; *p; p++)
        if (!isalnum((unsigned char)*p) && *p != '.')
            *p = '-';
    if (asprintf(&point->folder, "runs/%s-%016llx", plain, (unsigned long long)hash) < 0) {
        point->folder = NULL;
        return error_set(e, STATUS_RUN, "memory is short");
    }
    return STATUS_OK;
}

/* Whether the run will have the columns that errors are of. */
static enum status check_columns(const struct study *study, const struct scene *scene,
                                 struct error *e)
{
    struct measures measures = {0};
    double none = 0;
    enum status status = measures_create(&measures, scene, 1, e);
    double **values = calloc(measures.column_count + 1, sizeof *values);
    if (!status && !values)
        status = error_set(e, STATUS_RUN, "memory is short");
    for (size_t k = 0; k < measures.column_count && values; k++)
        values[k] = &none;
    struct columns columns = {(char **)measures.columns, values, measures.column_count, 1};
    for (size_t k = 0; k < study->asked_count && !status; k++) {
        const struct study_asked *asked = &study->asked[k];
        struct error what = {.status = STATUS_OK};
        if (!columns_need(&columns, asked->column, &what))
            status = error_set(e, STATUS_USAGE, "%s:%d:%d: %s", study->path, asked->line,
                               asked->character, what.text);
    }
    free(values);
    measures_free(&measures);
    return status;
}

/* The scene with the settings of study, method and rung, in that order. */
static enum status apply(struct study_point *point, const struct study *study,
                         const struct study_set *rung, const struct study_method *method,
                         struct study_set *set, struct error *e)
{
    uint64_t plain = 0;
    struct error ignored; /* a scene may need its rung */
    enum status status = take_run_settings(point, &study->set, set, e);
    if (!status && method)
        status = take_run_settings(point, &method->set, set, e);
    if (!status && method && load(point, study, set, &ignored) == STATUS_OK)
        plain = scene_hash(point->scene, &run_vocabulary);
    if (!status)
        status = take_run_settings(point, rung, set, e);
    if (!status)
        status = load(point, study, set, e);
    if (!status)
        point->shipped = method && scene_hash(point->scene, &run_vocabulary) == plain;
    return status;
}

/* `member`: of the point's ensemble; 0: the scene's own seeds. */
static enum status point_create(struct study_point *point, const struct study *study,
                                const struct study_set *rung, const struct study_method *method,
                                size_t member, struct error *e)
{
    struct study_set set = {0};
    struct run_options options = {.backend = point->backend, .renderer = "auto", .isa = "auto", .elsewhere = true};
    strcpy(point->isa, "auto");
    strcpy(point->backend, "cpu");
    point->energy_drift = point->momentum_drift = (double)NAN;
    enum status status = apply(point, study, rung, method, &set, e);
    if (!status && study->known)
        status = case_check(study->known, point->scene, e);
    if (!status && study->seeds > 1)
        status = ensemble_seed(&set, point->scene, member, e);
    if (!status)
        status = set_products(study, point->scene, &set, e);
    if (!status)
        status = load(point, study, &set, e);
    if (!status)
        status = run_check(point->scene, &options, e);
    if (!status && method)
        status = check_columns(study, point->scene, e);
    set_free(&set);
    if (status)
        return error_context(e, "%s, %s", study->path, method ? method->name : "the reference");
    point->guess = fill_bodies_estimate(point->scene);
    return name_folder(point, method ? method->name : "reference", e);
}

/* One for each seed, if the study has several. */
static enum status members_create(struct study_point *point, const struct study *study,
                                  struct error *e)
{
    size_t count = study->seeds > 1 ? (size_t)study->seeds : 0;
    if (!count)
        return STATUS_OK;
    point->members = memory_create("study seeds", count, sizeof *point->members, e);
    if (!point->members)
        return e->status;
    while (point->member_count < count) {
        struct study_point *member = &point->members[point->member_count++];
        *member = (struct study_point){.ladder = point->ladder, .rung = point->rung,
                                       .method = point->method};
        if (point_create(member, study, &point->ladder->rungs[point->rung], point->method,
                         point->member_count - 1, e))
            return e->status;
    }
    return STATUS_OK;
}

enum status study_points_create(struct study_points *points, const struct study *study,
                                struct error *e)
{
    size_t count = study->reference.count > 0;
    for (size_t k = 0; k < study->ladder_count; k++)
        count += study->ladders[k].count * study->method_count;
    *points = (struct study_points){0};
    points->items = memory_create("study points", count, sizeof *points->items, e);
    if (!points->items)
        return e->status;
    if (study->reference.count > 0 &&
        point_create(&points->items[points->count++], study, &study->reference, NULL, 0, e))
        return e->status;
    for (size_t l = 0; l < study->ladder_count; l++)
        for (size_t rung = 0; rung < study->ladders[l].count; rung++)
            for (size_t m = 0; m < study->method_count; m++) {
                struct study_point *point = &points->items[points->count++];
                *point = (struct study_point){.ladder = &study->ladders[l], .rung = rung,
                                              .method = &study->methods[m]};
                if (point_create(point, study, &point->ladder->rungs[rung], point->method, 0, e) ||
                    members_create(point, study, e))
                    return e->status;
            }
    return STATUS_OK;
}

static void point_free(struct study_point *point)
{
    for (size_t k = 0; k < point->member_count; k++)
        point_free(&point->members[k]);
    memory_free(point->members);
    scene_free(point->scene);
    free(point->folder);
}

void study_points_free(struct study_points *points)
{
    for (size_t k = 0; k < points->count; k++)
        point_free(&points->items[k]);
    memory_free(points->items);
    *points = (struct study_points){0};
}

/* Hash of the scene as the study has it, with a method's settings or without. */
static enum status hash_of(const struct study *study, const struct study_method *method,
                           uint64_t *hash, struct error *e)
{
    struct study_point point = {0};
    struct study_set set = {0};
    enum status status = take_run_settings(&point, &study->set, &set, e);
    if (!status && method)
        status = take_run_settings(&point, &method->set, &set, e);
    if (!status)
        status = load(&point, study, &set, e);
    if (!status)
        *hash = scene_hash(point.scene, &run_vocabulary);
    scene_free(point.scene);
    set_free(&set);
    return status;
}

enum status study_default(const struct study *study, const struct study_method **method, bool *own,
                          struct error *e)
{
    uint64_t plain, hash;
    *method = &study->methods[0];
    *own = false;
    if (hash_of(study, NULL, &plain, e))
        return e->status;
    for (size_t k = 0; k < study->method_count && !*own; k++) {
        if (hash_of(study, &study->methods[k], &hash, e))
            return e->status;
        *own = hash == plain;
        *method = *own ? &study->methods[k] : *method;
    }
    return STATUS_OK;
}
