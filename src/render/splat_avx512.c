/* The cpu renderer's loops for AVX-512. */
#include "render/splat_loops.h"

static bool supported(void)
{
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
}

const struct splat_isa splat_avx512 = {"avx512", supported, tile_fill, tile_shade,
                                     tile_finish, &project_loops, &surface_loops};
