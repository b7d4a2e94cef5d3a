/* Chooses colours by splitting: always the group with the largest squared error, at its mean. */
#include "encode/palette.h"

#include <stdlib.h>
#include <string.h>

enum { BITS = 6, CELLS = 1 << (3 * BITS) };

struct cell { /* pixels whose colours share their upper bits */
    uint64_t count, sum[3];
};

struct group { /* of cells: first .. first + count of `order` */
    uint32_t first, count;
    int axis;               /* 0 red, 1 green, 2 blue: where it is widest */
    double error, mean[3];  /* squared, along the axis, of all its pixels */
};

struct palette {
    struct cell cells[CELLS];
    uint32_t order[CELLS];  /* cells that have pixels, by group */
    uint8_t index[CELLS];   /* group of a cell */
    struct group groups[PALETTE_SIZE];
};

struct palette *palette_create(void)
{
    return malloc(sizeof(struct palette));
}

void palette_free(struct palette *palette)
{
    free(palette);
}

static uint32_t cell_of(const uint8_t rgba[4])
{
    const int drop = 8 - BITS;
    return (uint32_t)(rgba[0] >> drop) << 2 * BITS | (uint32_t)(rgba[1] >> drop) << BITS |
           (uint32_t)(rgba[2] >> drop);
}

/* Returns the number of cells that have pixels. */
static uint32_t count_pixels(struct palette *p, const struct image *image)
{
    size_t pixels = (size_t)image->width * (size_t)image->height;
    uint32_t used = 0;
    memset(p->cells, 0, sizeof p->cells);
    for (size_t i = 0; i < pixels; i++) {
        const uint8_t *rgba = image->rgba + 4 * i;
        uint32_t at = cell_of(rgba);
        struct cell *cell = &p->cells[at];
        if (cell->count++ == 0)
            p->order[used++] = at;
        for (int k = 0; k < 3; k++)
            cell->sum[k] += rgba[k];
    }
    return used;
}

static double cell_mean(const struct cell *cell, int k)
{
    return (double)cell->sum[k] / (double)cell->count;
}

/* Fills mean, axis and error. */
static void measure(const struct palette *p, struct group *g)
{
    double count = 0, sum[3] = {0, 0, 0}, error[3] = {0, 0, 0};
    for (uint32_t i = g->first; i < g->first + g->count; i++) {
        const struct cell *cell = &p->cells[p->order[i]];
        count += (double)cell->count;
        for (int k = 0; k < 3; k++)
            sum[k] += (double)cell->sum[k];
    }
    for (int k = 0; k < 3; k++)
        g->mean[k] = sum[k] / count;
    for (uint32_t i = g->first; i < g->first + g->count; i++) {
        const struct cell *cell = &p->cells[p->order[i]];
        for (int k = 0; k < 3; k++) {
            double d = cell_mean(cell, k) - g->mean[k];
            error[k] += (double)cell->count * d * d;
        }
    }
    g->axis = error[0] > error[1] ? 0 : 1;
    g->axis = error[2] > error[g->axis] ? 2 : g->axis;
    g->error = g->count > 1 ? error[g->axis] : 0;
}

/* Cells of `g` above its mean go to `upper`; both have some, as the error is not 0. */
static void split(struct palette *p, struct group *g, struct group *upper)
{
    uint32_t end = g->first + g->count, keep = g->first;
    for (uint32_t i = g->first; i < end; i++)
        if (cell_mean(&p->cells[p->order[i]], g->axis) <= g->mean[g->axis]) {
            uint32_t cell = p->order[i];
            p->order[i] = p->order[keep];
            p->order[keep++] = cell;
        }
    upper->first = keep;
    upper->count = end - keep;
    g->count = keep - g->first;
    measure(p, g);
    measure(p, upper);
}

/* Returns the number of groups. */
static int split_all(struct palette *p, uint32_t used)
{
    int count = 1;
    p->groups[0] = (struct group){.first = 0, .count = used};
    measure(p, &p->groups[0]);
    while (count < PALETTE_SIZE) {
        struct group *worst = &p->groups[0];
        for (int i = 1; i < count; i++)
            if (p->groups[i].error > worst->error)
                worst = &p->groups[i];
        if (!(worst->error > 0))
            break;
        split(p, worst, &p->groups[count++]);
    }
    return count;
}

void palette_choose(struct palette *p, const struct image *image, uint32_t colors[PALETTE_SIZE])
{
    int count = split_all(p, count_pixels(p, image));
    for (int i = 0; i < PALETTE_SIZE; i++) {
        const struct group *g = &p->groups[i < count ? i : 0];
        colors[i] = 0xff000000;
        for (int k = 0; k < 3; k++)
            colors[i] |= (uint32_t)(g->mean[k] + 0.5) << (16 - 8 * k);
        for (uint32_t c = g->first; i < count && c < g->first + g->count; c++)
            p->index[p->order[c]] = (uint8_t)i;
    }
}

uint8_t palette_index(const struct palette *p, const uint8_t rgba[4])
{
    return p->index[cell_of(rgba)];
}
