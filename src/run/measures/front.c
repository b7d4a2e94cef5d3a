/* Measures how far the fluid has come along an axis: half a spacing beyond its particles. */
#include "run/measure.h"

static void value(const struct measured *m, const struct scene_measure *asked, double *out)
{
    int side = asked->side == 0 ? 1 : -1;
    double beyond = side * m->choice->spacing / 2;
    out[0] = measure_quantile(m, asked->axis, side, 0.999) + beyond;
    out[1] = measure_quantile(m, asked->axis, side, 1) + beyond;
}

static const struct key keys[] = {
    {"measure[].axis", KEY_ENUM, 0, "\"x\"", 0, 0, "", "x|y|z", "along which the front moves",
     MEASURE_IN(axis)},
    {"measure[].side", KEY_ENUM, 0, "\"max\"", 0, 0, "", "max|min",
     "the largest or the lowest coordinate", MEASURE_IN(side)},
};

static const struct measure_column columns[] = {
    {"position", "m"}, {"extreme", "m"}, {NULL, NULL}};

extern const struct measure_row measure_front;
const struct measure_row measure_front = {
    .variant = {.name = "front",
                .doc = "how far 99.9 % and all of the particles reach along an axis, and half "
                       "a spacing",
                MEASURE_KEYS(keys)},
    .reads = FIELD_BIT(FIELD_POSITION),
    .columns = columns,
    .value = value,
};
