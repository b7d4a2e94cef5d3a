/* Sorts particles into cells: count, scan, scatter, then by id within each cell. */
#include "grid/cells.h"

#include "base/memory.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>

void cells_resize(struct cells *cells, const struct space *space, double radius, size_t particles)
{
    double most = 8.0 * (double)particles + 4096, size[3], total = 1;
    for (int a = 0; a < 3; a++) {
        size[a] = fmax(1, floor(space->length[a] / radius));
        total *= size[a];
    }
    /* A huge, mostly empty domain: larger cells keep the memory in proportion to the particles. */
    for (int a = 0; a < 3 && total > most; a++)
        size[a] = fmax(1, floor(size[a] * cbrt(most / total)));
    cells->count = 1;
    for (int a = 0; a < 3; a++) {
        cells->size[a] = (uint32_t)fmin(size[a], 1 << 20);
        cells->factor[a] = (uint64_t)cells->size[a] * (space->periodic[a] ? 1 : 2);
        cells->periodic[a] = space->periodic[a];
        cells->count *= cells->size[a];
    }
}

/* Exclusive prefix sum of counts, in parallel: each thread sums a stretch, then adds its offset. */
static void scan(uint32_t *values, size_t count)
{
    size_t threads = (size_t)omp_get_max_threads();
    uint32_t offset[257] = {0};
    if (threads > 256)
        threads = 256;
    if (count < 65536)
        threads = 1;
#pragma omp parallel for num_threads((int)threads) schedule(static, 1)
    for (size_t t = 0; t < threads; t++)
        for (size_t i = count * t / threads; i < count * (t + 1) / threads; i++)
            offset[t + 1] += values[i];
    for (size_t t = 0; t < threads; t++)
        offset[t + 1] += offset[t];
#pragma omp parallel for num_threads((int)threads) schedule(static, 1)
    for (size_t t = 0; t < threads; t++)
        for (size_t i = count * t / threads, sum = offset[t]; i < count * (t + 1) / threads; i++) {
            uint32_t value = values[i];
            values[i] = (uint32_t)sum;
            sum += value;
        }
}

struct keyed {
    uint32_t id, index;
};

static int keyed_compare(const void *a, const void *b)
{
    uint32_t x = ((const struct keyed *)a)->id, y = ((const struct keyed *)b)->id;
    return x < y ? -1 : x > y;
}

/* Sorts a crowded cell; the caller handles usual ones by insertion. */
static void sort_crowd(uint32_t *order, size_t n, const uint32_t *id)
{
    struct keyed *pairs = malloc(n * sizeof *pairs);
    if (!pairs) { /* slower but needs no memory */
        for (size_t gap = n / 2; gap > 0; gap /= 2)
            for (size_t i = gap; i < n; i++)
                for (size_t j = i; j >= gap && id[order[j - gap]] > id[order[j]]; j -= gap) {
                    uint32_t swap = order[j];
                    order[j] = order[j - gap];
                    order[j - gap] = swap;
                }
        return;
    }
    for (size_t i = 0; i < n; i++)
        pairs[i] = (struct keyed){id[order[i]], order[i]};
    qsort(pairs, n, sizeof *pairs, keyed_compare);
    for (size_t i = 0; i < n; i++)
        order[i] = pairs[i].index;
    free(pairs);
}

static void sort_cell(uint32_t *order, size_t n, const uint32_t *id)
{
    if (n > 96) {
        sort_crowd(order, n, id);
        return;
    }
    for (size_t i = 1; i < n; i++) {
        uint32_t moving = order[i], key = id[moving];
        size_t j = i;
        for (; j > 0 && id[order[j - 1]] > key; j--)
            order[j] = order[j - 1];
        order[j] = moving;
    }
}

enum status cells_sort(struct cells *cells, const struct position *position, const uint32_t *id,
                       size_t count, uint32_t *order, uint32_t *scratch, struct error *e)
{
    if (cells->count + 2 > cells->capacity) {
        memory_free(cells->start);
        cells->capacity = cells->count + cells->count / 4 + 2;
        cells->start = memory_create("cells", cells->capacity, sizeof *cells->start, e);
        if (!cells->start)
            return e->status;
    }
    /* start[c + 1] counts cell c, is scanned to its first index, and ends as its last. */
    uint32_t *start = cells->start, *next = start + 1;
#pragma omp parallel for
    for (size_t c = 0; c < cells->count + 2; c++)
        start[c] = 0;
#pragma omp parallel for
    for (size_t i = 0; i < count; i++) {
        scratch[i] = cells_index(cells, position[i].count);
        __atomic_fetch_add(&next[scratch[i]], 1, __ATOMIC_RELAXED);
    }
    scan(next, cells->count);
#pragma omp parallel for
    for (size_t i = 0; i < count; i++)
        order[__atomic_fetch_add(&next[scratch[i]], 1, __ATOMIC_RELAXED)] = (uint32_t)i;
#pragma omp parallel for schedule(static, 256)
    for (size_t c = 0; c < cells->count; c++)
        sort_cell(order + start[c], start[c + 1] - start[c], id);
    return STATUS_OK;
}

void cells_free(struct cells *cells)
{
    memory_free(cells->start);
    *cells = (struct cells){0};
}
