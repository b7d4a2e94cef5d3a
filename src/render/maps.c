/* The table of colour maps, default first. */
#include "render/maps.h"

#include "render/render.h"

static const struct variant *const rows[] = {
    &map_viridis.variant, &map_plasma.variant,   &map_inferno.variant,
    &map_magma.variant,   &map_cividis.variant,  &map_turbo.variant,
    &map_coolwarm.variant, &map_grey.variant,
};

const struct variant_table render_maps = {
    .name = "maps",
    .doc = "colour maps (color.map)",
    .rows = rows,
    .count = sizeof rows / sizeof rows[0],
};
