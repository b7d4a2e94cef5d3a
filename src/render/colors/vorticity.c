/* Colour by vorticity. */
#include "render/color.h"

#include <math.h>

/* 2 k U of Taylor-Green vortices with k = 2 pi / L, L the longest edge. */
static void range(const struct color_expectation *expect, double out[2])
{
    const struct scene *s = expect->scene;
    double edge = 0;
    for (int a = 0; a < 3; a++)
        edge = fmax(edge, s->domain.max[a] - s->domain.min[a]);
    out[0] = 0;
    out[1] = expect->fastest > 0 ? 4 * 3.141592653589793 * expect->fastest / edge : 1;
}

const struct color_row color_vorticity = {
    .variant = {.name = "vorticity", .doc = "magnitude of the curl of velocity, 1/s"},
    .label = "vorticity",
    .unit = "1/s",
    .reads = FIELD_BIT(FIELD_VORTICITY),
    .value = VALUE_vorticity,
    .range = range,
    .estimate = "Taylor-Green vortices as wide as the domain, at the expected speed",
};
