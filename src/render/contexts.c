/* The table of GL contexts, best first. */
#include "render/context.h"
#include "render/render.h"

static const struct variant *const rows[] = {&context_egl.variant, &context_osmesa.variant};

const struct variant_table render_contexts = {
    .name = "contexts",
    .doc = "where OpenGL draws without a screen (--gl)",
    .rows = rows,
    .count = sizeof rows / sizeof rows[0],
};
