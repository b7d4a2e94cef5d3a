/* Colour of each fluid as the scene gives it. */
#include "render/color.h"

const struct color_row color_solid = {
    .variant = {.name = "solid", .doc = "the colour of the particle's fluid (fluids[].color)"},
    .label = "",
    .unit = "",
    .solid = true,
};
