/* Pair passes compiled for avx512. */
#include "backend/cpu/lanes_avx512.h"

#include "backend/cpu/pair_loops.h"

static bool supported(void)
{
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl");
}

const struct isa_row isa_avx512 = {
    .variant = {.name = "avx512", .doc = "16 particles at a time"},
    .supported = supported,
    .build = loops_build,
    .interleave = loops_interleave,
    .pair = loops_pair,
    .peak = loops_peak,
};
