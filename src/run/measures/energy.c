/* Measures energy: kinetic, sum m v^2 / 2, and potential, -sum m g.x (zero at the origin). */
#include "run/measure.h"

static void value(const struct measured *m, const struct scene_measure *asked, double *out)
{
    (void)asked;
    const double *g = m->scene->gravity;
    out[0] = out[1] = 0;
    for (size_t id = 0; id < m->count; id++) {
        struct sample s = measure_sample(m, id);
        out[0] += s.mass / 2 * (s.v[0] * s.v[0] + s.v[1] * s.v[1] + s.v[2] * s.v[2]);
        out[1] -= s.mass * (g[0] * s.x[0] + g[1] * s.x[1] + g[2] * s.x[2]);
    }
    out[2] = out[0] + out[1];
}

static const struct measure_column columns[] = {
    {"kinetic", "J"}, {"potential", "J"}, {"total", "J"}, {NULL, NULL}};

extern const struct measure_row measure_energy;
const struct measure_row measure_energy = {
    .variant = {.name = "energy", .doc = "kinetic, potential (-m g.x) and their sum"},
    .reads = FIELD_BIT(FIELD_POSITION) | FIELD_BIT(FIELD_MOTION),
    .columns = columns,
    .value = value,
};
