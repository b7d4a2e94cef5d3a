/* Which figures a study has. */
#include "study/products/figure.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

const struct study_error *figure_error(const struct study_points *points,
                                       const struct study_ladder *ladder, const char *name)
{
    const struct study_error *error = NULL;
    for (size_t k = 0; k < points->count && !error; k++)
        if (points->items[k].ladder == ladder)
            error = study_error(&points->items[k], name);
    return error;
}

/* Whether a plotted error of some method is not the same at all rungs. */
static bool errors_differ(const struct study_results *results, const struct study_ladder *ladder)
{
    const char *names[ERRORS_MAX];
    size_t count = study_plots(results, names, ERRORS_MAX);
    const struct study_points *points = results->points;
    for (size_t i = 0; i < points->count; i++)
        for (size_t j = 0; j < i; j++) {
            const struct study_point *a = &points->items[i], *b = &points->items[j];
            bool same_curve = a->ladder == ladder && b->ladder == ladder && a->method == b->method;
            for (size_t k = 0; k < count && same_curve; k++) {
                double ea = study_error_size(a, names[k]), eb = study_error_size(b, names[k]);
                if (!isnan(ea) && !isnan(eb) && ea != eb)
                    return true;
            }
        }
    return false;
}

bool figure_is_time(const struct study_results *results, const struct study_ladder *ladder)
{
    if (ladder->figure != LADDER_BY_RULE)
        return ladder->figure == LADDER_TIME;
    if (strcmp(ladder->key, "threads") == 0 || strcmp(ladder->key, "isa") == 0)
        return true;
    return ladder->count > 1 && !errors_differ(results, ladder);
}

/* Appends "-TEXT" of letters and digits. */
static void append_plain(char *out, size_t size, const char *text)
{
    size_t length = strlen(out), most = length + 60 < size ? length + 60 : size;
    if (length && length + 1 < most)
        out[length++] = '-';
    for (; *text && length + 1 < most; text++) {
        bool plain = isalnum((unsigned char)*text) || *text == '.';
        if (plain || (length && out[length - 1] != '-'))
            out[length++] = plain ? *text : '-';
    }
    while (length && (out[length - 1] == '-' || out[length - 1] == '.'))
        length--;
    out[length] = 0;
}

static void add(struct figure *figures, size_t *count, struct figure figure)
{
    static const char *const endings[] = {"time", "pairs", "time"};
    if (*count == FIGURES_MOST)
        return;
    snprintf(figure.stem, sizeof figure.stem, "%zu", *count + 1);
    append_plain(figure.stem, sizeof figure.stem, figure.ladder->name);
    if (figure.of && figure.kind != FIGURE_VALUE)
        append_plain(figure.stem, sizeof figure.stem, figure.of->name);
    append_plain(figure.stem, sizeof figure.stem, endings[figure.kind]);
    figures[(*count)++] = figure;
}

static bool has_pairs(const struct study_points *points, const struct study_ladder *ladder,
                      const char *error)
{
    for (size_t k = 0; k < points->count; k++)
        if (points->items[k].ladder == ladder && !isnan(study_pairs(&points->items[k])) &&
            !isnan(study_error_size(&points->items[k], error)))
            return true;
    return false;
}

size_t study_figures(const struct study_results *results, struct figure *figures)
{
    const char *names[ERRORS_MAX];
    size_t plots = study_plots(results, names, ERRORS_MAX), count = 0;
    const char *first = plots ? names[0] : NULL;
    for (size_t l = 0; l < results->study->ladder_count; l++) {
        const struct study_ladder *ladder = &results->study->ladders[l];
        if (figure_is_time(results, ladder)) {
            add(figures, &count, (struct figure){ladder, FIGURE_VALUE, first,
                                                 figure_error(results->points, ladder, first), ""});
            continue;
        }
        for (size_t k = 0; k < plots; k++) {
            const struct study_error *of = figure_error(results->points, ladder, names[k]);
            add(figures, &count, (struct figure){ladder, FIGURE_TIME, names[k], of, ""});
            if (has_pairs(results->points, ladder, names[k]))
                add(figures, &count, (struct figure){ladder, FIGURE_PAIRS, names[k], of, ""});
        }
    }
    return count;
}

const char *figure_key(const struct study_ladder *ladder)
{
    return ladder->key[0] && strcmp(ladder->key, "title") != 0 ? ladder->key : ladder->name;
}

void figure_caption(const struct figure *figure, char *out, size_t size)
{
    static const char *const costs[] = {"wall time", "evaluated pairs", "wall time"};
    const char *against = figure->kind == FIGURE_VALUE ? figure_key(figure->ladder)
                          : figure->of                 ? figure->of->name : "the error";
    snprintf(out, size, "Ladder %s: %s against %s", figure->ladder->name, costs[figure->kind],
             against);
}

double figure_wall_of_steps(const struct study_point *point)
{
    double steps = point->ladder ? point->ladder->steps : (double)NAN;
    return study_wall(point) * (steps > 0 ? steps / point->steps : 1);
}

double (*figure_cost(const struct figure *figure))(const struct study_point *)
{
    return figure->kind == FIGURE_PAIRS ? study_pairs
           : figure->kind == FIGURE_VALUE ? figure_wall_of_steps : study_wall;
}
