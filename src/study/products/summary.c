/* Writes one table of the errors of several studies. */
#include "study/products/summary.h"

#include "base/output.h"
#include "study/products/text.h"

#include <math.h>
#include <string.h>

enum { METHODS_MAX = 32 };

struct columns_of_methods {
    const char *names[METHODS_MAX];
    size_t count;
};

static void add_methods(struct columns_of_methods *columns, const struct study *study)
{
    for (size_t m = 0; m < study->method_count; m++) {
        size_t k = 0;
        while (k < columns->count && strcmp(columns->names[k], study->methods[m].name) != 0)
            k++;
        if (k == columns->count && k < METHODS_MAX)
            columns->names[columns->count++] = study->methods[m].name;
    }
}

/* The point of the method that stands for the scene: in the first ladder the rung as shipped, else the
 * last; NULL when the study does not have the method. */
static const struct study_point *point_of(const struct study_results *results, const char *method)
{
    const struct study_point *last = NULL;
    for (size_t k = 0; k < results->points->count; k++) {
        const struct study_point *point = &results->points->items[k];
        if (point->ladder != results->study->ladders || strcmp(point->method->name, method) != 0)
            continue;
        if (point->shipped)
            return point;
        last = point;
    }
    return last;
}

static void write_cell(const struct study_point *point, size_t error, FILE *out)
{
    char text[64];
    if (!point || point->outcome == OUTCOME_LEFT_OUT) {
        fprintf(out, " %s |", text_none);
    } else if (point->outcome != OUTCOME_DONE || error >= point->errors.count) {
        fprintf(out, " %s |", outcome_names[point->outcome]);
    } else {
        const struct study_error *found = &point->errors.items[error];
        bool over = fabs(found->value) > found->asked;
        text_error(found->value, found->unit, text, sizeof text);
        fprintf(out, " %s%s%s%s |", over ? "**" : "", found->value > 0 && text[0] != '+' ? "+" : "",
                text, over ? "**" : "");
    }
}

static void write_row(const struct study_results *results, const struct study_error *error,
                      size_t place, const struct columns_of_methods *columns, FILE *out)
{
    char asked[64];
    text_error(error->asked, error->unit, asked, sizeof asked);
    fprintf(out, "| %s | %s | %s%s |", place ? "" : results->study->title, error->name,
            isnan(error->asked) ? "" : "< ", isnan(error->asked) ? "" : asked);
    for (size_t m = 0; m < columns->count; m++)
        write_cell(point_of(results, columns->names[m]), place, out);
    fputc('\n', out);
}

/* Of the runs whose errors the table has; other programs hardly change it. */
static void write_times(const struct study_results *results,
                        const struct columns_of_methods *columns, FILE *out)
{
    fputs("| | processor time, s | |", out);
    for (size_t m = 0; m < columns->count; m++) {
        const struct study_point *point = point_of(results, columns->names[m]);
        char text[64];
        text_number(point ? study_cpu(point) : (double)NAN, text, sizeof text);
        fprintf(out, " %s |", text);
    }
    fputc('\n', out);
}

static void write_study(const struct study_results *results,
                        const struct columns_of_methods *columns, FILE *out)
{
    const struct study_point *full = NULL;
    for (size_t m = 0; m < columns->count; m++) {
        const struct study_point *point = point_of(results, columns->names[m]);
        if (point && (!full || point->errors.count > full->errors.count))
            full = point;
    }
    for (size_t k = 0; full && k < full->errors.count; k++)
        write_row(results, &full->errors.items[k], k, columns, out);
    write_times(results, columns, out);
}

enum status study_summary(const struct study_results *all, size_t count, const char *directory,
                          struct error *e)
{
    char path[4096];
    struct output_file file;
    struct columns_of_methods columns = {.count = 0};
    snprintf(path, sizeof path, "%s/summary.md", directory);
    if (output_open(&file, path, e))
        return e->status;
    for (size_t k = 0; k < count; k++)
        add_methods(&columns, all[k].study);
    fputs("| case | error of | asked |", file.stream);
    for (size_t m = 0; m < columns.count; m++)
        fprintf(file.stream, " %s |", columns.names[m]);
    fputs("\n|---|---|---|", file.stream);
    for (size_t m = 0; m < columns.count; m++)
        fputs("---|", file.stream);
    fputc('\n', file.stream);
    for (size_t k = 0; k < count; k++)
        write_study(&all[k], &columns, file.stream);
    return output_close(&file, true, e);
}
