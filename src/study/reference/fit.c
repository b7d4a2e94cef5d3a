/* Fits of measured series. */
#include "study/reference/fit.h"

#include <math.h>

enum { SIZE = FIT_BASES_MAX, CHANGES_MAX = 1000 };

static void swap_rows(double matrix[SIZE][SIZE], double *right, size_t n, size_t i, size_t j)
{
    for (size_t k = 0; k < n; k++) {
        double kept = matrix[i][k];
        matrix[i][k] = matrix[j][k];
        matrix[j][k] = kept;
    }
    double kept = right[i];
    right[i] = right[j];
    right[j] = kept;
}

/* Gaussian elimination with row exchanges; the solution takes the place of the right side. */
static void solve(double matrix[SIZE][SIZE], double *right, size_t n)
{
    for (size_t k = 0; k < n; k++) {
        size_t pivot = k;
        for (size_t row = k + 1; row < n; row++)
            if (fabs(matrix[row][k]) > fabs(matrix[pivot][k]))
                pivot = row;
        swap_rows(matrix, right, n, k, pivot);
        for (size_t row = k + 1; row < n; row++) {
            double part = matrix[row][k] / matrix[k][k];
            right[row] -= part * right[k];
            for (size_t column = k; column < n; column++)
                matrix[row][column] -= part * matrix[k][column];
        }
    }
    for (size_t k = n; k-- > 0;) {
        for (size_t column = k + 1; column < n; column++)
            right[k] -= matrix[k][column] * right[column];
        right[k] /= matrix[k][k];
    }
}

double fit_least_squares(const struct fit_bases *bases, const double *xs, const double *ys,
                         size_t count, double *factors)
{
    double matrix[SIZE][SIZE] = {{0}}, values[SIZE], left = 0;
    size_t n = bases->count;
    for (size_t i = 0; i < n; i++)
        factors[i] = 0;
    for (size_t row = 0; row < count; row++) {
        bases->of(xs[row], bases->parameters, values);
        for (size_t i = 0; i < n; i++) {
            factors[i] += values[i] * ys[row];
            for (size_t j = 0; j < n; j++)
                matrix[i][j] += values[i] * values[j];
        }
    }
    solve(matrix, factors, n);
    for (size_t row = 0; row < count; row++) {
        double error = ys[row];
        bases->of(xs[row], bases->parameters, values);
        for (size_t i = 0; i < n; i++)
            error -= factors[i] * values[i];
        left += error * error;
    }
    return left;
}

static double mean(const double *values, size_t count)
{
    double sum = 0;
    for (size_t k = 0; k < count; k++)
        sum += values[k];
    return sum / (double)count;
}

double fit_slope(const double *xs, const double *ys, size_t count)
{
    double x = mean(xs, count), y = mean(ys, count), product = 0, square = 0;
    for (size_t k = 0; k < count; k++) {
        product += (xs[k] - x) * (ys[k] - y);
        square += (xs[k] - x) * (xs[k] - x);
    }
    return product / square;
}

/* A wave and a parabola; parameters: frequency, damping, the last time. */
static void wave_bases(double t, const double *parameters, double *values)
{
    double decay = exp(-parameters[1] * t), part = t / parameters[2];
    values[0] = decay * cos(parameters[0] * t);
    values[1] = decay * sin(parameters[0] * t);
    values[2] = 1;
    values[3] = part;
    values[4] = part * part;
}

/* The best wave of that frequency and damping; returns the sum of squares left. */
static double wave_left(const double *times, const double *values, size_t count,
                        struct fit_wave *wave)
{
    double parameters[3] = {wave->frequency, wave->damping, times[count - 1]}, factors[5];
    struct fit_bases bases = {5, wave_bases, parameters};
    double left = fit_least_squares(&bases, times, values, count, factors);
    wave->amplitude = hypot(factors[0], factors[1]);
    return left;
}

/* Goes to the best of the eight neighbours in the plane of frequency and damping; where none is better,
 * to half the distance. */
struct fit_wave fit_damped_wave(const double *times, const double *values, size_t count,
                                double frequency, double damping)
{
    struct fit_wave best = {.frequency = frequency, .damping = damping};
    double least = wave_left(times, values, count, &best);
    double steps[2] = {0.1 * frequency, 0.5 * damping + 1 / times[count - 1]};
    while (steps[0] > 1e-7 * frequency) {
        struct fit_wave from = best;
        double before = least;
        for (int k = 0; k < 9; k++) {
            struct fit_wave near = {.frequency = from.frequency + (k / 3 - 1) * steps[0],
                                    .damping = from.damping + (k % 3 - 1) * steps[1]};
            double left = wave_left(times, values, count, &near);
            if (left < least) {
                least = left;
                best = near;
            }
        }
        if (!(least < before)) {
            steps[0] /= 2;
            steps[1] /= 2;
        }
    }
    return best;
}

size_t fit_sign_changes(const double *times, const double *values, size_t count, double after,
                        double *out, size_t most)
{
    size_t found = 0;
    for (size_t k = 1; k < count && found < most; k++) {
        double low = values[k - 1], high = values[k];
        if ((low < 0) == (high < 0))
            continue;
        double t = times[k - 1] + low / (low - high) * (times[k] - times[k - 1]);
        if (t > after)
            out[found++] = t;
    }
    return found;
}

double fit_peak(const double *times, const double *values, size_t count, double from, double to)
{
    double top = 0;
    for (size_t k = 0; k < count; k++)
        if (from <= times[k] && times[k] <= to)
            top = fmax(top, fabs(values[k]));
    return top;
}

bool fit_oscillation(const double *times, const double *values, size_t count, double after,
                     struct fit_oscillation *fit)
{
    double changes[CHANGES_MAX], order[CHANGES_MAX];
    size_t n = fit_sign_changes(times, values, count, after, changes, CHANGES_MAX);
    if (n < 3)
        return false;
    for (size_t k = 0; k < n; k++)
        order[k] = (double)k;
    *fit = (struct fit_oscillation){
        .half = fit_slope(order, changes, n),
        .first = fit_peak(times, values, count, 0, changes[0]),
        .last = fit_peak(times, values, count, changes[n - 2], changes[n - 1]),
        .halves = n - 1};
    return true;
}

double fit_crossing(const double *times, const double *values, size_t count, double level)
{
    for (size_t k = 1; k < count; k++)
        if (values[k - 1] < level && level <= values[k]) {
            double part = (level - values[k - 1]) / (values[k] - values[k - 1]);
            return times[k - 1] + part * (times[k] - times[k - 1]);
        }
    return (double)NAN;
}

size_t fit_late(const double *times, size_t count)
{
    size_t k = 0;
    while (times[k] < 0.75 * times[count - 1] * (1 - 1e-9))
        k++;
    return k;
}

double fit_late_mean(const double *times, const double *values, size_t count)
{
    size_t late = fit_late(times, count);
    return mean(values + late, count - late);
}
