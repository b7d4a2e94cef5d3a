/* The table of measured quantities; a new one is a file in measures/ and a row here. */
#include "run/measure.h"

extern const struct measure_row measure_energy, measure_momentum, measure_angular_momentum,
    measure_mass_centre, measure_speed, measure_density_error, measure_volume, measure_extent,
    measure_spread, measure_front, measure_height, measure_wave, measure_pressure,
    measure_wall_pressure, measure_profile, measure_layers, measure_flow_error;

static const struct variant *const rows[] = {
    &measure_energy.variant,
    &measure_momentum.variant,
    &measure_angular_momentum.variant,
    &measure_mass_centre.variant,
    &measure_speed.variant,
    &measure_density_error.variant,
    &measure_volume.variant,
    &measure_extent.variant,
    &measure_spread.variant,
    &measure_front.variant,
    &measure_height.variant,
    &measure_wave.variant,
    &measure_pressure.variant,
    &measure_wall_pressure.variant,
    &measure_profile.variant,
    &measure_layers.variant,
    &measure_flow_error.variant,
};

const struct variant_table measure_table = {
    .name = "measures",
    .doc = "quantities that a csv output holds",
    .rows = rows,
    .count = sizeof rows / sizeof *rows,
};

#define USUAL(word) {.quantity = word, .name = word}
const struct scene_measure measure_usual[] = {
    USUAL("energy"), USUAL("momentum"), USUAL("mass-centre"), USUAL("speed"),
    USUAL("density-error"),
};
const size_t measure_usual_count = sizeof measure_usual / sizeof *measure_usual;
