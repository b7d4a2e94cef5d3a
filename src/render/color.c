/* The table of colour fields. */
#include "render/color.h"

static const struct variant *const rows[] = {
    &color_velocity.variant,      &color_velocity_x.variant, &color_velocity_y.variant,
    &color_velocity_z.variant,    &color_vorticity.variant,  &color_pressure.variant,
    &color_density.variant,       &color_density_error.variant,
    &color_fluid.variant,         &color_body.variant,       &color_id.variant,
    &color_start_x.variant,       &color_start_y.variant,    &color_start_z.variant,
    &color_solid.variant,
};

const struct variant_table color_table = {
    .name = "colors",
    .doc = "what a particle's colour shows",
    .rows = rows,
    .count = sizeof rows / sizeof *rows,
};
