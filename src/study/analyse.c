/* Observed orders of convergence, and which points are on the front of error against cost. */
#include "study/study.h"

#include <math.h>
#include <string.h>

const struct study_error *study_error(const struct study_point *point, const char *name)
{
    for (size_t k = 0; name && k < point->errors.count; k++)
        if (strcmp(point->errors.items[k].name, name) == 0)
            return &point->errors.items[k];
    return NULL;
}

const struct study_error *study_error_known(const struct study_points *points, const char *name)
{
    const struct study_error *error = NULL;
    for (size_t k = 0; k < points->count && !error; k++)
        error = study_error(&points->items[k], name);
    return error;
}

const struct study_errors *study_most_errors(const struct study_points *points,
                                             const struct study_ladder *ladder)
{
    const struct study_errors *most = NULL;
    for (size_t k = 0; k < points->count; k++) {
        const struct study_point *point = &points->items[k];
        if ((!ladder || point->ladder == ladder) && point->errors.count > (most ? most->count : 0))
            most = &point->errors;
    }
    return most;
}

double study_error_size(const struct study_point *point, const char *error)
{
    const struct study_error *found = study_error(point, error);
    return point->outcome == OUTCOME_DONE && point->ladder && found ? study_error_amount(found) : (double)NAN;
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

double study_order(const struct study_points *points, const struct study_point *point,
                   const char *error)
{
    const struct study_point *before = point->ladder ? rung_before(points, point) : NULL;
    if (!before)
        return (double)NAN;
    double ratio = before->scene->particles.spacing / point->scene->particles.spacing;
    double fall = study_error_size(before, error) / study_error_size(point, error);
    return ratio > 1 && fall > 0 && isfinite(fall) ? log(fall) / log(ratio) : (double)NAN;
}

bool study_is_front(const struct study_points *points, const struct study_point *point,
                    const char *name, double (*cost)(const struct study_point *))
{
    double error = study_error_size(point, name), spent = cost(point);
    if (isnan(error) || isnan(spent))
        return false;
    for (size_t k = 0; k < points->count; k++) {
        const struct study_point *other = &points->items[k];
        double e = study_error_size(other, name), c = cost(other);
        if (other->ladder == point->ladder && e <= error && c <= spent && (e < error || c < spent))
            return false;
    }
    return true;
}
