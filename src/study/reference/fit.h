/* Fits of measured series: least squares, oscillations, crossings, means at the end. Times rise. */
#ifndef STUDY_FIT_H
#define STUDY_FIT_H

#include <stdbool.h>
#include <stddef.h>

enum { FIT_BASES_MAX = 8 };

/* Functions whose sum with some factors is fitted. */
struct fit_bases {
    size_t count;             /* at most FIT_BASES_MAX */
    void (*of)(double x, const double *parameters, double *values); /* of all functions at x */
    const double *parameters;
};

/* Factors of least squares; returns the sum of squares left. NAN where functions depend on each
 * other. */
double fit_least_squares(const struct fit_bases *bases, const double *xs, const double *ys,
                         size_t count, double *factors);

/* b of y = a + b x by least squares. */
double fit_slope(const double *xs, const double *ys, size_t count);

/* amplitude e^(-damping t) cos(frequency t + phase) */
struct fit_wave {
    double frequency, damping; /* rad/s, 1/s */
    double amplitude;          /* at time 0 */
};

/* The wave in values that also drift as a parabola of time, by least squares; from a guess of the
 * frequency within 10 % and of the damping. */
struct fit_wave fit_damped_wave(const double *times, const double *values, size_t count,
                                double frequency, double damping);

/* Times, later than `after`, at which values pass through zero, interpolated; writes at most `most` and
 * gives their number. */
size_t fit_sign_changes(const double *times, const double *values, size_t count, double after,
                        double *out, size_t most);

/* Largest |value| from one time to another. */
double fit_peak(const double *times, const double *values, size_t count, double from, double to);

/* An oscillation about zero by its sign changes. */
struct fit_oscillation {
    double half;        /* mean half period, s */
    double first, last; /* largest |value| before the first change, and before the last */
    size_t halves;      /* half periods from the one to the other */
};

/* By changes later than `after`; false when there are fewer than three. */
bool fit_oscillation(const double *times, const double *values, size_t count, double after,
                     struct fit_oscillation *fit);

/* When a series that rises first reaches the level, interpolated; NAN when it never does. */
double fit_crossing(const double *times, const double *values, size_t count, double level);

/* The first row of the last 25 % of the time, and the mean from it on. */
size_t fit_late(const double *times, size_t count);
double fit_late_mean(const double *times, const double *values, size_t count);

#endif
