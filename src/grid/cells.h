/* A uniform grid over the space: which particles lie in which cell, in canonical order.
 *
 * Canonical order is cell by cell (x fastest, then y, z) and by id within a cell. Particles are kept
 * in that order in memory, so "neighbours in canonical order" means "by ascending index", and every
 * neighbour search that yields ascending indices gives the same sums to the last bit. The inline
 * functions are in the common subset of C and CUDA. */
#ifndef GRID_CELLS_H
#define GRID_CELLS_H

#include "base/error.h"
#include "particles/particles.h"
#include "particles/space.h"

struct cells {
    uint32_t size[3];   /* cells along each axis */
    uint64_t factor[3]; /* cell = coordinate * factor >> 32 */
    bool periodic[3];
    size_t count;       /* product of sizes */
    size_t capacity;    /* cells that `start` has room for */
    uint32_t *start;    /* count + 1: first particle of each cell */
};

/* Chooses cells no smaller than `radius` (m), and not many more than there are particles. */
void cells_resize(struct cells *cells, const struct space *space, double radius, size_t particles);

/* Finds the canonical order: order[new] = old. `scratch` has room for `count` indices.
 * Fills cells->start. STATUS_RUN when memory is short. */
enum status cells_sort(struct cells *cells, const struct position *position, const uint32_t *id,
                       size_t count, uint32_t *order, uint32_t *scratch, struct error *e);
void cells_free(struct cells *cells);

/* The cell along one axis. */
static inline uint32_t cells_axis(const struct cells *cells, int axis, uint32_t coordinate)
{
    uint32_t c = (uint32_t)(coordinate * cells->factor[axis] >> 32);
    return c < cells->size[axis] ? c : cells->size[axis] - 1;
}

/* The cell of a point. */
static inline uint32_t cells_index(const struct cells *cells, const uint32_t point[3])
{
    uint32_t x = cells_axis(cells, 0, point[0]), y = cells_axis(cells, 1, point[1]);
    return (cells_axis(cells, 2, point[2]) * cells->size[1] + y) * cells->size[0] + x;
}

/* Half-open range of particle indices. */
struct range {
    uint32_t first, last;
};
enum { RANGES_MAX = 18 };

/* The up to three cells around `c` along one axis, ascending and without repeats. */
static inline int cells_around(uint32_t c, uint32_t size, bool periodic, uint32_t out[3])
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

/* Candidates of a point: those of the 27 cells around it, as ranges of ascending indices; returns how many
 * ranges. */
static inline int cells_ranges(const struct cells *cells, const uint32_t point[3],
                               struct range out[RANGES_MAX])
{
    uint32_t near[3][3];
    int length[3], n = 0;
    for (int a = 0; a < 3; a++)
        length[a] = cells_around(cells_axis(cells, a, point[a]), cells->size[a], cells->periodic[a],
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

#endif
