/* Colour fields: what a particle's colour shows. */
#ifndef RENDER_COLOR_H
#define RENDER_COLOR_H

#include "base/variant.h"
#include "particles/particles.h"
#include "scene/scene.h"

#include <stdbool.h>

/* What the plan expects of the flow, for colour ranges. */
struct color_expectation {
    double fastest; /* m/s */
    double depth;   /* m, along gravity */
    double gravity; /* m/s^2 */
    double density; /* largest rest density, kg/m^3 */
};

struct color_row {
    struct variant variant;
    const char *label, *unit;
    unsigned reads;   /* FIELD_BIT mask */
    bool solid;       /* the fluid's own colour instead of a scalar */
    float (*value)(const struct particles *particles, size_t i);
    void (*range)(const struct color_expectation *expect, double range[2]);
    const char *estimate; /* how `range` comes about, for the log */
};

extern const struct variant_table color_table; /* "colors" */
extern const struct color_row color_velocity, color_pressure, color_density, color_solid;

#endif
