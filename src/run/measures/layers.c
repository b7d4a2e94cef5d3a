/* Measures means of slabs of the domain across an axis: place, velocity and pressure. */
#include "run/measure.h"

#include <math.h>

enum { LAYERS_MAX = 1000, VALUES = 5 };

/* The slab that holds the coordinate. */
static int64_t layer_of(double x, double low, double thickness, int64_t count)
{
    double layer = floor((x - low) / thickness);
    return (int64_t)fmin(fmax(layer, 0), (double)(count - 1));
}

/* Each particle counts by its mass in the slab it is in: no kernel blurs, and the means belong to the
 * mean coordinate, which is the first. An empty slab has its middle, and zeros. */
static void value(const struct measured *m, const struct scene_measure *asked, double *out)
{
    double mass[LAYERS_MAX] = {0}, low = m->scene->domain.min[asked->axis];
    double thickness = (m->scene->domain.max[asked->axis] - low) / (double)asked->points;
    for (int64_t k = 0; k < VALUES * asked->points; k++)
        out[k] = 0;
    for (size_t id = 0; id < m->count; id++) {
        struct sample s = measure_sample(m, id);
        int64_t k = layer_of(s.x[asked->axis], low, thickness, asked->points);
        double values[VALUES] = {s.x[asked->axis], s.v[0], s.v[1], s.v[2], s.pressure};
        mass[k] += s.mass;
        for (int c = 0; c < VALUES; c++)
            out[VALUES * k + c] += s.mass * values[c];
    }
    for (int64_t k = 0; k < asked->points; k++) {
        for (int c = 0; mass[k] > 0 && c < VALUES; c++)
            out[VALUES * k + c] /= mass[k];
        if (mass[k] == 0)
            out[VALUES * k] = low + ((double)k + 0.5) * thickness;
    }
}

static const struct key keys[] = {
    {"measure[].axis", KEY_ENUM, 0, "\"y\"", 0, 0, "", "x|y|z", "across which the slabs lie",
     MEASURE_IN(axis)},
    {"measure[].points", KEY_INT, 0, "10", 1, LAYERS_MAX, "", NULL,
     "number of slabs, of one thickness, that divide the domain", MEASURE_IN(points)},
};

static const struct measure_column columns[] = {
    {"coordinate", "m"}, {"velocity.x", "m/s"}, {"velocity.y", "m/s"}, {"velocity.z", "m/s"},
    {"pressure", "Pa"}, {NULL, NULL}};

extern const struct measure_row measure_layers;
const struct measure_row measure_layers = {
    .variant = {.name = "layers",
                .doc = "mean coordinate, velocity and pressure of the particles in each slab "
                       "across an axis; 0 without",
                MEASURE_KEYS(keys)},
    .reads = FIELD_BIT(FIELD_POSITION) | FIELD_BIT(FIELD_MOTION),
    .columns = columns,
    .per_point = true,
    .value = value,
};
