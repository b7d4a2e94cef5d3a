/* Observed orders of convergence, and which points are on the front of error against cost. */
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

double study_error_size(const struct study_point *point, size_t plot)
{
    return point->outcome == OUTCOME_DONE && point->ladder && plot < point->errors.count
               ? fabs(point->errors.items[plot].value) : (double)NAN;
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

double study_order(const struct study_points *points, const struct study_point *point, size_t plot)
{
    const struct study_point *before = point->ladder ? rung_before(points, point) : NULL;
    if (!before)
        return (double)NAN;
    double ratio = before->scene->particles.spacing / point->scene->particles.spacing;
    double fall = study_error_size(before, plot) / study_error_size(point, plot);
    return ratio > 1 && fall > 0 && isfinite(fall) ? log(fall) / log(ratio) : (double)NAN;
}

bool study_is_front(const struct study_points *points, const struct study_point *point, size_t plot,
                    double (*cost)(const struct study_point *))
{
    double error = study_error_size(point, plot), spent = cost(point);
    if (isnan(error) || isnan(spent))
        return false;
    for (size_t k = 0; k < points->count; k++) {
        const struct study_point *other = &points->items[k];
        double e = study_error_size(other, plot), c = cost(other);
        if (other->ladder == point->ladder && e <= error && c <= spent && (e < error || c < spent))
            return false;
    }
    return true;
}
