/* Reads the options of a film. */
#include "backend/backend.h"
#include "base/log.h"
#include "compare/gate.h"
#include "tools/cli.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const struct cli_option *option_by_key(int key)
{
    for (size_t i = 0; i < cli_option_count; i++)
        if (cli_options[i].key == key)
            return &cli_options[i];
    return NULL;
}

/* A string that lives as long as cli; NULL when memory is short. */
static char *made_string(struct cli *cli, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
static char *made_string(struct cli *cli, const char *format, ...)
{
    va_list args;
    char *text = NULL;
    va_start(args, format);
    if (vasprintf(&text, format, args) < 0)
        text = NULL;
    va_end(args);
    if (text)
        cli->made[cli->made_count++] = text;
    else
        error_set(&cli->error, STATUS_RUN, "memory is short");
    return text;
}

/* "key.path=value" over the scene, which messages call by the label; NULL when memory was short. */
static void add_item(struct cli *cli, const char *label, const char *item)
{
    if (!label || !item)
        return;
    cli->labels[cli->set.count] = label;
    cli->items[cli->set.count++] = item;
}

/* --fps 60 is movie.fps=60; messages speak of --fps. */
static void add_override(struct cli *cli, const struct cli_option *option, const char *value)
{
    add_item(cli, made_string(cli, "--%s %s", option->name, value),
             option->path ? made_string(cli, "%s=%s", option->path, value) : value);
}

static bool read_pair(const char *value, int pair[2])
{
    int used = 0;
    return sscanf(value, "%6d%*1[xX]%6d%n", &pair[0], &pair[1], &used) == 2 && !value[used];
}

static void add_size(struct cli *cli, const struct cli_option *option, const char *value)
{
    int size[2];
    if (!read_pair(value, size)) {
        error_set(&cli->error, STATUS_USAGE, "--size %s: write WIDTHxHEIGHT, for example 1280x720",
                  value);
        return;
    }
    add_item(cli, made_string(cli, "--size %s", value),
             made_string(cli, "%s=[%d, %d]", option->path, size[0], size[1]));
}

/* "eye=1,2,3 fov=40" is camera.eye=[1, 2, 3] and camera.fov=40. */
static void add_camera(struct cli *cli, const struct cli_option *option, const char *value)
{
    for (const char *word = value + strspn(value, " "); *word && !cli->error.status;) {
        int length = (int)strcspn(word, " ");
        char *label = made_string(cli, "--%s %.*s", option->name, length, word);
        const char *equals = label ? strchr(label, '=') : NULL;
        char *name = made_string(cli, "%.*s", (int)strcspn(word, "= "), word);
        double v[3];
        int used = 0;
        if (!equals)
            error_set(&cli->error, STATUS_USAGE, "--%s %s: write for example \"eye=3,1,3 fov=40\"",
                      option->name, value);
        else if (sscanf(equals, "=%lf,%lf,%lf%n", &v[0], &v[1], &v[2], &used) == 3 && !equals[used])
            add_item(cli, label, made_string(cli, "%s.%s=[%.17g, %.17g, %.17g]", option->path, name,
                                             v[0], v[1], v[2]));
        else if (strchr(equals, ',') && !strchr(equals, '['))
            add_item(cli, label, made_string(cli, "%s.%s=[%s]", option->path, name, equals + 1));
        else
            add_item(cli, label, made_string(cli, "%s.%s%s", option->path, name, equals));
        if (name && strcmp(name, "eye") == 0) /* the camera can be at one place only */
            add_item(cli, label, "camera.keyframes=[]");
        word += length + (int)strspn(word + length, " ");
    }
}

/* In a sheet the time stands under the pictures. */
static void read_sheet(struct cli *cli, const char *value)
{
    int *sheet = cli->run.sheet;
    if (!read_pair(value, sheet) || sheet[0] < 1 || sheet[1] < 1 || sheet[0] > 100 || sheet[1] > 100)
        error_set(&cli->error, STATUS_USAGE, "--sheet %s: write COLUMNSxROWS of pictures, for example "
                  "3x2, up to 100 each", value);
    else
        add_item(cli, made_string(cli, "--sheet %s", value), "render.time=false");
}

/* "0.5,1,1.5" */
static void read_times(struct cli *cli, const char *value)
{
    for (const char *p = value;; p++) {
        char *end;
        double time = strtod(p, &end);
        if (end == p || (*end && *end != ',') || !isfinite(time) || time < 0) {
            error_set(&cli->error, STATUS_USAGE, "--at %s: give a time in seconds, 0 or more, or "
                      "several: 0.5,1,1.5", value);
            return;
        }
        cli->times[cli->run.time_count++] = time;
        if (!*(p = end))
            return;
    }
}

static int by_time(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return x < y ? -1 : x > y;
}

/* What several options together must be. */
static enum status check_times(struct cli *cli)
{
    struct run_options *run = &cli->run;
    size_t cells = (size_t)run->sheet[0] * (size_t)run->sheet[1];
    qsort(cli->times, run->time_count, sizeof *cli->times, by_time);
    for (size_t i = 1; i < run->time_count; i++)
        if (cli->times[i] == cli->times[i - 1])
            return error_set(&cli->error, STATUS_USAGE, "--at: the time %g is given twice",
                             cli->times[i]);
    if (cells && run->time_count > cells)
        return error_set(&cli->error, STATUS_USAGE, "--sheet %dx%d has room for %zu pictures, and --at "
                         "gives %zu times", run->sheet[0], run->sheet[1], cells, run->time_count);
    return STATUS_OK;
}

static void read_threads(struct cli *cli, const char *value)
{
    char *end;
    long threads = strtol(value, &end, 10);
    if (end == value || *end || threads < 0 || threads > 4096)
        error_set(&cli->error, STATUS_USAGE, "--threads %s: give a whole number from 0 to 4096",
                  value);
    cli->run.threads = (int)threads;
}

static void read_variant(struct cli *cli, const struct cli_option *option, const char *value,
                         const char **out)
{
    char what[40];
    snprintf(what, sizeof what, "--%s", option->name);
    *out = value;
    cli_check_variant(what, option->table, value, &cli->error);
}

static void read_backend(struct cli *cli, const char *value)
{
    struct backend_place place;
    cli->run.backend = value;
    backend_find(value, &place, &cli->error);
}

static void read_argument(struct cli *cli, const char *value)
{
    if (cli->scene)
        error_set(&cli->error, STATUS_USAGE, "one scene at a time: %s and %s%s", cli->scene, value,
                  cli->run.output_count ? "" : "; outputs go after -o");
    else
        cli->scene = value;
}

static error_t parse_option(int key, char *value, struct argp_state *state)
{
    struct cli *cli = state->input;
    const struct cli_option *option = option_by_key(key);
    switch (key) {
    case 'o': cli->outputs[cli->run.output_count++] = value; break;
    case 'q': cli->quiet = true; log_set_level(LOG_ERROR); break;
    case 'v': log_set_level(LOG_DETAIL); break;
    case CLI_AT: read_times(cli, value); break;
    case CLI_SHEET: read_sheet(cli, value); break;
    case CLI_CAMERA: add_camera(cli, option, value); break;
    case CLI_PRINT_CAMERA: cli->print_camera = true; break;
    case CLI_SIZE: add_size(cli, option, value); break;
    case CLI_SET:
    case CLI_FPS:
    case CLI_END:
    case CLI_SOLVER:
    case CLI_COLOR: add_override(cli, option, value); break;
    case CLI_THREADS: read_threads(cli, value); break;
    case CLI_BACKEND: read_backend(cli, value); break;
    case CLI_RENDERER: read_variant(cli, option, value, &cli->run.renderer); break;
    case CLI_ISA: read_variant(cli, option, value, &cli->run.isa); break;
    case CLI_STRICT: cli->run.strict = true; break;
    case CLI_CHECK: cli->check = true; break;
    case CLI_PLAN: cli->plan = true; break;
    case CLI_REPORT: cli->run.report = value; break;
    case CLI_WRITE_SCENE: cli->run.write_scene = value; break;
    case CLI_REFERENCE: cli->references[cli->reference.count++] = value; break;
    case CLI_UPDATE: cli->reference.update = true; break;
    case CLI_GATE: cli->reference.gate = value; break;
    case CLI_HTML: cli->reference.page = value; break;
    case ARGP_KEY_ARG: read_argument(cli, value); break;
    default: return ARGP_ERR_UNKNOWN;
    }
    return cli->error.status ? EINVAL : 0;
}

/* --reference is an output, the last one: what it says of the others must not undo them. */
static enum status finish_reference(struct cli *cli)
{
    struct encode_reference *reference = &cli->reference;
    const char *alone = reference->update ? "--update" : reference->gate ? "--gate"
                        : reference->page ? "--html" : NULL;
    if (!reference->count)
        return alone ? error_set(&cli->error, STATUS_USAGE, "%s needs --reference DIR", alone)
                     : STATUS_OK;
    reference->paths = cli->references;
    if (!reference->gate)
        reference->gate = gate_table.rows[0]->name;
    cli->outputs[cli->run.output_count++] = "reference";
    cli->run.reference = reference;
    return STATUS_OK;
}

static char *filter_help(int key, const char *text, void *input)
{
    (void)input;
    char *made = cli_help(key, text);
    return made ? made : (char *)text;
}

enum status cli_parse(struct cli *cli, int argc, char **argv)
{
    struct argp_option options[64];
    const struct argp argp = {options, parse_option, "SCENE.json -o OUT\nCOMMAND ...",
                              "Renders movies of SPH fluid simulations without a screen.\v ", NULL,
                              filter_help, NULL};
    size_t room = (size_t)argc + 1;
    for (int i = 0; i < argc; i++) /* one option may say several things, of two letters at least */
        room += strlen(argv[i]);
    *cli = (struct cli){.run = {.backend = "auto", .renderer = "auto", .isa = "auto"},
                        .outputs = calloc(room, sizeof(char *)),
                        .items = calloc(room, sizeof(char *)),
                        .labels = calloc(room, sizeof(char *)),
                        .references = calloc(room, sizeof(char *)),
                        .times = calloc(room, sizeof(double)),
                        .made = calloc(2 * room, sizeof(char *))};
    if (!cli->outputs || !cli->items || !cli->labels || !cli->times || !cli->references || !cli->made)
        return error_set(&cli->error, STATUS_RUN, "memory is short");
    _Static_assert(sizeof options / sizeof *options > 40, "room for all options and groups");
    if (cli_check_names(argc, argv, &cli->error))
        return cli->error.status;
    cli_argp_options(options);
    error_t failed = argp_parse(&argp, argc, argv, 0, NULL, cli);
    cli->run.outputs = cli->outputs;
    cli->run.times = cli->times;
    cli->set.items = cli->items;
    cli->set.labels = cli->labels;
    if (failed && !cli->error.status)
        return error_set(&cli->error, STATUS_RUN, "options: %s", strerror(failed));
    if (cli->error.status || check_times(cli))
        return cli->error.status;
    return finish_reference(cli);
}

void cli_free(struct cli *cli)
{
    for (size_t i = 0; i < cli->made_count; i++)
        free(cli->made[i]);
    free(cli->made);
    free(cli->outputs);
    free(cli->items);
    free(cli->labels);
    free(cli->references);
    free(cli->times);
}
