/* Colour fields: what a particle's colour shows. */
#ifndef RENDER_COLOR_H
#define RENDER_COLOR_H

#include "base/variant.h"
#include "particles/fill.h"
#include "particles/shown.h"
#include "scene/scene.h"

#include <stdbool.h>

/* What the plan expects of the flow, for colour ranges. */
struct color_expectation {
    double fastest; /* m/s */
    double depth;   /* m, along gravity */
    double gravity; /* m/s^2 */
    double density; /* largest rest density, kg/m^3 */
    const struct scene *scene;
    const struct fill *start; /* of the bodies */
};

struct color_row {
    struct variant variant;
    const char *label, *unit;
    unsigned reads;   /* FIELD_BIT mask */
    bool solid;       /* the fluid's own colour instead of a scalar */
    bool has_sign;    /* zero is the middle: the scale is symmetric unless the scene says otherwise */
    bool counts;      /* whole numbers 0 .. n - 1, a colour each; the range is -1/2 to n - 1/2 */
    enum shown_value value; /* unless it is fixed */
    float (*fixed)(const struct fill *start, size_t id); /* a value that never changes; else NULL */
    void (*range)(const struct color_expectation *expect, double range[2]);
    const char *(*name)(const struct scene *scene, size_t number); /* of a count; NULL: the number */
    const char *estimate; /* how `range` comes about, for the log */
};

extern const struct variant_table color_table; /* "colors" */
extern const struct color_row color_velocity, color_velocity_x, color_velocity_y, color_velocity_z,
    color_vorticity, color_pressure, color_density, color_density_error, color_fluid, color_body,
    color_id, color_start_x, color_start_y, color_start_z, color_solid;

#endif
