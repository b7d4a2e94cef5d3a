/* The table of colour fields. */
#include "render/color.h"

static const struct variant *const rows[] = {
    &color_velocity.variant,
    &color_pressure.variant,
    &color_density.variant,
    &color_solid.variant,
};

const struct variant_table color_table = {
    .name = "colors",
    .doc = "what a particle's colour shows",
    .rows = rows,
    .count = sizeof rows / sizeof *rows,
};
