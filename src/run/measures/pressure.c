/* Measures pressure at a point: the Shepard mean, sum V p W / sum V W; 0 without particles. */
#include "run/measure.h"

#include <math.h>

static void value(const struct measured *m, const struct scene_measure *asked, double *out)
{
    double weight = 0, sum = 0, radius = measure_radius(m, asked);
    for (size_t id = 0; id < m->count; id++) {
        struct sample s = measure_sample(m, id);
        double r[3];
        measure_offset(m, asked->at, s.x, r);
        double w = measure_weight(m, &s, sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]), radius);
        weight += w;
        sum += w * s.pressure;
    }
    out[0] = weight > 0 ? sum / weight : 0;
}

static const struct key keys[] = {
    MEASURE_AT("the probe"),
    MEASURE_RADIUS,
};

static const struct measure_column columns[] = {{"", "Pa"}, {NULL, NULL}};

extern const struct measure_row measure_pressure;
const struct measure_row measure_pressure = {
    .variant = {.name = "pressure",
                .doc = "at a point, weighted by the kernel; 0 without particles near",
                MEASURE_KEYS(keys)},
    .reads = FIELD_BIT(FIELD_POSITION) | FIELD_BIT(FIELD_MOTION) | FIELD_BIT(FIELD_DENSITY),
    .columns = columns,
    .value = value,
};
