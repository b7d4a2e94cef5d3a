/* Measures pressure on a rectangle of a face, from the particles within a spacing of it. */
#include "run/measure.h"

/* An automatic corner is NAN and excludes nothing. */
static bool in_rectangle(const struct scene_measure *asked, int axis, const double x[3])
{
    for (int a = 0; a < 3; a++)
        if (a != axis && (x[a] < asked->min[a] || x[a] > asked->max[a]))
            return false;
    return true;
}

static void value(const struct measured *m, const struct scene_measure *asked, double *out)
{
    int axis = asked->face / 2, outwards = asked->face % 2 ? 1 : -1;
    double gravity = outwards * m->scene->gravity[axis], volume = 0, sum = 0;
    double plane = outwards > 0 ? m->scene->domain.max[axis] : m->scene->domain.min[axis];
    for (size_t id = 0; id < m->count; id++) {
        struct sample s = measure_sample(m, id);
        double distance = outwards * (plane - s.x[axis]), v = s.mass / s.density;
        if (distance >= m->choice->spacing || !in_rectangle(asked, axis, s.x))
            continue;
        volume += v;
        sum += v * (s.pressure + s.density * gravity * distance); /* hydrostatic up to the face */
    }
    out[0] = volume > 0 ? sum / volume : 0;
}

static const struct key keys[] = {
    {"measure[].face", KEY_ENUM, 0, NULL, 0, 0, "", "-x|+x|-y|+y|-z|+z", "of the domain",
     MEASURE_IN(face)},
    {"measure[].min", KEY_VEC3, KEY_AUTO, "\"auto\"", 0, 0, "m", NULL,
     "lowest corner of the rectangle, its part across the face ignored; auto: the face's",
     MEASURE_IN(min)},
    {"measure[].max", KEY_VEC3, KEY_AUTO, "\"auto\"", 0, 0, "m", NULL,
     "highest corner; auto: the face's", MEASURE_IN(max)},
};

static const struct measure_column columns[] = {{"", "Pa"}, {NULL, NULL}};

extern const struct measure_row measure_wall_pressure;
const struct measure_row measure_wall_pressure = {
    .variant = {.name = "wall-pressure",
                .doc = "on a rectangle of a face, from particles within a spacing of it; "
                       "0 without fluid",
                MEASURE_KEYS(keys)},
    .reads = FIELD_BIT(FIELD_POSITION) | FIELD_BIT(FIELD_MOTION) | FIELD_BIT(FIELD_DENSITY),
    .columns = columns,
    .value = value,
};
