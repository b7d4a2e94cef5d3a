/* Colour by body. */
#include "render/color.h"

static float fixed(const struct fill *start, size_t id)
{
    return (float)start->body[id];
}

static void range(const struct color_expectation *expect, double out[2])
{
    size_t bodies = expect->scene->body_count;
    out[0] = -0.5;
    out[1] = (double)(bodies > 0 ? bodies : 1) - 0.5;
}

const struct color_row color_body = {
    .variant = {.name = "body", .doc = "which of the scene's bodies it began in: a colour each"},
    .label = "body",
    .unit = "",
    .reads = FIELD_BIT(FIELD_ID),
    .counts = true,
    .fixed = fixed,
    .range = range,
    .estimate = "a colour for each body",
};
