/* The table of neighbour searches. */
#include "grid/search.h"

static const struct variant *const rows[] = {
    &search_index_sort.variant,
    &search_all_pairs.variant,
};

const struct variant_table search_table = {
    .name = "neighbours",
    .doc = "neighbour searches; all give the same bits",
    .rows = rows,
    .count = sizeof rows / sizeof *rows,
};
