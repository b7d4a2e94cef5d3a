/* Observed orders of convergence, and which points are on the front of error against time. */
#include "study/study.h"

#include <math.h>
#include <string.h>

long study_error_place(const struct study_points *points, const char *name)
{
    for (size_t k = 0; k < points->count; k++)
        for (size_t i = 0; i < points->items[k].errors.count; i++)
            if (strcmp(points->items[k].errors.items[i].name, name) == 0)
                return (long)i;
    return -1;
}

/* |error|, or NAN when the point has none. */
static double size_of(const struct study_point *point, size_t plot)
{
    return point->outcome == OUTCOME_DONE && point->ladder && plot < point->errors.count
               ? fabs(point->errors.items[plot].value) : (double)NAN;
}

/* p of error ~ d^p between two rungs; NAN where the spacing does not change. */
static double order_between(const struct study_point *coarse, const struct study_point *fine,
                            size_t plot)
{
    double ratio = coarse->scene->particles.spacing / fine->scene->particles.spacing;
    double fall = size_of(coarse, plot) / size_of(fine, plot);
    return ratio > 1 && fall > 0 && isfinite(fall) ? log(fall) / log(ratio) : (double)NAN;
}

static const struct study_point *rung_before(const struct study_points *points,
                                             const struct study_point *point)
{
    for (size_t k = 0; k < points->count; k++) {
        const struct study_point *other = &points->items[k];
        if (other->ladder == point->ladder && other->method == point->method &&
            other->rung + 1 == point->rung)
            return other;
    }
    return NULL;
}

/* Less in both, or less in one and equal in the other. */
static bool beats(const struct study_point *a, const struct study_point *b, size_t plot)
{
    double ea = size_of(a, plot), eb = size_of(b, plot), ta = study_wall(a), tb = study_wall(b);
    return a->ladder == b->ladder && ea <= eb && ta <= tb && (ea < eb || ta < tb);
}

void study_analyse(struct study_points *points, size_t plot)
{
    for (size_t k = 0; k < points->count; k++) {
        struct study_point *point = &points->items[k];
        const struct study_point *before = point->rung > 0 ? rung_before(points, point) : NULL;
        point->order = before ? order_between(before, point, plot) : (double)NAN;
        point->front = !isnan(size_of(point, plot));
        for (size_t i = 0; i < points->count && point->front; i++)
            point->front = !beats(&points->items[i], point, plot);
    }
}
