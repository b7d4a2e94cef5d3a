/* The numbers of a figure, for gnuplot and for readers. */
#include "base/output.h"
#include "study/products/plot_script.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void plot_path(const struct study_results *results, const struct figure *figure, const char *suffix,
               char *out, size_t size)
{
    snprintf(out, size, "%s/plots/%s.%s", results->directory, figure->stem, suffix);
}

static void write_mark(const struct figure_mark *mark, FILE *out)
{
    char name[256];
    study_point_name(mark->point, name, sizeof name);
    for (char *c = name; *c; c++)
        *c = *c == '"' ? '\'' : *c;
    fprintf(out, "%.9g %.9g \"%s\" \"%s\"", mark->x, mark->y, outcome_names[mark->point->outcome], name);
    if (!isnan(mark->high))
        fprintf(out, " %.9g %.9g", mark->low, mark->high);
    fputc('\n', out);
}

static void write_methods(const struct figure_view *view, FILE *out)
{
    const struct study_method *last = NULL;
    for (size_t k = 0; k < view->count; k++) {
        const struct figure_mark *mark = &view->marks[k];
        if (mark->failed)
            continue;
        if (mark->point->method != last)
            fprintf(out, "%s# method: %s\n", last ? "\n\n" : "", mark->point->method->name);
        last = mark->point->method;
        write_mark(mark, out);
    }
}

/* The marks of the front by rising x. */
static void write_front(const struct figure_view *view, FILE *out)
{
    double last = -INFINITY;
    fputs("\n\n# front\n", out);
    for (size_t left = view->count; left > 0; left--) {
        const struct figure_mark *next = NULL;
        for (size_t k = 0; k < view->count; k++) {
            const struct figure_mark *mark = &view->marks[k];
            if (mark->front && mark->x > last && (!next || mark->x < next->x))
                next = mark;
        }
        if (!next)
            break;
        last = next->x;
        write_mark(next, out);
    }
}

static void write_left_out(const struct study_results *results, const struct figure *figure,
                           FILE *out)
{
    for (size_t k = 0; k < results->points->count; k++) {
        const struct study_point *point = &results->points->items[k];
        char name[256];
        if (point->ladder != figure->ladder || point->outcome != OUTCOME_LEFT_OUT)
            continue;
        study_point_name(point, name, sizeof name);
        fprintf(out, "# left out: %s: %s\n", name, point->cause);
    }
}

enum status plot_data(const struct study_results *results, const struct figure *figure,
                      const struct figure_view *view, struct error *e)
{
    char path[4096], caption[512];
    struct output_file file;
    plot_path(results, figure, "dat", path, sizeof path);
    if (output_open(&file, path, e))
        return e->status;
    figure_caption(figure, caption, sizeof caption);
    fprintf(file.stream, "# %s\n# x y outcome point, and of seeds the least and most x; failures stand above the others, at no x or y of "
                         "their own; an error of 0 at the left\n", caption);
    write_left_out(results, figure, file.stream);
    write_methods(view, file.stream);
    write_front(view, file.stream);
    return output_close(&file, true, e);
}
