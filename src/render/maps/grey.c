/* Colour map grey: black to white. */
#include "render/maps.h"

static void fill(uint8_t (*rgb)[3])
{
    for (int i = 0; i < MAP_SIZE; i++)
        rgb[i][0] = rgb[i][1] = rgb[i][2] = (uint8_t)i;
}

const struct render_map map_grey = {
    .variant = {.name = "grey", .doc = "black to white"},
    .fill = fill,
};
