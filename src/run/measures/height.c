/* Measures the height of the fluid above a point: to half a spacing above the highest particle. */
#include "run/measure.h"

#include <math.h>

static void value(const struct measured *m, const struct scene_measure *asked, double *out)
{
    double d = m->choice->spacing, top = 0;
    for (size_t id = 0; id < m->count; id++) {
        struct sample s = measure_sample(m, id);
        double r[3], up = 0, square = 0;
        measure_offset(m, asked->at, s.x, r);
        for (int a = 0; a < 3; a++) {
            up += m->up[a] * r[a];
            square += r[a] * r[a];
        }
        if (square - up * up < d * d)
            top = fmax(top, up + d / 2);
    }
    out[0] = top;
}

static const struct key keys[] = {
    MEASURE_AT("its foot; up is against gravity, or y without gravity"),
};

static const struct measure_column columns[] = {{"", "m"}, {NULL, NULL}};

extern const struct measure_row measure_height;
const struct measure_row measure_height = {
    .variant = {.name = "height",
                .doc = "of the fluid above a point: the highest particle near its vertical, and "
                       "half a spacing",
                MEASURE_KEYS(keys)},
    .reads = FIELD_BIT(FIELD_POSITION),
    .columns = columns,
    .value = value,
};
