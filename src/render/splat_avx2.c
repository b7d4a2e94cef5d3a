/* The cpu renderer's loops for AVX2. */
#include "render/splat_loops.h"

static bool supported(void)
{
    return __builtin_cpu_supports("avx2");
}

const struct splat_isa splat_avx2 = {"avx2", supported, tile_fill, tile_shade,
                                     tile_finish, &project_loops, &surface_loops};
