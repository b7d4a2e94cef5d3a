/* Part of the summary of several studies: one table of their errors. */
#include "study/products/summary.h"
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

const struct study_point *summary_point(const struct study_results *results, const char *method)
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

static void write_cell(const struct study_point *point, const char *error, FILE *out)
{
    char text[64];
    if (!point || point->outcome == OUTCOME_LEFT_OUT) {
        fprintf(out, " %s |", text_none);
    } else if (point->outcome != OUTCOME_DONE) {
        fprintf(out, " %s |", outcome_names[point->outcome]);
    } else {
        const struct study_error *found = study_error(point, error);
        if (!found) {
            fprintf(out, " %s |", text_none);
            return;
        }
        bool over = study_error_amount(found) > found->asked;
        text_found(found, text, sizeof text);
        fprintf(out, " %s%s%s%s |", over ? "**" : "", found->value > 0 && text[0] != '+' ? "+" : "",
                text, over ? "**" : "");
    }
}

static void write_row(const struct study_results *results, const struct study_error *error,
                      size_t place, const struct columns_of_methods *columns, FILE *out)
{
    char asked[64];
    text_error(error->asked, error->unit, asked, sizeof asked);
    fputs("| ", out);
    text_markdown(place ? "" : results->study->title, out);
    fputs(" | ", out);
    text_markdown(error->name, out);
    fprintf(out, " | %s%s |", isnan(error->asked) ? "" : "< ", isnan(error->asked) ? "" : asked);
    for (size_t m = 0; m < columns->count; m++)
        write_cell(summary_point(results, columns->names[m]), error->name, out);
    fputc('\n', out);
}

/* Of the runs whose errors the table has; other programs hardly change it. */
static void write_times(const struct study_results *results,
                        const struct columns_of_methods *columns, FILE *out)
{
    fputs("| | processor time, s | |", out);
    for (size_t m = 0; m < columns->count; m++) {
        const struct study_point *point = summary_point(results, columns->names[m]);
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
        const struct study_point *point = summary_point(results, columns->names[m]);
        if (point && (!full || point->errors.count > full->errors.count))
            full = point;
    }
    for (size_t k = 0; full && k < full->errors.count; k++)
        write_row(results, &full->errors.items[k], k, columns, out);
    write_times(results, columns, out);
}

/* Whether a point of the method is on the front of the first ladder, time against the first error. */
static bool has_front(const struct study_results *results, const char *method)
{
    const char *error;
    bool front = false;
    size_t plots = study_plots(results, &error, 1);
    for (size_t k = 0; k < results->points->count && plots; k++) {
        const struct study_point *p = &results->points->items[k];
        front = front || (p->ladder == results->study->ladders && strcmp(p->method->name, method) == 0 &&
                          study_is_front(results->points, p, error, study_cpu));
    }
    return front;
}

/* "isph in 16 (alone in 7), wcsph in 4": in how many cases a method is on the front. */
static void write_fronts(const struct study_results *all, size_t count, const struct columns_of_methods *columns,
                         FILE *out)
{
    size_t cases = 0;
    for (size_t k = 0; k < count; k++)
        cases += summary_has_errors(&all[k]);
    fprintf(out, "On the front of processor time against the first error, of %zu cases:", cases);
    for (size_t m = 0; m < columns->count; m++) {
        size_t on = 0, alone = 0;
        for (size_t k = 0; k < count; k++) {
            bool front = summary_has_errors(&all[k]) && has_front(&all[k], columns->names[m]), others = false;
            for (size_t i = 0; i < columns->count && front; i++)
                others = others || (i != m && has_front(&all[k], columns->names[i]));
            on += front;
            alone += front && !others;
        }
        fprintf(out, "%s %s in %zu (alone in %zu)", m ? "," : "", columns->names[m], on, alone);
    }
    fputs(".\n\n", out);
}

void summary_errors(const struct study_results *all, size_t count, FILE *out)
{
    struct columns_of_methods columns = {.count = 0};
    for (size_t k = 0; k < count; k++)
        if (summary_has_errors(&all[k]))
            add_methods(&columns, all[k].study);
    if (!columns.count)
        return;
    fputs("| case | error of | asked |", out);
    for (size_t m = 0; m < columns.count; m++)
        fprintf(out, " %s |", columns.names[m]);
    fputs("\n|---|---|---|", out);
    for (size_t m = 0; m < columns.count; m++)
        fputs("---|", out);
    fputc('\n', out);
    for (size_t k = 0; k < count; k++)
        if (summary_has_errors(&all[k]))
            write_study(&all[k], &columns, out);
    fputc('\n', out);
    write_fronts(all, count, &columns, out);
}
