/* The table of instruction sets. */
#include "backend/cpu/isa.h"

static const struct variant *const rows[] = {
#if defined __x86_64__
    &isa_avx512.variant,
    &isa_avx2.variant,
#endif
    &isa_scalar.variant,
};

const struct variant_table isa_table = {
    .name = "isas",
    .doc = "instruction sets of the cpu back end; all give the same bits",
    .rows = rows,
    .count = sizeof rows / sizeof *rows,
};
