/* Neighbour search over the 27 cells around a point, in particles sorted by cell. */
#include "grid/search.h"

static int ranges(const struct cells *cells, const uint32_t point[3], size_t count,
                  struct range out[RANGES_MAX])
{
    (void)count;
    return cells_ranges(cells, point, out);
}

const struct search_row search_index_sort = {
    .variant = {.name = "index-sort", .doc = "particles sorted by cell, 27 cells searched"},
    .ranges = ranges,
};
