/* Measures how far velocities are from a start flow that decays exponentially. */
#include "particles/flows.h"
#include "particles/waves.h"
#include "run/measure.h"

#include <math.h>
#include <string.h>

static double square(const double v[3])
{
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

/* The flow as of a body, as it is at that time. */
static struct scene_body flow_of(const struct measured *m, const struct scene_measure *asked)
{
    struct scene_body body = {.flow_length = asked->flow_length,
                              .flow_speed = asked->flow_speed * wave_exp(-asked->decay * m->time)};
    memcpy(body.flow, asked->flow, sizeof body.flow);
    memcpy(body.flow_center, asked->flow_center, sizeof body.flow_center);
    return body;
}

/* With u the flow at each particle: L1 of speeds, sum | |v| - |u| | / sum |u|; L2 of velocities,
 * sqrt(sum |v - u|^2 / sum |u|^2); and the part of the flow there is, sum v.u / sum |u|^2. */
static void value(const struct measured *m, const struct scene_measure *asked, double *out)
{
    struct scene_body body = flow_of(m, asked);
    double speeds = 0, squares = 0, l1 = 0, l2 = 0, product = 0;
    for (size_t id = 0; id < m->count; id++) {
        struct sample s = measure_sample(m, id);
        double u[3], off[3];
        flow_velocity(&body, s.x, u);
        for (int a = 0; a < 3; a++) {
            off[a] = s.v[a] - u[a];
            product += s.v[a] * u[a];
        }
        speeds += sqrt(square(u));
        squares += square(u);
        l1 += fabs(sqrt(square(s.v)) - sqrt(square(u)));
        l2 += square(off);
    }
    out[0] = speeds > 0 ? l1 / speeds : 0;
    out[1] = squares > 0 ? sqrt(l2 / squares) : 0;
    out[2] = squares > 0 ? product / squares : 0;
}

static const struct key keys[] = {
    {"measure[].flow", KEY_CHOICE, 0, NULL, 0, 0, "", "flows", "the flow to compare with",
     MEASURE_IN(flow)},
    {"measure[].flow_center", KEY_VEC3, 0, "[0, 0, 0]", 0, 0, "m", NULL,
     "the point it is laid about", MEASURE_IN(flow_center)},
    {"measure[].flow_length", KEY_REAL, KEY_ABOVE_MIN, "1", 0, INFINITY, "m", NULL,
     "its length, as `list flows` says", MEASURE_IN(flow_length)},
    {"measure[].flow_speed", KEY_REAL, 0, "1", 0, 0, "m/s", NULL,
     "its speed at time 0, as `list flows` says", MEASURE_IN(flow_speed)},
    {"measure[].decay", KEY_REAL, 0, "0", 0, INFINITY, "1/s", NULL,
     "the rate at which the speed decays", MEASURE_IN(decay)},
};

static const struct measure_column columns[] = {
    {"speed", "1"}, {"velocity", "1"}, {"part", "1"}, {NULL, NULL}};

extern const struct measure_row measure_flow_error;
const struct measure_row measure_flow_error = {
    .variant = {.name = "flow-error",
                .doc = "against a flow that decays: L1 of speeds, L2 of velocities, and the part "
                       "of it that there is",
                MEASURE_KEYS(keys)},
    .reads = FIELD_BIT(FIELD_POSITION) | FIELD_BIT(FIELD_MOTION),
    .columns = columns,
    .value = value,
};
