/* Where the marks of a figure are, and what its axes show. */
#include "base/memory.h"
#include "study/products/figure.h"
#include "study/products/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Lines and limits are shown when they are not further than this factor from the data. */
#define NEAR 30.0

/* The part of the height that is below failures. */
#define BELOW_FAILURES 0.88

static void include(struct figure_axis *axis, double value)
{
    if (!(value > 0) || isinf(value))
        return;
    axis->from = isnan(axis->from) ? value : fmin(axis->from, value);
    axis->to = isnan(axis->to) ? value : fmax(axis->to, value);
}

static void include_near(struct figure_axis *axis, double value)
{
    if (value > axis->from / NEAR && value < axis->to * NEAR)
        include(axis, value);
}

/* Room around the data; `zero`: and for errors of 0, at its left. */
static void widen(struct figure_axis *axis, bool zero)
{
    if (isnan(axis->from))
        axis->from = axis->to = 1;
    double pad = fmax(pow(axis->to / axis->from, 0.1), 1.6);
    if (zero) {
        axis->zero = axis->from / pad / pad;
        axis->from = axis->zero;
    }
    axis->from /= pad;
    axis->to *= pad;
}

double figure_part(const struct figure_axis *axis, double value)
{
    return axis->rungs ? (value - axis->from) / (axis->to - axis->from)
                       : log(value / axis->from) / log(axis->to / axis->from);
}

static double at_part(const struct figure_axis *axis, double part)
{
    return axis->rungs ? axis->from + part * (axis->to - axis->from)
                       : axis->from * pow(axis->to / axis->from, part);
}

/* The ladder's values are numbers for a logarithmic axis. */
static bool values_are_numbers(const struct study_ladder *ladder)
{
    for (size_t k = 0; k < ladder->count; k++) {
        char *end;
        double value = strtod(ladder->labels[k], &end);
        if (end == ladder->labels[k] || *end || !(value > 0) || isinf(value))
            return false;
    }
    return true;
}

static double x_of(const struct figure *figure, const struct figure_view *view,
                   const struct study_point *point)
{
    if (figure->kind != FIGURE_VALUE)
        return study_error_size(point, figure->error) *
               (figure->of ? text_scale(figure->of->unit) : 1);
    return view->x.rungs ? (double)point->rung + 1 : strtod(figure->ladder->labels[point->rung], NULL);
}

static bool has_failed(const struct study_point *point)
{
    return point->outcome == OUTCOME_STOPPED || point->outcome == OUTCOME_LATE ||
           point->outcome == OUTCOME_CRASHED;
}

/* From the least to the most error of its seeds. */
static void set_bar(const struct figure *figure, struct figure_mark *mark)
{
    const struct study_error *error = study_error(mark->point, figure->error);
    if (mark->failed || figure->kind == FIGURE_VALUE || !error || error->runs < 2)
        return;
    mark->low = error->least * text_scale(error->unit);
    mark->high = error->most * text_scale(error->unit);
}

static void collect(const struct study_results *results, const struct figure *figure,
                    struct figure_view *view)
{
    const struct study *study = results->study;
    for (size_t m = 0; m < study->method_count; m++)
        for (size_t k = 0; k < results->points->count; k++) {
            const struct study_point *p = &results->points->items[k];
            double (*cost)(const struct study_point *) = figure_cost(figure);
            struct figure_mark mark = {.point = p, .x = x_of(figure, view, p), .y = cost(p),
                                       .failed = has_failed(p), .low = (double)NAN, .high = (double)NAN};
            set_bar(figure, &mark);
            if (p->ladder != figure->ladder || p->method != &study->methods[m] ||
                (!mark.failed && (p->outcome != OUTCOME_DONE || isnan(mark.x) || !(mark.y > 0))))
                continue;
            mark.front = figure->kind != FIGURE_VALUE && !mark.failed &&
                         study_is_front(results->points, p, figure->error, cost);
            view->marks[view->count++] = mark;
            view->failures = view->failures || mark.failed;
        }
}

static void set_axes(const struct study_results *results, const struct figure *figure,
                     struct figure_view *view)
{
    bool zero = false, errors = figure->kind != FIGURE_VALUE;
    for (size_t k = 0; k < view->count; k++) {
        const struct figure_mark *mark = &view->marks[k];
        if (!mark->failed || !errors)
            include(&view->x, mark->x);
        include(&view->x, mark->low);
        include(&view->x, mark->high);
        if (!mark->failed)
            include(&view->y, mark->y);
        zero = zero || (!mark->failed && mark->x == 0);
    }
    for (size_t o = 0; o < figure->ladder->other_count && !errors; o++)
        for (size_t k = 0; k < figure->ladder->count; k++)
            include(&view->y, figure->ladder->others[o].seconds[k]);
    if (errors && figure->of) {
        double scale = text_scale(figure->of->unit);
        include_near(&view->x, figure->of->asked * scale);
        include_near(&view->x, figure->of->spread * scale);
        include_near(&view->x, results->study->floor * scale);
    }
    if (view->x.rungs) {
        view->x.from = 0.5;
        view->x.to = (double)figure->ladder->count + 0.5;
    } else {
        widen(&view->x, zero);
    }
    widen(&view->y, false);
    if (view->failures)
        view->y.to = view->y.from * pow(view->y.to / view->y.from, 1 / BELOW_FAILURES);
}

/* Failures have no error: they stand side by side. */
static void place_odd_marks(const struct figure *figure, struct figure_view *view)
{
    size_t failures = 0, next = 0;
    for (size_t k = 0; k < view->count; k++)
        failures += view->marks[k].failed;
    for (size_t k = 0; k < view->count; k++) {
        struct figure_mark *mark = &view->marks[k];
        if (mark->failed) {
            mark->y = at_part(&view->y, (1 + BELOW_FAILURES) / 2);
            if (figure->kind != FIGURE_VALUE)
                mark->x = at_part(&view->x, (double)++next / (double)(failures + 1));
        } else if (mark->x == 0) {
            mark->x = view->x.zero;
        }
    }
}

enum status figure_view(const struct study_results *results, const struct figure *figure,
                        struct figure_view *view, struct error *e)
{
    static const struct figure_axis unknown = {(double)NAN, (double)NAN, (double)NAN, false};
    *view = (struct figure_view){.x = unknown, .y = unknown};
    view->x.rungs = figure->kind == FIGURE_VALUE && !values_are_numbers(figure->ladder);
    view->marks = memory_create("study figure", results->points->count, sizeof *view->marks, e);
    if (!view->marks)
        return e->status;
    collect(results, figure, view);
    set_axes(results, figure, view);
    place_odd_marks(figure, view);
    return STATUS_OK;
}

void figure_view_free(struct figure_view *view)
{
    memory_free(view->marks);
    *view = (struct figure_view){0};
}
