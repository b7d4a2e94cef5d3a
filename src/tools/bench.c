/* sph-render bench: how fast scenes run, by phase, against this machine's own peak. */
#include "base/log.h"
#include "base/quote.h"
#include "run/report.h"
#include "run/simulation.h"
#include "tools/cli.h"
#include "tools/tools.h"

#include <argp.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SCENES_MAX = 64, SETS_MAX = 64 };

struct bench {
    const char *scenes[SCENES_MAX], *sets[SETS_MAX];
    size_t scene_count, set_count;
    long steps;
    double from; /* s of scene time before measuring */
    struct run_options run;
    bool json;
};

struct result {
    char title[128], backend[128];
    double particles, steps, sorts, time, dt; /* count, count, count, s, s */
    double ns, pairs_per_second, pairs_per_particle, peak, share;
    double bytes;             /* per particle and step, at the least */
    double bandwidth;         /* measured, bytes/s; 0: it was not */
    double phase[PASS_COUNT]; /* ns per particle and step */
    double runs[PASS_COUNT];  /* per step: iterations, of what solves repeat */
    double solve_s; /* measured, s */
};

/* A whole number from 1 to `most`; complains otherwise. */
static long positive(struct argp_state *state, const char *name, const char *value, long most)
{
    char *end;
    long number = strtol(value, &end, 10);
    if (end == value || *end || number < 1 || number > most)
        argp_error(state, "--%s %s: give a whole number from 1 to %ld", name, value, most);
    return number;
}

static double seconds(struct argp_state *state, const char *name, const char *value)
{
    char *end;
    double number = strtod(value, &end);
    if (end == value || *end || !isfinite(number) || number < 0)
        argp_error(state, "--%s %s: give a time in seconds, 0 or more", name, value);
    return number;
}

static error_t parse_option(int key, char *value, struct argp_state *state)
{
    struct bench *b = state->input;
    switch (key) {
    case 'n': b->steps = positive(state, "steps", value, 1000000000); return 0;
    case 't': b->run.threads = (int)positive(state, "threads", value, 4096); return 0;
    case 'f': b->from = seconds(state, "from", value); return 0;
    case 'i': b->run.isa = value; return 0;
    case 'b': b->run.backend = value; return 0;
    case 'p': b->run.timed = true; return 0;
    case 's':
        if (b->set_count == SETS_MAX)
            argp_error(state, "more than %d --set", SETS_MAX);
        b->sets[b->set_count++] = value;
        return 0;
    case 'j': b->json = true; return 0;
    case ARGP_KEY_ARG:
        if (b->scene_count == SCENES_MAX)
            argp_error(state, "more than %d scenes", SCENES_MAX);
        b->scenes[b->scene_count++] = value;
        return 0;
    case ARGP_KEY_NO_ARGS:
        argp_error(state, "no scene; for example: sph-render bench scenes/dambreak.json");
        return 0;
    default: return ARGP_ERR_UNKNOWN;
    }
}

static const struct argp_option options[] = {
    {"steps", 'n', "N", 0, "Measured steps (default 100)", 0},
    {"from", 'f', "T", 0, "Start measuring at scene time T, s (default 0)", 0},
    {"threads", 't', "N", 0, "Threads (default: one per processor)", 0},
    {"backend", 'b', "NAME", 0, "Where particles are computed (default auto)", 0},
    {"phases", 'p', NULL, 0, "Time each pass of cuda by itself, which makes small scenes slower", 0},
    {"isa", 'i', "NAME", 0, "Instruction set: auto, scalar, avx2, avx512", 0},
    {"set", 's', "KEY=VALUE", 0, "Change a key of every scene; may be given several times", 0},
    {"json", 'j', NULL, 0, "JSON instead of a table", 0},
    {0}};

/* Bytes that a pass moves per particle at the least: each field once, and its rows. */
static double pass_bytes(const struct simulation *s, enum pass_id id)
{
    const struct pass_row *pass = &pass_table[id];
    const struct solver_choice *c = &s->plan->choice;
    double bytes = 0, n = fmax((double)s->plan->bodies.count, 1);
    for (int f = 0; f < FIELD_COUNT; f++) {
        unsigned bit = FIELD_BIT(f) & s->plan->fields;
        bytes += (double)field_table[f].size * ((pass->reads & bit ? 1 : 0) + (pass->writes & bit ? 1 : 0));
    }
    if (pass->kind == PASS_PAIR)
        bytes += solver_row_bytes(c) * s->row->counts(s->backend)->row_entries / n;
    return bytes;
}

static void collect(struct simulation *s, const struct backend_counts *before, long steps,
                    long sorts, double elapsed, struct result *r)
{
    const struct backend_counts *now = s->row->counts(s->backend);
    double n = (double)s->plan->bodies.count, work = n * (double)steps;
    double pairs = now->pairs - before->pairs;
    snprintf(r->title, sizeof r->title, "%s", s->plan->scene->title);
    snprintf(r->backend, sizeof r->backend, "%s", s->row->describe(s->backend));
    r->particles = n;
    r->steps = (double)steps;
    r->sorts = (double)(s->stats.sorts - sorts);
    r->time = s->time;
    r->dt = s->last_dt;
    r->solve_s = elapsed;
    r->ns = work > 0 ? elapsed * 1e9 / work : 0;
    r->pairs_per_second = pairs / elapsed;
    r->pairs_per_particle = work > 0 ? pairs / work : 0;
    r->peak = s->row->peak(s->backend);
    r->share = pair_force_flops(s->plan->choice.flags) * pairs / elapsed / r->peak;
    r->bandwidth = s->row->bandwidth ? s->row->bandwidth(s->backend) : 0;
    for (int p = 0; p < PASS_COUNT && work > 0; p++) {
        r->phase[p] = (now->seconds[p] - before->seconds[p]) * 1e9 / work;
        r->runs[p] = (double)(now->runs[p] - before->runs[p]) / (double)steps;
        r->bytes += r->runs[p] * pass_bytes(s, (enum pass_id)p);
    }
}

static enum status measure(const struct bench *b, const char *path, struct result *r,
                           struct error *e)
{
    struct scene *scene = NULL;
    struct plan plan = {0};
    struct simulation s = {0};
    struct scene_overrides set = {.items = b->sets, .count = b->set_count};
    if (scene_load(&scene, path, &set, &run_vocabulary, e) ||
        plan_make(&plan, scene, &b->run, e) || simulation_open(&s, &plan, &b->run, e))
        goto done;
    if (simulation_advance(&s, b->from, e))
        goto done;
    for (int k = 0; k < 3; k++) /* warm up */
        if (simulation_step(&s, INFINITY, e))
            goto done;
    struct backend_counts before = *s.row->counts(s.backend);
    long sorts = s.stats.sorts;
    double start = clock_seconds();
    for (long k = 0; k < b->steps; k++)
        if (simulation_step(&s, INFINITY, e))
            goto done;
    collect(&s, &before, b->steps, sorts, clock_seconds() - start, r);
done:
    simulation_close(&s);
    plan_free(&plan);
    scene_free(scene);
    return e->status;
}

static void print_json(const struct result *r, size_t count)
{
    printf("{\"processor\": \"%s\", \"scenes\": [", report_processor());
    for (size_t k = 0; k < count; k++, r++) {
        char title[2 * sizeof r->title + 3];
        json_quote(r->title, title, sizeof title);
        printf("%s\n  {\"title\": %s, \"backend\": \"%s\", \"particles\": %.0f, "
               "\"steps\": %.0f, \"sorts\": %.0f, \"time\": %.9g, \"dt\": %.9g, "
               "\"ns_per_particle_step\": %.4f, \"ms_per_step\": %.4f, "
               "\"pairs_per_second\": %.6g, \"pairs_per_particle\": %.3f, "
               "\"peak_flops\": %.6g, \"peak_share\": %.4f, \"bytes_per_particle_step\": %.1f, "
               "\"bytes_per_second\": %.6g, \"copy_bandwidth\": %.6g, \"phases\": {",
               k ? "," : "", title, r->backend, r->particles, r->steps, r->sorts, r->time,
               r->dt, r->ns, r->solve_s * 1e3 / r->steps, r->pairs_per_second,
               r->pairs_per_particle, r->peak, r->share, r->bytes, 1e9 * r->bytes / r->ns,
               r->bandwidth);
        const char *comma = "";
        for (int p = 0; p < PASS_COUNT; p++)
            if (r->phase[p] > 0) {
                printf("%s\"%s\": %.4f", comma, pass_table[p].name, r->phase[p]);
                comma = ", ";
            }
        fputs("}, \"runs_per_step\": {", stdout);
        comma = "";
        for (int p = 0; p < PASS_COUNT; p++)
            if (r->phase[p] > 0) {
                printf("%s\"%s\": %.4g", comma, pass_table[p].name, r->runs[p]);
                comma = ", ";
            }
        fputs("}}", stdout);
    }
    fputs("\n]}\n", stdout);
}

static void print_table(const struct result *r, size_t count)
{
    for (size_t k = 0; k < count; k++, r++) {
        printf("%s: %.0f particles on %s, %.0f steps to t = %.4g s, %.0f sorts\n", r->title,
               r->particles, r->backend, r->steps, r->time, r->sorts);
        printf("  %8.1f ns per particle and step   %8.2f ms per step\n", r->ns,
               r->solve_s * 1e3 / r->steps);
        printf("  %8.1f pairs per particle and step %7.1f million pairs per second\n",
               r->pairs_per_particle, r->pairs_per_second * 1e-6);
        printf("  %8.1f %% of this machine's multiply-add peak, %.1f GFLOP/s\n", 100 * r->share,
               r->peak * 1e-9);
        printf("  %8.1f GB/s at the least, %.0f bytes per particle and step", r->bytes / r->ns,
               r->bytes);
        if (r->bandwidth > 0)
            printf(": %.1f %% of what a copy reaches, %.0f GB/s", 1e11 * r->bytes / r->ns / r->bandwidth,
                   1e-9 * r->bandwidth);
        putchar('\n');
        for (int p = 0; p < PASS_COUNT; p++)
            if (r->phase[p] > 0)
                printf("  %8.1f ns  %5.1f %%  %-10s %6.3g a step\n", r->phase[p],
                       100 * r->phase[p] / r->ns, pass_table[p].name, r->runs[p]);
    }
}

static int bench_run(int argc, char **argv)
{
    static const struct argp parser = {.options = options, .parser = parse_option,
        .args_doc = "SCENE.json...",
        .doc = "Times the steps of scenes, without drawing: by phase, in pairs per second, and as a "
               "share of the multiply-add peak that this machine reaches in the same run."};
    struct bench b = {.steps = 100};
    struct result results[SCENES_MAX] = {0};
    struct error e = {.status = STATUS_OK, .text = ""};
    static char name[] = "sph-render bench";
    argv[0] = name;
    if (argp_parse(&parser, argc, argv, 0, NULL, &b))
        return STATUS_USAGE;
    if (b.run.isa)
        cli_check_variant("--isa", "isas", b.run.isa, &e);
    run_warn_threads(b.run.threads);
    for (size_t k = 0; k < b.scene_count && !e.status; k++)
        measure(&b, b.scenes[k], &results[k], &e);
    if (e.status) {
        log_error("%s", e.text);
        return e.status;
    }
    (b.json ? print_json : print_table)(results, b.scene_count);
    return STATUS_OK;
}

const struct tool tool_bench = {
    .variant = {.name = "bench", .doc = "time the steps of scenes, by phase"},
    .run = bench_run,
};
