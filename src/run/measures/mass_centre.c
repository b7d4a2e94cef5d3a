/* Measures the centre of mass; on a periodic axis of the wrapped particles. */
#include "run/measure.h"

static void value(const struct measured *m, const struct scene_measure *asked, double *out)
{
    (void)asked;
    double mass = 0;
    out[0] = out[1] = out[2] = 0;
    for (size_t id = 0; id < m->count; id++) {
        struct sample s = measure_sample(m, id);
        mass += s.mass;
        for (int a = 0; a < 3; a++)
            out[a] += s.mass * s.x[a];
    }
    for (int a = 0; a < 3; a++)
        out[a] /= mass;
}

static const struct measure_column columns[] = {
    {"x", "m"}, {"y", "m"}, {"z", "m"}, {NULL, NULL}};

extern const struct measure_row measure_mass_centre;
const struct measure_row measure_mass_centre = {
    .variant = {.name = "mass-centre", .doc = "centre of mass"},
    .reads = FIELD_BIT(FIELD_POSITION),
    .columns = columns,
    .value = value,
};
