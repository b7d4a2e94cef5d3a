/* Colour maps: 256 colours from the low to the high end of the range. */
#ifndef RENDER_MAPS_H
#define RENDER_MAPS_H

#include "base/variant.h"
#include "render/scale.h"

#include <stdint.h>

struct render_map {
    struct variant variant;
    void (*fill)(uint8_t (*rgb)[3]); /* writes MAP_SIZE sRGB colours */
};

extern const struct render_map map_viridis, map_plasma, map_inferno, map_magma, map_cividis,
    map_turbo, map_coolwarm, map_grey;

#endif
