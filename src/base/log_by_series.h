/* The natural logarithm by a series of + - * /: portable_log, for GPUs too. In the common subset of C and CUDA. */
#ifndef BASE_LOG_BY_SERIES_H
#define BASE_LOG_BY_SERIES_H

#include <math.h>

/* x = m 2^e; ln m = 2 artanh((m - 1) / (m + 1)), m between sqrt(1/2) and sqrt(2). ln 2 is in two parts, the
 * first of which times e is exact. */
static inline double log_by_series(double x)
{
    int e;
    if (!(x > 0 && x < (double)INFINITY))
        return x > 0 ? x : (double)NAN;
    double m = frexp(x, &e);
    if (m < 0.70710678118654752) {
        m *= 2;
        e--;
    }
    double f = m - 1, s = f / (m + 1), q = s * s, sum = 0;
    for (int n = 23; n > 1; n -= 2)
        sum = q * (1.0 / n + sum);
    return e * 0x1.62e42fefa2p-1 + (2 * s + (2 * s * sum + e * 0x1.9ef35793c7673p-41));
}

#endif
