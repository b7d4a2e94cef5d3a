/* Colour by fluid. */
#include "render/color.h"

static void range(const struct color_expectation *expect, double out[2])
{
    out[0] = -0.5;
    out[1] = (double)expect->scene->fluid_count - 0.5;
}

static const char *name(const struct scene *scene, size_t number)
{
    return scene->fluids[number].name;
}

const struct color_row color_fluid = {
    .variant = {.name = "fluid", .doc = "which of the scene's fluids: a colour each, named"},
    .label = "fluid",
    .unit = "",
    .counts = true,
    .value = VALUE_fluid,
    .range = range,
    .name = name,
    .estimate = "a colour for each fluid",
};
