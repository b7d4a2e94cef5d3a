/* sph-render study: error against run time over methods and ladders of settings. */
#include "base/log.h"
#include "base/memory.h"
#include "base/quote.h"
#include "study/job.h"
#include "study/ledger/ledger.h"
#include "study/map/index.h"
#include "study/products/summary.h"
#include "tools/tools.h"

#include <argp.h>
#include <libgen.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { STUDIES_MAX = 64 };

struct request {
    const char *studies[STUDIES_MAX], *directory;
    size_t count;
    double budget; /* s */
    int repeats;   /* 0: the study's */
    bool stability; /* the studies are stability maps */
    bool ledger;    /* they are scenes, each for a ledger */
    struct ledger_options scene; /* how */
    char *command, *directories[STUDIES_MAX]; /* owned; of each study's results */
};

/* "90", "90s", "20m", "1.5h" to seconds; NAN otherwise. */
static double duration(const char *text)
{
    char *end;
    double value = strtod(text, &end);
    double unit = strcmp(end, "h") == 0 ? 3600 : strcmp(end, "m") == 0 ? 60
                  : strcmp(end, "s") == 0 || !*end ? 1 : (double)NAN;
    return end != text && value > 0 ? value * unit : (double)NAN;
}

static error_t parse_option(int key, char *value, struct argp_state *state)
{
    struct request *r = state->input;
    char *end;
    switch (key) {
    case 'o': r->directory = value; return 0;
    case 'b':
        if (isnan(r->budget = duration(value)))
            argp_error(state, "--budget %s: give a time such as 20m, 90s or 1.5h", value);
        return 0;
    case 'r':
        r->repeats = (int)strtol(value, &end, 10);
        if (*end || r->repeats < 1 || r->repeats > STUDY_REPEATS_MAX)
            argp_error(state, "--repeats %s: give a whole number from 1 to %d", value,
                       STUDY_REPEATS_MAX);
        return 0;
    case 'm': r->stability = true; return 0;
    case 'l': r->ledger = true; return 0;
    case 'n':
        r->scene.steps = strtol(value, &end, 10);
        if (*end || r->scene.steps < 1 || r->scene.steps > 1000000)
            argp_error(state, "--steps %s: give a whole number from 1 to 1000000", value);
        return 0;
    case 't':
        r->scene.threads = (int)strtol(value, &end, 10);
        if (*end || r->scene.threads < 0 || r->scene.threads > 4096)
            argp_error(state, "--threads %s: give a whole number from 0 (all) to 4096", value);
        return 0;
    case 's':
        if (r->scene.set_count == LEDGER_SETS_MAX)
            argp_error(state, "more than %d --set", LEDGER_SETS_MAX);
        r->scene.sets[r->scene.set_count++] = value;
        return 0;
    case 'q': log_set_level(LOG_ERROR); return 0;
    case ARGP_KEY_ARG:
        if (r->count == STUDIES_MAX)
            argp_error(state, "more than %d studies", STUDIES_MAX);
        r->studies[r->count++] = value;
        return 0;
    case ARGP_KEY_END:
        if (r->ledger && (r->stability || isfinite(r->budget)))
            argp_error(state, "--ledger goes with neither --stability nor --budget");
        if (!r->ledger && (r->scene.set_count || r->scene.threads != 1 || r->scene.steps != 50))
            argp_error(state, "--set, --steps and --threads are of --ledger; a study has \"set\"");
        if (!r->count || !r->directory)
            argp_error(state, "give a study and a directory, for example: sph-render study "
                              "studies/taylor-green.json -o out/taylor-green");
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp_option options[] = {
    {"output", 'o', "DIR", 0, "Directory of the results; what it has already is not run again", 0},
    {"budget", 'b', "TIME", 0, "Leave out what does not fit in this time: 20m, 90s, 1.5h", 0},
    {"repeats", 'r', "N", 0, "Runs of each point (default: the study's, 3; of a map 1, of --ledger 5)", 0},
    {"stability", 'm', NULL, 0, "The studies are stability maps (\"map\"): what becomes of each cell", 0},
    {"ledger", 'l', NULL, 0, "SCENE.json instead of a study: what each feature that it leaves out would cost", 0},
    {"steps", 'n', "N", 0, "--ledger: steps of each run (default 50)", 0},
    {"threads", 't', "N", 0, "--ledger: threads of each run (default 1; 0: one per processor)", 0},
    {"set", 's', "KEY=VALUE", 0, "--ledger: change a key of the scene; may be given several times", 0},
    {"quiet", 'q', NULL, 0, "No progress, no messages but errors", 0},
    {0}};

/* Whether the file is of the kind that was asked for. */
static enum status check_kind(const struct request *r, const struct study *study, struct error *e)
{
    if (study->is_map == r->stability)
        return STATUS_OK;
    return error_set(e, STATUS_USAGE, r->stability
                     ? "%s: --stability, but the study has no \"map\"; leave the option out, or give the "
                       "key instead of \"ladders\""
                     : "%s: this is a stability map; add --stability", study->path);
}

/* Its table also to standard output; STATUS_RUN when an absence is not proved. */
static enum status run_ledger(const struct request *r, const char *path, const char *directory,
                              struct error *e)
{
    struct study_about about = {.command = r->command};
    struct ledger_options how = r->scene;
    struct output_claim claim = {NULL, -1};
    struct ledger ledger = {0};
    how.scene = path;
    how.directory = directory;
    how.repeats = r->repeats ? r->repeats : 5;
    about_date(&about, time(NULL));
    if (ledger_check(&how, e) || output_make_directories(directory, e) ||
        output_claim(&claim, directory, e))
        return e->status;
    if (!ledger_make(&ledger, &how, e) && !ledger_write(&ledger, &about, e)) {
        ledger_print(&ledger, &about, stdout);
        if (ledger_failures(&ledger))
            error_set(e, STATUS_RUN, "%s: the absence of %zu features is not proved; see ledger.md",
                      directory, ledger_failures(&ledger));
    }
    ledger_free(&ledger);
    output_release(&claim);
    return e->status;
}

/* DIR for one study, DIR/NAME for each of several. */
static enum status name_directory(struct request *r, size_t k, struct error *e)
{
    char copy[PATH_MAX];
    snprintf(copy, sizeof copy, "%s", r->studies[k]);
    const char *name = r->count > 1 ? basename(copy) : "", *dot = strrchr(name, '.');
    if (asprintf(&r->directories[k], "%s%s%.*s", r->directory, *name ? "/" : "",
                 (int)(dot ? dot - name : (long)strlen(name)), name) >= 0)
        return STATUS_OK;
    r->directories[k] = NULL;
    return error_set(e, STATUS_RUN, "memory is short");
}

/* Studies are told apart by the names of their files, which are those of their directories. */
static enum status check_names(const struct request *r, struct error *e)
{
    for (size_t i = 0; i < r->count; i++)
        for (size_t j = 0; j < i; j++)
            if (strcmp(r->directories[i], r->directories[j]) == 0)
                return error_set(e, STATUS_USAGE, "%s and %s would both be written to %s; give them one "
                                 "by one, each its own -o", r->studies[j], r->studies[i],
                                 r->directories[i]);
    return STATUS_OK;
}

/* What all have in common. */
static enum status summarize(const struct request *r, struct job *jobs, struct error *e)
{
    struct study_results all[STUDIES_MAX];
    for (size_t k = 0; k < r->count; k++)
        all[k] = job_results(&jobs[k]);
    return r->stability ? map_index(all, r->count, r->directory, e)
                        : study_summary(all, r->count, r->directory, e);
}

/* Errors before times: each point once, in all studies, then what a study's share of the budget left out. */
static enum status run_once(const struct request *r, struct job *jobs, double start, struct error *e)
{
    for (int again = 0; again < 2; again++) {
        size_t lack = 0;
        for (size_t k = 0; k < r->count; k++)
            lack += !again || job_lacks(&jobs[k]);
        for (size_t k = 0; k < r->count; k++) {
            double left = r->budget - (clock_seconds() - start);
            if (again && !job_lacks(&jobs[k]))
                continue;
            if (job_run(&jobs[k], 1, left / (double)lack--, e)) /* none takes what others lack, too */
                return e->status;
        }
    }
    return STATUS_OK;
}

/* All are read before anything is run or written; those that are left share the budget that is. */
static enum status run_jobs(const struct request *r, struct job *jobs, struct error *e)
{
    double start = clock_seconds();
    for (size_t k = 0; k < r->count; k++)
        if (job_open(&jobs[k], r->studies[k], r->directories[k], r->command, r->repeats, e) ||
            check_kind(r, &jobs[k].study, e))
            return e->status;
    if (isfinite(r->budget) && run_once(r, jobs, start, e))
        return e->status;
    for (size_t k = 0; k < r->count; k++) {
        double left = r->budget - (clock_seconds() - start);
        if (job_run(&jobs[k], 0, left / (double)(r->count - k), e) || job_write(&jobs[k], e))
            return e->status;
    }
    return summarize(r, jobs, e);
}

static enum status run_studies(const struct request *r, struct error *e)
{
    struct job *jobs = memory_create("studies", r->count, sizeof *jobs, e);
    if (!jobs)
        return e->status;
    run_jobs(r, jobs, e);
    for (size_t k = 0; k < r->count; k++)
        job_close(&jobs[k]);
    memory_free(jobs);
    return e->status;
}

static enum status run_ledgers(const struct request *r, struct error *e)
{
    for (size_t k = 0; k < r->count && !e->status; k++)
        run_ledger(r, r->studies[k], r->directories[k], e);
    return e->status;
}

/* As a shell would read it; malloc. */
static char *join(int argc, char **argv)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out)
        return NULL;
    fputs("sph-render", out);
    for (int k = 0; k < argc; k++) {
        fputc(' ', out);
        shell_quote(argv[k], out);
    }
    return fclose(out) == 0 ? text : NULL;
}

static int study_run_tool(int argc, char **argv)
{
    static const struct argp parser = {.options = options, .parser = parse_option,
        .args_doc = "STUDY.json...",
        .doc = "Runs a scene over methods and ladders of settings and reports error against run time: "
               "tables, figures and a page. The same command goes on where one was stopped."};
    struct request r = {.budget = INFINITY, .scene = {.steps = 50, .threads = 1}};
    struct error e = {.status = STATUS_OK};
    static char name[] = "sph-render study";
    r.command = join(argc, argv);
    argv[0] = name;
    if (argp_parse(&parser, argc, argv, 0, NULL, &r))
        e.status = STATUS_USAGE;
    for (size_t k = 0; k < r.count && !e.status; k++)
        name_directory(&r, k, &e);
    if (!e.status && check_names(&r, &e) == STATUS_OK)
        (r.ledger ? run_ledgers : run_studies)(&r, &e);
    if (e.status && e.text[0])
        log_error("%s", e.text);
    for (size_t k = 0; k < r.count; k++)
        free(r.directories[k]);
    free(r.command);
    return e.status;
}

const struct tool tool_study = {
    .variant = {.name = "study", .doc = "error against run time, over methods and resolutions"},
    .run = study_run_tool,
};
