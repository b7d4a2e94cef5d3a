/* Tables of the collapse of Martin and Moyce, and how far a run is from them. */
#include "study/reference/martin_moyce.h"

#include "study/reference/columns.h"
#include "study/reference/fit.h"

#include <math.h>

static const double aligned_z = 1.44, aligned_t = 1.19;

const struct martin_moyce_front martin_moyce_fronts[MARTIN_MOYCE_FRONTS] = {
    {1.11, 0.41, 0.30, 0.48}, {1.22, 0.84, 0.75, 0.91}, {1.44, 1.19, 1.19, 1.19},
    {1.67, 1.43, 1.39, 1.44}, {1.89, 1.63, 1.57, 1.67}, {2.11, 1.83, 1.75, 1.88},
    {2.33, 1.98, 1.90, 2.02}, {2.56, 2.20, 2.04, 2.29}, {2.78, 2.32, 2.21, 2.39},
    {3.00, 2.51, 2.38, 2.66}, {3.22, 2.65, 2.53, 2.74}, {3.44, 2.83, 2.69, 2.93},
    {3.67, 2.97, 2.86, 3.08}, {3.89, 3.11, 2.94, 3.25}, {4.11, 3.33, 3.13, 3.46},
    {5.00, 4.02, 3.90, 4.09}, {5.89, 4.44, 4.37, 4.50}, {7.00, 5.09, 5.01, 5.16},
    {8.00, 5.69, 5.60, 5.76}, {9.00, 6.30, 6.25, 6.34}, {10.0, 6.83, 6.77, 6.90},
    {11.0, 7.44, 7.34, 7.51}, {12.0, 8.08, 8.02, 8.12}, {13.0, 8.67, 8.60, 8.73},
    {14.0, 9.31, 9.26, 9.36}};

const struct martin_moyce_height martin_moyce_heights[MARTIN_MOYCE_HEIGHTS] = {
    {0.56, 0.94}, {0.77, 0.89}, {0.93, 0.83}, {1.08, 0.78}, {1.28, 0.72}, {1.46, 0.67},
    {1.66, 0.61}, {1.84, 0.56}, {2.00, 0.50}, {2.21, 0.44}, {2.45, 0.39}, {2.70, 0.33},
    {3.06, 0.28}, {3.44, 0.22}, {4.20, 0.17}, {5.25, 0.11}, {7.40, 0.06}};

bool martin_moyce_compare_fronts(const struct martin_moyce_column *column, const double *times,
                                 const double *fronts, size_t count,
                                 struct martin_moyce_errors *errors)
{
    double scale = sqrt(2 * column->g / column->width), squares = 0, outside = 0;
    double start = fit_crossing(times, fronts, count, aligned_z * column->width);
    *errors = (struct martin_moyce_errors){0};
    for (size_t k = 0; k < MARTIN_MOYCE_FRONTS; k++) {
        const struct martin_moyce_front *row = &martin_moyce_fronts[k];
        double passed = fit_crossing(times, fronts, count, row->z * column->width);
        double t = (passed - start) * scale + aligned_t;
        if (row->z <= aligned_z || isnan(t))
            continue;
        squares += (t / row->mean - 1) * (t / row->mean - 1);
        outside += t < row->least || t > row->most;
        errors->count++;
    }
    errors->rms = sqrt(squares / (double)errors->count);
    errors->outside = outside / (double)errors->count;
    return errors->count > 0;
}

bool martin_moyce_compare_heights(const struct martin_moyce_column *column, const double *times,
                                  const double *heights, size_t count,
                                  struct martin_moyce_errors *errors)
{
    double scale = sqrt(column->g / column->width), squares = 0;
    *errors = (struct martin_moyce_errors){0};
    for (size_t k = 0; k < MARTIN_MOYCE_HEIGHTS; k++) {
        const struct martin_moyce_height *row = &martin_moyce_heights[k];
        double h = columns_interpolate(times, heights, count, row->tau / scale);
        if (isnan(h))
            continue;
        double error = h / (2 * column->width) - row->h;
        squares += error * error;
        errors->count++;
    }
    errors->rms = sqrt(squares / (double)errors->count);
    return errors->count > 0;
}
