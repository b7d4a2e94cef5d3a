/* Records a comparison as one HTML page that holds its pictures. */
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

static void escape(FILE *out, const char *text)
{
    for (; *text; text++)
        switch (*text) {
        case '&': fputs("&amp;", out); break;
        case '<': fputs("&lt;", out); break;
        case '>': fputs("&gt;", out); break;
        case '"': fputs("&quot;", out); break;
        default: putc(*text, out);
        }
}

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

static void base64(FILE *out, const unsigned char *bytes, size_t size)
{
    static const char letters[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < size; i += 3) {
        unsigned left = size - i < 3 ? (unsigned)(size - i) : 3, three = (unsigned)bytes[i] << 16;
        three |= left > 1 ? (unsigned)bytes[i + 1] << 8 : 0;
        three |= left > 2 ? (unsigned)bytes[i + 2] : 0;
        for (unsigned k = 0; k < 4; k++)
            putc(k <= left ? letters[three >> (18 - 6 * k) & 63] : '=', out);
    }
}

static enum status figure(struct sink *sink, const struct image *image, const char *caption,
                          const char *of, struct error *e)
{
    FILE *out = sink->file.stream;
    char *bytes = NULL;
    size_t size = 0;
    FILE *memory = open_memstream(&bytes, &size);
    if (!memory)
        return error_set(e, STATUS_RUN, "memory is short");
    enum status status = image_write_png_to(image, memory, sink->file.path, e);
    if (fclose(memory) != 0 && !status)
        status = error_set(e, STATUS_RUN, "memory is short");
    if (!status) {
        fputs("<figure><img alt=\"\" src=\"data:image/png;base64,", out);
        base64(out, (const unsigned char *)bytes, size);
        fprintf(out, "\"><figcaption>%s ", caption);
        escape(out, of);
        fputs("</figcaption></figure>\n", out);
    }
    free(bytes);
    return status;
}

/* Means of squares of `factor` pixels. */
static enum status shrink(struct image *out, const struct image *in, int factor, struct error *e)
{
    if (image_create(out, in->width / factor, in->height / factor, e))
        return e->status;
    for (int y = 0; y < out->height; y++)
        for (int x = 0; x < out->width; x++)
            for (int k = 0; k < 4; k++) {
                int sum = 0;
                for (int i = 0; i < factor * factor; i++)
                    sum += in->rgba[4 * ((size_t)(y * factor + i / factor) * (size_t)in->width +
                                         (size_t)(x * factor + i % factor)) + (size_t)k];
                out->rgba[4 * ((size_t)y * (size_t)out->width + (size_t)x) + (size_t)k] =
                    (uint8_t)(sum / (factor * factor));
            }
    return STATUS_OK;
}

static enum status small_figure(struct sink *sink, const struct verdict *verdict, struct error *e)
{
    struct image small = {0};
    const struct image *in = verdict->frame;
    int side = in->width < in->height ? in->width : in->height, factor = in->width / SMALL;
    factor = factor < 1 ? 1 : factor > side ? side : factor;
    enum status status = shrink(&small, in, factor, e);
    if (!status)
        status = figure(sink, &small, "equal to that of",
                        sink->comparison->baselines[verdict->baseline], e);
    image_free(&small);
    return status;
}

static enum status figures(struct sink *sink, const struct verdict *verdict, struct error *e)
{
    struct image map = {0};
    enum status status = STATUS_OK;
    if (verdict->state == VERDICT_EQUAL)
        return small_figure(sink, verdict, e);
    if (verdict->frame)
        status = figure(sink, verdict->frame, "of", sink->comparison->frames, e);
    if (!status && verdict->accepted)
        status = figure(sink, verdict->accepted, "accepted:",
                        sink->comparison->baselines[verdict->baseline], e);
    if (status || verdict->state > VERDICT_DIFFERENT)
        return status;
    if ((status = verdict_map(verdict, &map, e)) == STATUS_OK)
        status = figure(sink, &map, "differences, 16 times", "", e);
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
    escape(out, verdict->name);
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
    escape(out, sink->comparison->frames);
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
