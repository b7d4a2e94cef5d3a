/* The table of renderers, in the order that auto tries them. */
#include "render/canvas.h"

static const struct variant *const rows[] = {
    &canvas_egl.variant,
    &canvas_cuda.variant,
    &canvas_cpu.variant,
    &canvas_osmesa.variant,
};

const struct variant_table render_table = {
    .name = "renderers",
    .doc = "what draws frames without a screen (--renderer); auto: the first on a GPU, else cpu",
    .rows = rows,
    .count = sizeof rows / sizeof rows[0],
};
