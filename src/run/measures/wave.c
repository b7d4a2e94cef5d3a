/* Measures a wave of one length in the distribution of mass along an axis. */
#include "particles/waves.h"
#include "run/measure.h"

#include <math.h>

/* Means by mass of cos k(x - at) and sin k(x - at). A fluid of uniform density, depth H and level
 * A cos k(x - at) over a whole number of wavelengths has the mean cosine A/(2 H): level settling
 * leaves it alone, and it counts every particle, not only the highest. */
static void value(const struct measured *m, const struct scene_measure *asked, double *out)
{
    double mass = 0;
    out[0] = out[1] = 0;
    for (size_t id = 0; id < m->count; id++) {
        struct sample s = measure_sample(m, id);
        double waves = (s.x[asked->axis] - asked->at[asked->axis]) / asked->wavelength;
        mass += s.mass;
        out[0] += s.mass * wave_cosine(waves);
        out[1] += s.mass * wave_sine(waves);
    }
    out[0] /= mass;
    out[1] /= mass;
}

static const struct key keys[] = {
    {"measure[].axis", KEY_ENUM, 0, "\"x\"", 0, 0, "", "x|y|z", "along which the wave lies",
     MEASURE_IN(axis)},
    {"measure[].at", KEY_VEC3, 0, "[0, 0, 0]", 0, 0, "m", NULL, "where a crest is",
     MEASURE_IN(at)},
    {"measure[].wavelength", KEY_REAL, KEY_ABOVE_MIN, NULL, 0, INFINITY, "m", NULL,
     "2 pi / k", MEASURE_IN(wavelength)},
};

static const struct measure_column columns[] = {
    {"cosine", "1"}, {"sine", "1"}, {NULL, NULL}};

extern const struct measure_row measure_wave;
const struct measure_row measure_wave = {
    .variant = {.name = "wave",
                .doc = "means of cos k(x - at) and sin k(x - at) over the mass, along an axis",
                MEASURE_KEYS(keys)},
    .reads = FIELD_BIT(FIELD_POSITION),
    .columns = columns,
    .value = value,
};
