/* Records a comparison as text: frames that fail, the worst scores, and the verdict. */
#include "base/memory.h"
#include "compare/record.h"

#include <math.h>
#include <stdio.h>

struct sink {
    const struct comparison *comparison;
    struct {
        double value; /* NAN: none yet */
        char frame[300];
    } worst[SCORES_MAX];
};

static enum status text_open(struct sink **made, const struct comparison *comparison,
                             const char *path, struct error *e)
{
    struct sink *sink = *made = memory_create("compare", 1, sizeof *sink, e);
    (void)path;
    if (!sink)
        return e->status;
    sink->comparison = comparison;
    for (size_t i = 0; i < SCORES_MAX; i++)
        sink->worst[i].value = NAN;
    return STATUS_OK;
}

static void note_worst(struct sink *sink, const struct verdict *verdict)
{
    for (size_t i = 0; i < metric_score_count(); i++) {
        double value = verdict->values[i], worst = sink->worst[i].value;
        if (isnan(value) || (!isnan(worst) && metric_keeps(metric_score(i), value, worst)))
            continue;
        sink->worst[i].value = value;
        snprintf(sink->worst[i].frame, sizeof sink->worst[i].frame, "%s", verdict->name);
    }
}

static void print_broken(const struct sink *sink, const struct verdict *verdict)
{
    for (size_t i = 0; i < metric_score_count(); i++)
        if (!metric_keeps(metric_score(i), verdict->values[i], sink->comparison->limits.value[i]))
            fprintf(sink->comparison->text, "  %s %.6g", metric_score(i)->name, verdict->values[i]);
}

static enum status text_frame(struct sink *sink, const struct verdict *verdict, struct error *e)
{
    const struct image *a = verdict->frame, *b = verdict->accepted;
    (void)e;
    note_worst(sink, verdict);
    if (verdict_passes(verdict->state))
        return STATUS_OK;
    fprintf(sink->comparison->text, "%s: %s", verdict->name, verdict_word(verdict->state));
    if (verdict->state == VERDICT_SIZE)
        fprintf(sink->comparison->text, ", %d x %d instead of %d x %d", a->width, a->height, b->width, b->height);
    if (verdict->state == VERDICT_DIFFERENT)
        print_broken(sink, verdict);
    if (b && sink->comparison->baseline_count > 1)
        fprintf(sink->comparison->text, "  from %s", sink->comparison->baselines[verdict->baseline]);
    putc('\n', sink->comparison->text);
    return STATUS_OK;
}

static void print_worst(const struct sink *sink)
{
    for (size_t i = 0; i < metric_score_count(); i++) {
        double value = sink->worst[i].value, limit = sink->comparison->limits.value[i];
        const struct score *score = metric_score(i);
        if (isnan(value))
            continue;
        fprintf(sink->comparison->text, "%-12s %-12.6g", score->name, value);
        if (!isnan(limit))
            fprintf(sink->comparison->text, " %s %g", score->is_likeness ? "at least" : "at most", limit);
        if (!sink->comparison->single && value != score->equal)
            fprintf(sink->comparison->text, "  (worst: %s)", sink->worst[i].frame);
        putc('\n', sink->comparison->text);
    }
}

static enum status text_close(struct sink *sink, const struct tally *tally, bool keep,
                              struct error *e)
{
    (void)e;
    if (keep) {
        print_worst(sink);
        if (!sink->comparison->single)
            fprintf(sink->comparison->text, "%zu frame%s", tally->frames, tally->frames == 1 ? "" : "s");
        for (int s = 0; s < VERDICT_STATES && !sink->comparison->single; s++)
            if (tally->count[s])
                fprintf(sink->comparison->text, ", %zu %s", tally->count[s], verdict_word(s));
        if (!sink->comparison->single)
            putc('\n', sink->comparison->text);
        fprintf(sink->comparison->text, "%s\n", tally->failed ? "different" : "same");
    }
    memory_free(sink);
    return STATUS_OK; /* whoever owns the stream checks it */
}

const struct sink_row sink_text = {text_open, text_frame, text_close};
