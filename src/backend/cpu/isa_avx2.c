/* Pair passes compiled for avx2. */
#include "backend/cpu/lanes_avx2.h"

#include "backend/cpu/pair_loops.h"

static bool supported(void)
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}

const struct isa_row isa_avx2 = {
    .variant = {.name = "avx2", .doc = "8 particles at a time"},
    .supported = supported,
    .build = loops_build,
    .interleave = loops_interleave,
    .pair = loops_pair,
    .peak = loops_peak,
};
