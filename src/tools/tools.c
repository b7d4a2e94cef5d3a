/* The table of sub-commands; a new one is a file and a row here. */
#include "tools/tools.h"

extern const struct tool tool_bench, tool_compare, tool_list, tool_study;

static const struct variant *const rows[] = {
    &tool_bench.variant,
    &tool_compare.variant,
    &tool_list.variant,
    &tool_study.variant,
};

const struct variant_table tool_table = {
    "commands", "sub-commands; without one, a film is made", rows, sizeof rows / sizeof *rows};
