/* What a method needs for an error, and errs after a time, between the rungs that were run. */
#include "study/crossing.h"

#include "study/products/text.h"

#include <math.h>
#include <stdio.h>

enum { CURVE_MOST = 256 };

/* Leaves those that err less than every faster one. */
static size_t falling(double *times, double *errors, size_t count)
{
    size_t kept = 0;
    for (size_t k = 0; k < count; k++)
        if (kept == 0 || errors[k] < errors[kept - 1]) {
            times[kept] = times[k];
            errors[kept++] = errors[k];
        }
    return kept;
}

/* A method's own front by rising time, that noise and errors of both signs do not lead astray; gives
 * the number of its points. */
static size_t front_of(const struct curve *curve, double *times, double *errors)
{
    size_t count = 0;
    for (size_t k = 0; k < curve->points->count && count < CURVE_MOST; k++) {
        const struct study_point *p = &curve->points->items[k];
        double t = study_wall(p), error = study_error_size(p, curve->error);
        if (p->ladder != curve->ladder || p->method != curve->method || isnan(error) || !(t > 0))
            continue;
        size_t i = count++;
        for (; i > 0 && times[i - 1] > t; i--) {
            times[i] = times[i - 1];
            errors[i] = errors[i - 1];
        }
        times[i] = t;
        errors[i] = error;
    }
    return falling(times, errors, count);
}

/* y at x on the line through the logarithms of two points, x from x0 to x1. */
static double between(double x, double x0, double y0, double x1, double y1)
{
    double part = x0 == x1 ? 1 : log(x / x0) / log(x1 / x0);
    return y0 * pow(y1 / y0, part);
}

struct crossing crossing_time(const struct curve *curve, double error)
{
    double times[CURVE_MOST], errors[CURVE_MOST], least = INFINITY;
    size_t count = front_of(curve, times, errors);
    for (size_t k = 0; k < count; k++) {
        least = fmin(least, errors[k]);
        if (errors[k] > error)
            continue;
        if (k == 0 || errors[k] == 0) /* zero has no logarithm */
            return (struct crossing){errors[k] == error ? CROSSING_AT : CROSSING_BELOW, times[k]};
        return (struct crossing){CROSSING_AT, between(error, errors[k - 1], times[k - 1], errors[k],
                                                      times[k])};
    }
    return (struct crossing){count ? CROSSING_NEVER : CROSSING_NONE, least};
}

struct crossing crossing_error(const struct curve *curve, double seconds)
{
    double times[CURVE_MOST], errors[CURVE_MOST];
    size_t count = front_of(curve, times, errors), k = 0;
    if (!count)
        return (struct crossing){CROSSING_NONE, (double)NAN};
    while (k < count && times[k] < seconds)
        k++;
    if (k == count)
        return (struct crossing){CROSSING_BELOW, errors[count - 1]};
    if (times[k] == seconds)
        return (struct crossing){CROSSING_AT, errors[k]};
    if (k == 0)
        return (struct crossing){CROSSING_ABOVE, errors[0]};
    if (errors[k - 1] > 0 && errors[k] > 0)
        return (struct crossing){CROSSING_AT, between(seconds, times[k - 1], errors[k - 1], times[k],
                                                      errors[k])};
    return (struct crossing){CROSSING_BELOW, fmax(errors[k - 1], errors[k])};
}

static const char *sign_of(const struct crossing *crossing)
{
    return crossing->kind == CROSSING_BELOW ? "< " : crossing->kind == CROSSING_ABOVE ? "> " : "";
}

void crossing_time_text(const struct crossing *crossing, const char *unit, char *out, size_t size)
{
    char error[64];
    text_error(crossing->value, unit, error, sizeof error);
    if (crossing->kind == CROSSING_NONE)
        snprintf(out, size, "%s", text_none);
    else if (crossing->kind == CROSSING_NEVER)
        snprintf(out, size, "not reached, least %s", error);
    else
        snprintf(out, size, "%s%.3g s", sign_of(crossing), crossing->value);
}

void crossing_error_text(const struct crossing *crossing, const char *unit, char *out, size_t size)
{
    char error[64];
    text_error(crossing->value, unit, error, sizeof error);
    if (crossing->kind == CROSSING_NONE)
        snprintf(out, size, "%s", text_none);
    else
        snprintf(out, size, "%s%s", sign_of(crossing), error);
}
