/* Measures the error of density, rho / rho0 - 1. */
#include "run/measure.h"

#include <math.h>

static void value(const struct measured *m, const struct scene_measure *asked, double *out)
{
    (void)asked;
    double sum = 0, most = -INFINITY, positive = 0;
    for (size_t id = 0; id < m->count; id++) {
        struct sample s = measure_sample(m, id);
        double error = s.density / s.rest_density - 1;
        sum += error;
        positive += fmax(error, 0);
        most = fmax(most, error);
    }
    out[0] = sum / (double)m->count;
    out[1] = m->count ? most : (double)NAN;
    out[2] = positive / (double)m->count;
}

static const struct measure_column columns[] = {
    {"mean", "1"}, {"max", "1"}, {"compression", "1"}, {NULL, NULL}};

extern const struct measure_row measure_density_error;
const struct measure_row measure_density_error = {
    .variant = {.name = "density-error",
                .doc = "rho/rho0 - 1: mean, largest, and mean of what is positive"},
    .reads = FIELD_BIT(FIELD_DENSITY),
    .columns = columns,
    .value = value,
};
