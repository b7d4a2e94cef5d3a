/* Start flow: uniform shear. */
#include "particles/flows.h"

static void velocity(const double x[3], double length, double speed, double v[3])
{
    v[0] = speed * (x[1] / length);
    v[1] = v[2] = 0;
}

const struct flow_row flow_shear = {
    .variant = {.name = "shear", .doc = "along x, flow_speed (y / flow_length)"},
    .velocity = velocity,
};
