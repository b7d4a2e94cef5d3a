/* Measures how far particles reach along each axis: all of them, and 99.5 % of them. */
#include "run/measure.h"

static void value(const struct measured *m, const struct scene_measure *asked, double *out)
{
    (void)asked;
    for (int a = 0; a < 3; a++) {
        out[4 * a] = measure_quantile(m, a, -1, 1);
        out[4 * a + 1] = measure_quantile(m, a, 1, 1);
        out[4 * a + 2] = measure_quantile(m, a, -1, 0.995);
        out[4 * a + 3] = measure_quantile(m, a, 1, 0.995);
    }
}

static const struct measure_column columns[] = {
    {"x.min", "m"}, {"x.max", "m"}, {"x.low", "m"}, {"x.high", "m"},
    {"y.min", "m"}, {"y.max", "m"}, {"y.low", "m"}, {"y.high", "m"},
    {"z.min", "m"}, {"z.max", "m"}, {"z.low", "m"}, {"z.high", "m"}, {NULL, NULL}};

extern const struct measure_row measure_extent;
const struct measure_row measure_extent = {
    .variant = {.name = "extent",
                .doc = "lowest and highest coordinates, of all particles and without the "
                       "last 0.5 %"},
    .reads = FIELD_BIT(FIELD_POSITION),
    .columns = columns,
    .value = value,
};
