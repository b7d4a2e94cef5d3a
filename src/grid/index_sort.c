/* Neighbour search over the 27 cells around a point, in particles sorted by cell. */
#include "grid/search.h"

/* The up to three cells around `c` along one axis, ascending and without repeats. */
static int around(uint32_t c, uint32_t size, bool periodic, uint32_t out[3])
{
    int n = 0;
    if (periodic && c + 1 == size && size > 2)
        out[n++] = 0;
    if (c > 0)
        out[n++] = c - 1;
    out[n++] = c;
    if (c + 1 < size)
        out[n++] = c + 1;
    if (periodic && c == 0 && size > 2)
        out[n++] = size - 1;
    return n;
}

static int cell_ranges(const struct cells *cells, const uint32_t point[3], size_t count,
                       struct range out[RANGES_MAX])
{
    uint32_t near[3][3];
    int length[3], n = 0;
    (void)count;
    for (int a = 0; a < 3; a++)
        length[a] = around(cells_axis(cells, a, point[a]), cells->size[a], cells->periodic[a],
                           near[a]);
    for (int z = 0; z < length[2]; z++)
        for (int y = 0; y < length[1]; y++) {
            const uint32_t *row =
                cells->start + ((size_t)near[2][z] * cells->size[1] + near[1][y]) * cells->size[0];
            for (int x = 0; x < length[0];) { /* adjacent cells make one range */
                int first = x++;
                while (x < length[0] && near[0][x] == near[0][x - 1] + 1)
                    x++;
                struct range r = {row[near[0][first]], row[near[0][x - 1] + 1]};
                if (r.first < r.last)
                    out[n++] = r;
            }
        }
    return n;
}

const struct search_row search_index_sort = {
    .variant = {.name = "index-sort", .doc = "particles sorted by cell, 27 cells searched"},
    .ranges = cell_ranges,
};
