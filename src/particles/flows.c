/* The table of start velocity fields, and their use by a body. */
#include "particles/flows.h"


#include <math.h>

static const struct variant *const rows[] = {
    &flow_none.variant,     &flow_taylor_green.variant,  &flow_beltrami.variant,
    &flow_rotation.variant, &flow_elliptic.variant,      &flow_standing_wave.variant,
    &flow_shear.variant,
};

const struct variant_table flow_table = {
    .name = "flows",
    .doc = "velocity fields that bodies may start with, about bodies[].flow_center",
    .rows = rows,
    .count = sizeof rows / sizeof *rows,
};

/* A scene's flow is one of the table: the key is checked. */
static const struct flow_row *row_of(const struct scene_body *body)
{
    const struct variant *row = variant_find(&flow_table, body->flow);
    return row ? (const struct flow_row *)row : &flow_none;
}

static void relative(const struct scene_body *body, const double x[3], double out[3])
{
    for (int a = 0; a < 3; a++)
        out[a] = x[a] - body->flow_center[a];
}

bool flow_still(const struct scene_body *body)
{
    const double *v = body->velocity;
    bool flows = row_of(body)->velocity && body->flow_speed != 0;
    return v[0] == 0 && v[1] == 0 && v[2] == 0 && !flows;
}

void flow_velocity(const struct scene_body *body, const double x[3], double v[3])
{
    const struct flow_row *row = row_of(body);
    double from[3], own[3] = {0};
    relative(body, x, from);
    if (row->velocity)
        row->velocity(from, body->flow_length, body->flow_speed, own);
    for (int a = 0; a < 3; a++)
        v[a] = body->velocity[a] + own[a];
}

double flow_pressure(const struct scene_body *body, double density, const double x[3])
{
    const struct flow_row *row = row_of(body);
    double from[3], speed = body->flow_speed;
    relative(body, x, from);
    return row->pressure ? density * speed * speed * row->pressure(from, body->flow_length) : 0;
}

double flow_fastest(const struct scene_body *body)
{
    enum { STEPS = 16 };
    double most = 0, min[3], max[3];
    int steps = row_of(body)->velocity ? STEPS : 0; /* one point will do for a uniform velocity */
    shape_bounds(&body->shape, min, max);
    for (int z = 0; z <= steps; z++)
        for (int y = 0; y <= steps; y++)
            for (int x = 0; x <= steps; x++) {
                int at[3] = {x, y, z};
                double p[3], v[3];
                for (int a = 0; a < 3; a++)
                    p[a] = min[a] + (max[a] - min[a]) * at[a] / STEPS;
                flow_velocity(body, p, v);
                most = fmax(most, v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
            }
    return sqrt(most);
}
