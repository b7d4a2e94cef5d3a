/* The table of norms. */
#include "study/reference/norm.h"

#include <math.h>

double norm_l1(const double *values, const double *exact, size_t count)
{
    double error = 0, size = 0;
    for (size_t k = 0; k < count; k++) {
        error += fabs(values[k] - exact[k]);
        size += fabs(exact[k]);
    }
    return error / size;
}

double norm_l2(const double *values, const double *exact, size_t count)
{
    double error = 0, size = 0;
    for (size_t k = 0; k < count; k++) {
        error += (values[k] - exact[k]) * (values[k] - exact[k]);
        size += exact[k] * exact[k];
    }
    return sqrt(error / size);
}

double norm_max(const double *values, const double *exact, size_t count)
{
    double error = 0, size = 0;
    for (size_t k = 0; k < count; k++) {
        error = fmax(error, fabs(values[k] - exact[k]));
        size = fmax(size, fabs(exact[k]));
    }
    return error / size;
}

double norm_rise(const double *values, const double *exact, size_t count)
{
    double error = 0, size = 0;
    for (size_t k = 0; k < count; k++) {
        if (isnan(values[k]))
            return values[k];
        error = fmax(error, values[k] - exact[k]);
        size = fmax(size, fabs(exact[k]));
    }
    return error / size;
}

double norm_mean(const double *values, const double *exact, size_t count)
{
    double error = 0, size = 0;
    for (size_t k = 0; k < count; k++) {
        error += values[k] - exact[k];
        size += fabs(exact[k]);
    }
    return error / size;
}

double norm_final(const double *values, const double *exact, size_t count)
{
    double error = values[count - 1] - exact[count - 1], size = fabs(exact[count - 1]);
    return size > 0 ? error / size : error;
}

static const struct norm_row l1 = {{"l1", "sum |error| / sum |reference|", NULL, 0, NULL}, norm_l1, false};
static const struct norm_row l2 = {{"l2", "sqrt(sum error^2 / sum reference^2)", NULL, 0, NULL},
                                   norm_l2, false};
static const struct norm_row most = {{"max", "largest |error| / largest |reference|", NULL, 0, NULL},
                                     norm_max, false};
static const struct norm_row rise = {
    {"rise", "largest (value - reference) / largest |reference|; values below it are no error", NULL, 0,
     NULL}, norm_rise, false};
static const struct norm_row final = {
    {"final", "error / |reference| at the end, with its sign; the error itself where that is 0", NULL,
     0, NULL}, norm_final, true};

static const struct norm_row mean = {
    {"mean", "sum error / sum |reference|, with its sign", NULL, 0, NULL}, norm_mean, true};

static const struct variant *const rows[] = {&l2.variant, &l1.variant, &most.variant,
                                             &rise.variant, &mean.variant, &final.variant};

const struct variant_table norm_table = {
    "norms", "norms of errors in time, of studies", rows, sizeof rows / sizeof *rows};
