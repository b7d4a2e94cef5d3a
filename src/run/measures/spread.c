/* Measures how wide the fluid is: root mean square distances from the mass centre along each axis. */
#include "run/measure.h"

#include <math.h>

/* Second central moments by mass; of a uniform ellipse they are a quarter of its semi-axes squared.
 * Two passes, so that nothing cancels. */
static void value(const struct measured *m, const struct scene_measure *asked, double *out)
{
    double mass = 0, centre[3] = {0}, square[3] = {0};
    (void)asked;
    for (size_t id = 0; id < m->count; id++) {
        struct sample s = measure_sample(m, id);
        mass += s.mass;
        for (int a = 0; a < 3; a++)
            centre[a] += s.mass * s.x[a];
    }
    for (size_t id = 0; id < m->count; id++) {
        struct sample s = measure_sample(m, id);
        for (int a = 0; a < 3; a++) {
            double from = s.x[a] - centre[a] / mass;
            square[a] += s.mass * from * from;
        }
    }
    for (int a = 0; a < 3; a++)
        out[a] = sqrt(square[a] / mass);
}

static const struct measure_column columns[] = {
    {"x", "m"}, {"y", "m"}, {"z", "m"}, {NULL, NULL}};

extern const struct measure_row measure_spread;
const struct measure_row measure_spread = {
    .variant = {.name = "spread",
                .doc = "root mean square distance from the centre of mass along each axis"},
    .reads = FIELD_BIT(FIELD_POSITION),
    .columns = columns,
    .value = value,
};
