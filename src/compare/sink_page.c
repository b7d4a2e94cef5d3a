/* Records a comparison as one HTML page that holds its pictures. */
#include "base/html.h"
#include "base/memory.h"
#include "base/output.h"
#include "compare/record.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { SMALL = 320 }; /* pixels: the width of a frame that is equal, about */

struct sink {
    const struct comparison *comparison;
    struct output_file file;
};

static const char head[] =
    "<!DOCTYPE html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>sph-render compare</title>\n"
    "<style>body{font:15px sans-serif;margin:1em;display:flex;flex-direction:column}"
    "header{order:-2}.bad{order:-1}figure{display:inline-block;margin:.3em;max-width:32%}"
    "img{max-width:100%;image-rendering:pixelated}table{border-collapse:collapse}"
    "td,th{padding:0 .8em 0 0;text-align:left}.over{color:#c00;font-weight:bold}"
    "summary{cursor:pointer}</style>\n";

static enum status page_open(struct sink **made, const struct comparison *comparison,
                             const char *path, struct error *e)
{
    struct stat info;
    char *index = NULL;
    struct sink *sink = *made = memory_create("compare", 1, sizeof *sink, e);
    if (!sink)
        return e->status;
    sink->comparison = comparison;
    bool directory = stat(path, &info) == 0 && S_ISDIR(info.st_mode);
    if (asprintf(&index, directory ? "%s/index.html" : "%s", path) < 0)
        index = NULL;
    if (!index)
        error_set(e, STATUS_RUN, "memory is short");
    else if (output_open(&sink->file, index, e) == STATUS_OK)
        e->status = STATUS_OK;
    free(index);
    if (e->status)
        memory_free(sink);
    else
        fputs(head, sink->file.stream);
    return e->status;
}

/* `width`: about, pixels; 0: as it is. */
static enum status figure(struct sink *sink, const struct image *image, int width,
                          const char *caption, const char *of, struct error *e)
{
    FILE *out = sink->file.stream;
    fputs("<figure>", out);
    if (html_image(out, image, width, sink->file.path, e))
        return e->status;
    fprintf(out, "<figcaption>%s ", caption);
    html_text(out, of);
    fputs("</figcaption></figure>\n", out);
    return STATUS_OK;
}

static enum status figures(struct sink *sink, const struct verdict *verdict, struct error *e)
{
    struct image map = {0};
    enum status status = STATUS_OK;
    if (verdict->state == VERDICT_EQUAL)
        return figure(sink, verdict->frame, SMALL, "equal to that of",
                      sink->comparison->baselines[verdict->baseline], e);
    if (verdict->frame)
        status = figure(sink, verdict->frame, 0, "of", sink->comparison->frames, e);
    if (!status && verdict->accepted)
        status = figure(sink, verdict->accepted, 0, "accepted:",
                        sink->comparison->baselines[verdict->baseline], e);
    if (status || verdict->state > VERDICT_DIFFERENT)
        return status;
    if ((status = verdict_map(verdict, &map, e)) == STATUS_OK)
        status = figure(sink, &map, 0, "differences, 16 times", "", e);
    image_free(&map);
    return status;
}

static void scores(FILE *out, const struct comparison *comparison, const struct verdict *verdict)
{
    fputs("<table><tr>", out);
    for (size_t i = 0; i < metric_score_count(); i++)
        fprintf(out, "<th>%s</th>", metric_score(i)->name);
    fputs("</tr><tr>", out);
    for (size_t i = 0; i < metric_score_count(); i++) {
        double value = verdict->values[i], limit = comparison->limits.value[i];
        const struct score *score = metric_score(i);
        fprintf(out, "<td%s>%.5g", metric_keeps(score, value, limit) ? "" : " class=\"over\"", value);
        if (!isnan(limit))
            fprintf(out, " (%s %g)", score->is_likeness ? "at least" : "at most", limit);
        fputs("</td>", out);
    }
    fputs("</tr></table>\n", out);
}

/* Frames that fail stand open and first; the others wait to be opened. */
static enum status page_frame(struct sink *sink, const struct verdict *verdict, struct error *e)
{
    FILE *out = sink->file.stream;
    bool bad = !verdict_passes(verdict->state);
    fprintf(out, "<details%s><summary>", bad ? " class=\"bad\" open" : "");
    html_text(out, verdict->name);
    fprintf(out, ": %s</summary>\n", verdict_word(verdict->state));
    if (verdict->state == VERDICT_SAME || verdict->state == VERDICT_DIFFERENT)
        scores(out, sink->comparison, verdict);
    if (figures(sink, verdict, e))
        return e->status;
    fputs("</details>\n", out);
    if (ferror(out))
        return error_set(e, STATUS_OUTPUT, "cannot write %s: %s", sink->file.part, strerror(errno));
    return STATUS_OK;
}

static enum status page_close(struct sink *sink, const struct tally *tally, bool keep,
                              struct error *e)
{
    FILE *out = sink->file.stream;
    fprintf(out, "<header><h1>%s</h1><p>", tally->failed ? "Different" : "Same");
    html_text(out, sink->comparison->frames);
    fprintf(out, ", gate %s: %zu frames", sink->comparison->gate, tally->frames);
    for (int s = 0; s < VERDICT_STATES; s++)
        if (tally->count[s])
            fprintf(out, ", %zu %s", tally->count[s], verdict_word(s));
    fputs("</p></header></html>\n", out);
    enum status status = output_close(&sink->file, keep, e);
    memory_free(sink);
    return status;
}

const struct sink_row sink_page = {page_open, page_frame, page_close};
