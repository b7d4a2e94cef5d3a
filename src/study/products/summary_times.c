/* Part of the summary of several studies: tables of times, beside those of other programs. */
#include "study/products/summary.h"

#include "study/products/figure.h"
#include "study/products/text.h"

#include <math.h>

static const struct study_point *find(const struct study_results *results,
                                      const struct study_ladder *ladder,
                                      const struct study_method *method, size_t rung)
{
    for (size_t k = 0; k < results->points->count; k++) {
        const struct study_point *p = &results->points->items[k];
        if (p->ladder == ladder && p->method == method && p->rung == rung)
            return p;
    }
    return NULL;
}

/* "~": the machine was busy. */
static void write_seconds(double seconds, bool calm, FILE *out)
{
    char text[64];
    if (isnan(seconds))
        snprintf(text, sizeof text, "%s", text_none);
    else
        snprintf(text, sizeof text, seconds < 100 ? "%.3g" : "%.0f", seconds);
    fprintf(out, " %s%s |", text, calm || isnan(seconds) ? "" : " ~");
}

static void write_head(const struct study_results *results, const struct study_ladder *ladder, FILE *out)
{
    text_markdown(results->study->title, out);
    if (results->study->ladder_count > 1)
        fprintf(out, ", ladder %s", ladder->name);
    fputs(": wall time, s", out);
    if (ladder->steps > 0)
        fprintf(out, ", for %.0f steps, in proportion from those of the run", ladder->steps);
    fprintf(out, ".\n\n| %s |", figure_key(ladder));
    for (size_t k = 0; k < ladder->count; k++) {
        char text[32];
        text_value(ladder->labels[k], text, sizeof text);
        fprintf(out, " %s |", text);
    }
    fputs("\n|---|", out);
    for (size_t k = 0; k < ladder->count; k++)
        fputs("---|", out);
    fputs("\n| particles |", out);
    for (size_t k = 0; k < ladder->count; k++) {
        const struct study_point *p = find(results, ladder, &results->study->methods[0], k);
        fprintf(out, " %.0f |", p->repeats > 0 ? p->particles : p->guess);
    }
    fputc('\n', out);
}

static void write_method(const struct study_results *results, const struct study_ladder *ladder,
                         const struct study_method *method, FILE *out)
{
    fprintf(out, "| %s |", method->name);
    for (size_t k = 0; k < ladder->count; k++) {
        const struct study_point *p = find(results, ladder, method, k);
        if (p->outcome == OUTCOME_DONE || p->outcome == OUTCOME_LEFT_OUT)
            write_seconds(figure_wall_of_steps(p), study_calm(p) > 0, out);
        else
            fprintf(out, " %s |", outcome_names[p->outcome]);
    }
    fputc('\n', out);
}

static void write_ladder(const struct study_results *results, const struct study_ladder *ladder, FILE *out)
{
    write_head(results, ladder, out);
    for (size_t m = 0; m < results->study->method_count; m++)
        write_method(results, ladder, &results->study->methods[m], out);
    for (size_t o = 0; o < ladder->other_count; o++) {
        fprintf(out, "| *%s* |", ladder->others[o].name);
        for (size_t k = 0; k < ladder->count; k++)
            write_seconds(ladder->others[o].seconds[k], true, out);
        fputc('\n', out);
    }
    fputc('\n', out);
}

void summary_times(const struct study_results *results, FILE *out)
{
    for (size_t l = 0; l < results->study->ladder_count; l++)
        if (!summary_has_settings(results) &&
            (figure_is_time(results, &results->study->ladders[l]) || !summary_has_errors(results)))
            write_ladder(results, &results->study->ladders[l], out);
}
