/* Norms of errors over pairs of measured and exact values. */
#ifndef STUDY_NORM_H
#define STUDY_NORM_H

#include "base/variant.h"

#include <stdbool.h>
#include <stddef.h>

struct norm_row {
    struct variant variant;
    /* Of the error of `count` values, at least 1. */
    double (*of)(const double *values, const double *exact, size_t count);
    bool has_sign; /* it changes in proportion to the values */
};

extern const struct variant_table norm_table; /* "norms" */

double norm_l1(const double *values, const double *exact, size_t count);  /* sum |e| / sum |x| */
double norm_l2(const double *values, const double *exact, size_t count);  /* sqrt(sum e^2 / sum x^2) */
double norm_max(const double *values, const double *exact, size_t count); /* max |e| / max |x| */

/* max (e, 0) / max |x|: how far values rise above the reference; what falls is no error */
double norm_rise(const double *values, const double *exact, size_t count);

/* sum e / sum |x|, with its sign: of an integral over time. */
double norm_mean(const double *values, const double *exact, size_t count);

/* e / x of the last value, with its sign; e where x is 0. */
double norm_final(const double *values, const double *exact, size_t count);

#endif
