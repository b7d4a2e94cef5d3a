/* sph-render compare: are frames the same, by how much not, and where. */
#include "tools/compare.h"

#include "base/log.h"
#include "compare/lineup.h"
#include "compare/record.h"

#include <argp.h>
#include <errno.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { EXIT_SAME = 0, EXIT_DIFFERENT = 1, EXIT_ERROR = 2 };

enum { OPTION_GATE = 0x100, OPTION_MAX_CHANNEL, OPTION_JSON, OPTION_DIFF, OPTION_SIDE, OPTION_HTML,
       OPTION_HELP, OPTION_USAGE, OPTION_LIMIT /* and one more for each score */ };

struct request {
    const char *paths[LINEUP_MAX]; /* the frames, and their accepted versions */
    size_t path_count;
    const char *gate, *json, *diff, *side, *html;
    double levels, limits[SCORES_MAX]; /* that replace the gate's; NAN: none */
    bool help;
};

struct session {
    struct comparison comparison;
    struct record record;
    struct lineup lineup; /* the frames and their accepted versions */
};

/* The sources go in step: each frame is compared as soon as it is read. */
static enum status compare_frames(struct session *x, struct error *e)
{
    for (;;) {
        const struct image *frames[LINEUP_MAX];
        struct verdict verdict;
        const struct source first = *lineup_first(&x->lineup);
        if (first.ended)
            return STATUS_OK;
        if (lineup_read(&x->lineup, &first, frames, e) ||
            verdict_make(&verdict, first.name, &x->comparison.limits, frames[0], frames + 1,
                         x->lineup.count - 1, e) ||
            record_frame(&x->record, &verdict, e))
            return e->status;
    }
}

static enum status open_sources(struct session *x, const struct request *request, struct error *e)
{
    if (lineup_open(&x->lineup, request->paths, request->path_count, e))
        return e->status;
    x->comparison.single = x->lineup.order == SOURCE_ALONE;
    return STATUS_OK;
}

static enum status open_sinks(struct session *x, const struct request *request, struct error *e)
{
    const struct {
        const struct sink_row *row;
        const char *path;
    } sinks[SINKS_MAX] = {
        {&sink_text, request->json && strcmp(request->json, "-") == 0 ? NULL : ""},
        {&sink_json, request->json}, {&sink_map, request->diff}, {&sink_side, request->side},
        {&sink_page, request->html}};
    for (size_t i = 0; i < SINKS_MAX; i++)
        if (sinks[i].path && record_add(&x->record, sinks[i].row, sinks[i].path, e))
            return e->status;
    return STATUS_OK;
}

static enum status set_comparison(struct comparison *comparison, const struct request *request,
                                  struct error *e)
{
    comparison->frames = request->paths[0];
    comparison->baselines = request->paths + 1;
    comparison->baseline_count = request->path_count - 1;
    comparison->gate = request->gate;
    comparison->text = stdout;
    if (gate_limits(&comparison->limits, request->gate, e))
        return e->status;
    if (!isnan(request->levels))
        comparison->limits.settings.levels = request->levels;
    for (size_t i = 0; i < metric_score_count(); i++)
        if (!isnan(request->limits[i]))
            comparison->limits.value[i] = request->limits[i];
    return STATUS_OK;
}

static int compare(const struct request *request)
{
    struct session x = {0};
    struct error e = {.status = STATUS_OK}, ignored;
    x.record.comparison = &x.comparison;
    if (set_comparison(&x.comparison, request, &e) == STATUS_OK &&
        open_sources(&x, request, &e) == STATUS_OK && open_sinks(&x, request, &e) == STATUS_OK)
        e.status = compare_frames(&x, &e);
    enum status status = e.status;
    if (record_close(&x.record, !status, status ? &ignored : &e))
        status = status ? status : e.status;
    lineup_close(&x.lineup);
    if (status)
        log_error("compare: %s", e.text);
    return status ? EXIT_ERROR : x.record.tally.failed ? EXIT_DIFFERENT : EXIT_SAME;
}

/* A number of 0 to most; EINVAL with a message otherwise. */
static error_t number_read(const struct argp_state *state, const char *option, const char *text,
                           double most, double *value)
{
    char *end;
    *value = strtod(text, &end);
    if (end != text && *end == '\0' && *value >= 0 && *value <= most)
        return 0;
    fprintf(stderr, "%s: --%s needs a number from 0 to %g, not \"%s\"\n", state->name, option,
            most, text);
    return EINVAL;
}

static error_t path_read(const struct argp_state *state, struct request *request, char *text)
{
    if (request->path_count < LINEUP_MAX) {
        request->paths[request->path_count++] = text;
        return 0;
    }
    fprintf(stderr, "%s: more than %d accepted versions; put patterns such as 'frames/*.png' in "
            "quotes\n", state->name, BASELINES_MAX);
    return EINVAL;
}

static error_t help(struct request *request, struct argp_state *state, unsigned flags)
{
    request->help = true;
    argp_state_help(state, stdout, flags & ~(unsigned)ARGP_HELP_EXIT_OK);
    return 0;
}

static error_t option_read(int key, char *text, struct argp_state *state)
{
    struct request *request = state->input;
    size_t limit = (size_t)key - OPTION_LIMIT;
    switch (key) {
    case OPTION_GATE: request->gate = text; return 0;
    case OPTION_JSON: request->json = text; return 0;
    case OPTION_DIFF: request->diff = text; return 0;
    case OPTION_SIDE: request->side = text; return 0;
    case OPTION_HTML: request->html = text; return 0;
    case OPTION_MAX_CHANNEL:
        return number_read(state, "max-channel", text, 255, &request->levels);
    case OPTION_HELP: return help(request, state, ARGP_HELP_STD_HELP);
    case OPTION_USAGE: return help(request, state, ARGP_HELP_USAGE);
    case ARGP_KEY_ARG: return path_read(state, request, text);
    case ARGP_KEY_END:
        if (request->help || request->path_count >= 2)
            return 0;
        fprintf(stderr, "%s: needs frames and at least one accepted version of them, has %zu; see "
                "--help\n", state->name, request->path_count);
        return EINVAL;
    default:
        if (key < OPTION_LIMIT || limit >= metric_score_count())
            return ARGP_ERR_UNKNOWN;
        return number_read(state, metric_score(limit)->option, text, metric_score(limit)->most,
                           &request->limits[limit]);
    }
}

static const struct argp_option fixed[] = {
    {"gate", OPTION_GATE, "NAME", 0, "Limits to keep: same-stack (default), exact or cross-driver; "
     "`sph-render list gates' says what they are", 1},
    {"max-channel", OPTION_MAX_CHANNEL, "LEVELS", 0,
     "Channels (0 to 255) that differ by this much count as the same (default 2)", 1},
    {"json", OPTION_JSON, "FILE|-", 0, "Write scores and verdicts; - is standard output", 3},
    {"html", OPTION_HTML, "FILE|DIR", 0, "Write a page with the pictures of every frame in it", 3},
    {"diff", OPTION_DIFF, "D.png", 0, "Write the differences, 16 times amplified; of a set, "
     "x-%04d.png, for each frame that fails", 3},
    {"side-by-side", OPTION_SIDE, "S.png", 0, "The same with both frames beside them", 3},
    {"help", OPTION_HELP, NULL, 0, "Print this help", -1},
    {"usage", OPTION_USAGE, NULL, 0, "Print the options in short", -1},
};
enum { FIXED = sizeof fixed / sizeof *fixed };

/* The fixed options, and one for the limit of each score. */
static void make_options(struct argp_option options[FIXED + SCORES_MAX + 1])
{
    memcpy(options, fixed, sizeof fixed);
    for (size_t i = 0; i < metric_score_count(); i++)
        options[FIXED + i] = (struct argp_option){metric_score(i)->option, OPTION_LIMIT + (int)i,
                                                  "N", 0, metric_score(i)->doc, 2};
    options[FIXED + metric_score_count()] = (struct argp_option){0};
}

static int compare_run(int argc, char **argv)
{
    struct argp_option options[FIXED + SCORES_MAX + 1];
    const struct argp argp = {
        options, option_read, "FRAMES ACCEPTED...",
        "Says whether frames are the same as accepted ones: pictures (PNG), directories of them, "
        "patterns ('x-%04d.png' or 'x-*.png', in quotes) or films. Of several accepted versions any "
        "one will do, frame by frame. A frame that is missing, or too many, is a difference."
        "\vLimits replace those of the gate one by one. Exit code: 0 same, 1 different, 2 error.",
        NULL, NULL, NULL};
    static char name[] = "sph-render compare"; /* for argp's messages */
    struct request request = {.gate = gate_table.rows[0]->name, .levels = NAN};
    for (size_t i = 0; i < SCORES_MAX; i++)
        request.limits[i] = NAN;
    argv[0] = name;
    make_options(options);
    if (argp_parse(&argp, argc, argv, ARGP_NO_EXIT | ARGP_NO_HELP, NULL, &request) != 0)
        return EXIT_ERROR;
    return request.help ? 0 : compare(&request);
}

const struct tool tool_compare = {
    .variant = {.name = "compare", .doc = "says whether pictures, sets of them or films are the same"},
    .run = compare_run,
};
