/* Measures angular momentum about a point, sum m (x - at) x v. */
#include "run/measure.h"

static void value(const struct measured *m, const struct scene_measure *asked, double *out)
{
    out[0] = out[1] = out[2] = 0;
    for (size_t id = 0; id < m->count; id++) {
        struct sample s = measure_sample(m, id);
        double r[3];
        measure_offset(m, asked->at, s.x, r);
        for (int a = 0; a < 3; a++) {
            int b = (a + 1) % 3, c = (a + 2) % 3;
            out[a] += s.mass * (r[b] * s.v[c] - r[c] * s.v[b]);
        }
    }
}

static const struct key keys[] = {
    {"measure[].at", KEY_VEC3, 0, "[0, 0, 0]", 0, 0, "m", NULL, "the point about which it turns",
     MEASURE_IN(at)},
};

static const struct measure_column columns[] = {
    {"x", "kg m^2/s"}, {"y", "kg m^2/s"}, {"z", "kg m^2/s"}, {NULL, NULL}};

extern const struct measure_row measure_angular_momentum;
const struct measure_row measure_angular_momentum = {
    .variant = {.name = "angular-momentum", .doc = "sum of m (x - at) x v",
                MEASURE_KEYS(keys)},
    .reads = FIELD_BIT(FIELD_POSITION) | FIELD_BIT(FIELD_MOTION),
    .columns = columns,
    .value = value,
};
