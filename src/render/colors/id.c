/* Colour by number of the particle. */
#include "render/color.h"

static float fixed(const struct fill *start, size_t id)
{
    (void)start;
    return (float)id;
}

static void range(const struct color_expectation *expect, double out[2])
{
    out[0] = 0;
    out[1] = expect->start->count > 1 ? (double)(expect->start->count - 1) : 1;
}

const struct color_row color_id = {
    .variant = {.name = "id", .doc = "number of the particle, in order of filling"},
    .label = "particle",
    .unit = "",
    .reads = FIELD_BIT(FIELD_ID),
    .fixed = fixed,
    .range = range,
    .estimate = "all particles",
};
