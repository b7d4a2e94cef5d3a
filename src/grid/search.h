/* Neighbour searches: each names the candidates of a particle as ranges of ascending indices. */
#ifndef GRID_SEARCH_H
#define GRID_SEARCH_H

#include "base/variant.h"
#include "grid/cells.h"

struct search_row {
    struct variant variant;
    /* Ranges, ascending and disjoint, that hold every particle within one cell size of the point;
     * returns how many. */
    int (*ranges)(const struct cells *cells, const uint32_t point[3], size_t count,
                  struct range out[RANGES_MAX]);
};

extern const struct variant_table search_table; /* "neighbours": index-sort, all-pairs */
extern const struct search_row search_index_sort, search_all_pairs;

#endif
