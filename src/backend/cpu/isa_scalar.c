/* Pair passes compiled for one lane of plain C. */
#include "backend/cpu/lanes_scalar.h"

#include "backend/cpu/pair_loops.h"

static bool supported(void)
{
    return true;
}

const struct isa_row isa_scalar = {
    .variant = {.name = "scalar", .doc = "plain C, one particle at a time: the reference"},
    .supported = supported,
    .build = loops_build,
    .interleave = loops_interleave,
    .pair = loops_pair,
    .peak = loops_peak,
};
