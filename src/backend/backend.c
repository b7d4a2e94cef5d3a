/* The table of back ends. */
#include "backend/backend.h"

static const struct variant *const rows[] = {
    &backend_cpu.variant,
};

const struct variant_table backend_table = {
    .name = "backends",
    .doc = "where particles live and passes run",
    .rows = rows,
    .count = sizeof rows / sizeof *rows,
};
