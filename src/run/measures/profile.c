/* Measures velocity and pressure at points of a line: Shepard means, 0 without particles. */
#include "run/measure.h"

#include <math.h>

enum { POINTS_MAX = 1000 };

/* Whether the particle can reach the line: it is in the box around it, made larger by `radius`. */
static bool is_near(const struct measured *m, const struct scene_measure *asked, double radius,
                    const double x[3])
{
    for (int a = 0; a < 3; a++)
        if (!m->space->periodic[a] && (x[a] < fmin(asked->from[a], asked->to[a]) - radius ||
                                       x[a] > fmax(asked->from[a], asked->to[a]) + radius))
            return false;
    return true;
}

/* Adds the particle to point k; returns its weight there. */
static double add(const struct measured *m, const struct scene_measure *asked, double radius,
                  int64_t k, const struct sample *s, double *sums)
{
    double at[3], r[3], part = asked->points > 1 ? (double)k / (double)(asked->points - 1) : 0;
    for (int a = 0; a < 3; a++)
        at[a] = asked->from[a] + part * (asked->to[a] - asked->from[a]);
    measure_offset(m, at, s->x, r);
    double square = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
    double w = square < radius * radius ? measure_weight(m, s, sqrt(square), radius) : 0;
    for (int a = 0; a < 3; a++)
        sums[a] += w * s->v[a];
    sums[3] += w * s->pressure;
    return w;
}

static void value(const struct measured *m, const struct scene_measure *asked, double *out)
{
    double weight[POINTS_MAX] = {0}, radius = measure_radius(m, asked);
    for (int64_t k = 0; k < 4 * asked->points; k++)
        out[k] = 0;
    for (size_t id = 0; id < m->count; id++) {
        struct sample s = measure_sample(m, id);
        if (!is_near(m, asked, radius, s.x))
            continue;
        for (int64_t k = 0; k < asked->points; k++)
            weight[k] += add(m, asked, radius, k, &s, out + 4 * k);
    }
    for (int64_t k = 0; k < 4 * asked->points; k++)
        out[k] = weight[k / 4] > 0 ? out[k] / weight[k / 4] : 0;
}

static const struct key keys[] = {
    {"measure[].from", KEY_VEC3, KEY_INSIDE, NULL, 0, 0, "m", NULL, "the first point",
     MEASURE_IN(from)},
    {"measure[].to", KEY_VEC3, KEY_INSIDE, NULL, 0, 0, "m", NULL, "the last point",
     MEASURE_IN(to)},
    {"measure[].points", KEY_INT, 0, "10", 1, POINTS_MAX, "", NULL,
     "number of points, evenly spaced", MEASURE_IN(points)},
    MEASURE_RADIUS,
};

static const struct measure_column columns[] = {
    {"velocity.x", "m/s"}, {"velocity.y", "m/s"}, {"velocity.z", "m/s"}, {"pressure", "Pa"},
    {NULL, NULL}};

extern const struct measure_row measure_profile;
const struct measure_row measure_profile = {
    .variant = {.name = "profile",
                .doc = "velocity and pressure at points of a line, weighted by the kernel; "
                       "0 without fluid",
                MEASURE_KEYS(keys)},
    .reads = FIELD_BIT(FIELD_POSITION) | FIELD_BIT(FIELD_MOTION) | FIELD_BIT(FIELD_DENSITY),
    .columns = columns,
    .per_point = true,
    .value = value,
};
