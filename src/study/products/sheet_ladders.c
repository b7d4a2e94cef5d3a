/* Parts of the report: each ladder's table of points, its figures and pictures. */
#include "study/products/sheet.h"
#include "study/products/text.h"

#include <math.h>
#include <string.h>

static void cell(struct sheet *sheet, double value)
{
    char text[64];
    text_number(value, text, sizeof text);
    sheet->format->cell(sheet, text, CELL_PLAIN);
}

/* NULL: the point has no such error. */
static void cell_error(struct sheet *sheet, const struct study_error *error)
{
    char text[64];
    if (error)
        text_found(error, text, sizeof text);
    sheet->format->cell(sheet, error ? text : text_none,
                        error && study_error_amount(error) > error->asked ? CELL_BOLD : CELL_PLAIN);
}

/* Least time of the method at the ladder's least value of threads, over this one's. */
static double speed_up(const struct study_results *results, const struct study_point *point)
{
    const struct study_point *first = NULL;
    for (size_t k = 0; k < results->points->count; k++) {
        const struct study_point *other = &results->points->items[k];
        if (other->ladder == point->ladder && other->method == point->method && other->repeats > 0 &&
            (!first || other->threads < first->threads))
            first = other;
    }
    return first ? study_wall(first) / study_wall(point) : (double)NAN;
}

static bool by_threads(const struct study_ladder *ladder)
{
    return strcmp(ladder->key, "threads") == 0;
}

/* Its time is not sure: every run of it waited for others, or only one of several did not. */
static bool is_noisy(const struct study_point *point)
{
    int calm = study_calm(point);
    return point->repeats > 0 && (calm == 0 || (calm == 1 && point->repeats > 1));
}

static void write_numbers(struct sheet *sheet, const struct study_point *p)
{
    char text[64];
    double nothing = (double)NAN, ran = p->repeats > 0 ? 1 : nothing;
    cell(sheet, p->repeats > 0 ? p->particles : p->guess);
    cell(sheet, p->dt * ran);
    cell(sheet, p->steps * ran);
    cell(sheet, p->rejected * ran);
    cell(sheet, p->iterations * ran);
    cell(sheet, study_wall(p));
    text_number(study_wall_median(p), text, sizeof text);
    strcat(text, is_noisy(p) ? " ~" : "");
    sheet->format->cell(sheet, text, CELL_PLAIN);
    cell(sheet, study_cpu(p));
    cell(sheet, study_pairs(p));
    if (by_threads(p->ladder))
        cell(sheet, speed_up(sheet->results, p));
}

static void write_point(struct sheet *sheet, const struct study_point *p,
                        const struct study_errors *errors, const char *const *plots, size_t plot_count)
{
    const struct study_points *points = sheet->results->points;
    char text[64];
    sheet->format->row(sheet, true);
    sheet->format->cell(sheet, p->method->name, CELL_PLAIN);
    text_value(p->ladder->labels[p->rung], text, sizeof text);
    sheet->format->cell(sheet, text, CELL_PLAIN);
    write_numbers(sheet, p);
    for (size_t k = 0; errors && k < errors->count; k++)
        cell_error(sheet, study_error(p, errors->items[k].name));
    for (size_t k = 0; k < plot_count; k++) {
        double order = study_order(points, p, plots[k]);
        snprintf(text, sizeof text, "%.2f", order);
        sheet->format->cell(sheet, isnan(order) ? text_none : text, CELL_PLAIN);
        sheet->format->cell(sheet, study_is_front(points, p, plots[k], study_wall) ? "●" : "",
                            CELL_PLAIN);
    }
    cell(sheet, p->repeats > 0 ? p->energy_drift : (double)NAN);
    cell(sheet, p->repeats > 0 ? p->momentum_drift : (double)NAN);
    sheet->format->cell(sheet, outcome_names[p->outcome], CELL_PLAIN); /* causes: sheet_verdicts.c */
    sheet->format->row(sheet, false);
}

static void write_heads(struct sheet *sheet, const struct study_ladder *ladder,
                        const struct study_errors *errors, const char *const *plots, size_t plot_count)
{
    static const char *const fixed[] = {"N", "mean step, s", "steps", "rejected", "iterations a step",
                                        "wall, s", "median, s", "processor, s", "pairs"};
    const char *heads[16 + 3 * ERRORS_MAX] = {"method", ladder->key[0] ? ladder->key : "rung"};
    char orders[ERRORS_MAX][160], fronts[ERRORS_MAX][160];
    size_t count = 2;
    for (size_t k = 0; k < sizeof fixed / sizeof *fixed; k++)
        heads[count++] = fixed[k];
    if (by_threads(ladder))
        heads[count++] = "speed-up";
    for (size_t k = 0; errors && k < errors->count; k++)
        heads[count++] = errors->items[k].name;
    for (size_t k = 0; k < plot_count; k++) {
        bool say = plot_count > 1;
        const char *name = say ? plots[k] : "";
        snprintf(orders[k], sizeof orders[k], "order%s%s", say ? " of " : "", name);
        snprintf(fronts[k], sizeof fronts[k], "front%s%s", say ? " of " : "", name);
        heads[count++] = orders[k];
        heads[count++] = fronts[k];
    }
    heads[count++] = "energy drift";
    heads[count++] = "momentum drift";
    heads[count++] = "outcome";
    sheet_heads(sheet, heads, count);
}

static void write_notes(struct sheet *sheet, const struct study_ladder *ladder)
{
    const struct study_points *points = sheet->results->points;
    size_t noisy = 0, left_out = 0, seeds = (size_t)sheet->results->study->seeds;
    for (size_t k = 0; k < points->count; k++) {
        const struct study_point *p = &points->items[k];
        noisy += p->ladder == ladder && is_noisy(p);
        left_out += p->ladder == ladder && p->repeats > 0 ? (size_t)(p->repeats - study_calm(p)) : 0;
    }
    sheet_paragraph(sheet, false, "Bold: more than asked. %sDrift: part of the largest energy, and of the "
                    "momentum of all mass at the mean speed of most kinetic energy.",
                    figure_is_time(sheet->results, ladder) ? ""
                    : "Front ●: no other point errs less in less time. Order: p of error ~ spacing^p from the "
                      "rung before. ");
    if (seeds > 1)
        sheet_paragraph(sheet, false, "Each point is %zu runs from different seeds of disorder: errors are their mean ± "
                        "standard deviation, compared by the mean of their sizes; bars in figures reach from the least to "
                        "the most; times are means. Steps, drifts and states are of the first.", seeds);
    if (left_out)
        sheet_paragraph(sheet, false, "%zu runs were disturbed, more than 10 %% longer than others of their point or than "
                        "their processor time; they are left out of the medians, and were made again as far as the "
                        "budget went.", left_out);
    if (noisy)
        sheet_paragraph(sheet, true, "~: the times of %zu points are not sure: at most one of their runs was not "
                        "disturbed.", noisy);
}

static void write_table(struct sheet *sheet, const struct study_ladder *ladder)
{
    const struct study_results *results = sheet->results;
    const char *plots[ERRORS_MAX];
    size_t plot_count = study_plots(results, plots, ERRORS_MAX);
    if (figure_is_time(results, ladder)) /* no orders and fronts */
        plot_count = 0;
    const struct study_errors *errors = study_most_errors(results->points, ladder);
    sheet->format->table(sheet, true);
    write_heads(sheet, ladder, errors, plots, plot_count);
    for (size_t m = 0; m < results->study->method_count; m++)
        for (size_t k = 0; k < results->points->count; k++) {
            const struct study_point *p = &results->points->items[k];
            if (p->ladder == ladder && p->method == &results->study->methods[m])
                write_point(sheet, p, errors, plots, plot_count);
        }
    sheet->format->table(sheet, false);
    write_notes(sheet, ladder);
}

enum status sheet_ladders(struct sheet *sheet, struct error *e)
{
    struct figure figures[FIGURES_MOST];
    size_t count = study_figures(sheet->results, figures);
    for (size_t l = 0; l < sheet->results->study->ladder_count; l++) {
        const struct study_ladder *ladder = &sheet->results->study->ladders[l];
        char text[STUDY_NAME_SIZE + 16];
        snprintf(text, sizeof text, "Ladder: %s", ladder->name);
        sheet->format->heading(sheet, 2, text);
        for (size_t k = 0; k < count; k++)
            if (figures[k].ladder == ladder && sheet->format->figure(sheet, &figures[k], e))
                return e->status;
        if (!figure_is_time(sheet->results, ladder))
            sheet_efforts(sheet, ladder);
        write_table(sheet, ladder);
        sheet_convergence(sheet, ladder);
        if (sheet->format->frames(sheet, ladder, e))
            return e->status;
    }
    return STATUS_OK;
}
