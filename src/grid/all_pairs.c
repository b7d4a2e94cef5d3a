/* Neighbour search that tries every particle: the reference for the others. */
#include "grid/search.h"

static int all_ranges(const struct cells *cells, const uint32_t point[3], size_t count,
                      struct range out[RANGES_MAX])
{
    (void)cells, (void)point;
    out[0] = (struct range){0, (uint32_t)count};
    return 1;
}

const struct search_row search_all_pairs = {
    .variant = {.name = "all-pairs", .doc = "every particle is a candidate: slow reference"},
    .ranges = all_ranges,
};
