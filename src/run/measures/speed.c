/* Measures the largest speed. */
#include "run/measure.h"

#include <math.h>

static void value(const struct measured *m, const struct scene_measure *asked, double *out)
{
    (void)asked;
    double most = 0;
    for (size_t id = 0; id < m->count; id++) {
        struct sample s = measure_sample(m, id);
        most = fmax(most, s.v[0] * s.v[0] + s.v[1] * s.v[1] + s.v[2] * s.v[2]);
    }
    out[0] = sqrt(most);
}

static const struct measure_column columns[] = {{"", "m/s"}, {NULL, NULL}};

extern const struct measure_row measure_speed;
const struct measure_row measure_speed = {
    .variant = {.name = "speed", .doc = "the largest of any particle"},
    .reads = FIELD_BIT(FIELD_MOTION),
    .columns = columns,
    .value = value,
};
