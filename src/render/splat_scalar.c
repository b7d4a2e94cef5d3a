/* The cpu renderer's loops for any processor. */
#include "render/splat_loops.h"

static bool supported(void)
{
    return true;
}

const struct splat_isa splat_scalar = {"scalar", supported, tile_fill, tile_shade,
                                     tile_finish, &project_loops, &surface_loops};
