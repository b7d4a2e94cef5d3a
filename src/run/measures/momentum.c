/* Measures momentum, sum m v. */
#include "run/measure.h"

static void value(const struct measured *m, const struct scene_measure *asked, double *out)
{
    (void)asked;
    out[0] = out[1] = out[2] = 0;
    for (size_t id = 0; id < m->count; id++) {
        struct sample s = measure_sample(m, id);
        for (int a = 0; a < 3; a++)
            out[a] += s.mass * s.v[a];
    }
}

static const struct measure_column columns[] = {
    {"x", "kg m/s"}, {"y", "kg m/s"}, {"z", "kg m/s"}, {NULL, NULL}};

extern const struct measure_row measure_momentum;
const struct measure_row measure_momentum = {
    .variant = {.name = "momentum", .doc = "sum of m v"},
    .reads = FIELD_BIT(FIELD_MOTION),
    .columns = columns,
    .value = value,
};
