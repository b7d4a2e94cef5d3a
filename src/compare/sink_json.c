/* Records a comparison as JSON. */
#include "base/memory.h"
#include "base/output.h"
#include "base/quote.h"
#include "compare/record.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

struct sink {
    const struct comparison *comparison;
    struct output_file file;
    FILE *out;
    bool any; /* frames written */
};

static void text(FILE *out, const char *string)
{
    char quoted[8300];
    json_quote(string, quoted, sizeof quoted);
    fputs(quoted, out);
}

/* JSON has no infinity: null. */
static void number(FILE *out, double value)
{
    if (isfinite(value))
        fprintf(out, "%.9g", value);
    else
        fputs("null", out);
}

static void write_head(FILE *out, const struct comparison *comparison)
{
    fputs("{\"frames_of\": ", out);
    text(out, comparison->frames);
    fputs(",\n \"baselines\": [", out);
    for (size_t i = 0; i < comparison->baseline_count; i++) {
        fputs(i ? ", " : "", out);
        text(out, comparison->baselines[i]);
    }
    fprintf(out, "],\n \"gate\": \"%s\",\n \"limits\": {\"max-channel\": ", comparison->gate);
    number(out, comparison->limits.settings.levels);
    for (size_t i = 0; i < metric_score_count(); i++)
        if (!isnan(comparison->limits.value[i])) {
            fprintf(out, ", \"%s\": ", metric_score(i)->option);
            number(out, comparison->limits.value[i]);
        }
    fputs("},\n \"frames\": [", out);
}

static enum status json_open(struct sink **made, const struct comparison *comparison,
                             const char *path, struct error *e)
{
    struct sink *sink = *made = memory_create("compare", 1, sizeof *sink, e);
    if (!sink)
        return e->status;
    sink->comparison = comparison;
    if (strcmp(path, "-") != 0 && output_open(&sink->file, path, e)) {
        memory_free(sink);
        return e->status;
    }
    sink->out = sink->file.stream ? sink->file.stream : stdout;
    write_head(sink->out, comparison);
    return STATUS_OK;
}

static void write_scores(FILE *out, const struct comparison *comparison,
                         const struct verdict *verdict)
{
    const char *comma = "";
    fputs(", \"scores\": {", out);
    for (size_t i = 0; i < metric_score_count(); i++) {
        fprintf(out, "%s\"%s\": ", i ? ", " : "", metric_score(i)->name);
        number(out, verdict->values[i]);
    }
    fputs("}, \"broken\": [", out);
    for (size_t i = 0; i < metric_score_count(); i++)
        if (!metric_keeps(metric_score(i), verdict->values[i], comparison->limits.value[i])) {
            fprintf(out, "%s\"%s\"", comma, metric_score(i)->name);
            comma = ", ";
        }
    fputs("]", out);
}

static enum status json_frame(struct sink *sink, const struct verdict *verdict, struct error *e)
{
    fprintf(sink->out, "%s\n  {\"name\": ", sink->any ? "," : "");
    sink->any = true;
    text(sink->out, verdict->name);
    fprintf(sink->out, ", \"state\": \"%s\"", verdict_word(verdict->state));
    if (verdict->accepted) {
        fputs(", \"baseline\": ", sink->out);
        text(sink->out, sink->comparison->baselines[verdict->baseline]);
    }
    if (verdict->state <= VERDICT_DIFFERENT)
        write_scores(sink->out, sink->comparison, verdict);
    fputs("}", sink->out);
    if (ferror(sink->out))
        return error_set(e, STATUS_OUTPUT, "the JSON of the comparison cannot be written: %s",
                         strerror(errno));
    return STATUS_OK;
}

static enum status json_close(struct sink *sink, const struct tally *tally, bool keep,
                              struct error *e)
{
    fputs("],\n \"counts\": {", sink->out);
    for (int s = 0; s < VERDICT_STATES; s++)
        fprintf(sink->out, "%s\"%s\": %zu", s ? ", " : "", verdict_word(s), tally->count[s]);
    fprintf(sink->out, "},\n \"same\": %s}\n", tally->failed ? "false" : "true");
    enum status status = output_close(&sink->file, keep, e);
    memory_free(sink);
    return status;
}

const struct sink_row sink_json = {json_open, json_frame, json_close};
