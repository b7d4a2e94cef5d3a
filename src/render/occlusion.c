/* Ambient occlusion per particle, by a grid. */
#include "render/occlusion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MARGIN = 4, NODES_MAX = 1 << 24, STEPS = 3, DIRECTIONS = 14 };

static const signed char directions[DIRECTIONS][3] = {
    {1, 0, 0},   {-1, 0, 0},  {0, 1, 0},   {0, -1, 0},   {0, 0, 1},   {0, 0, -1},  {1, 1, 1},
    {1, 1, -1},  {1, -1, 1},  {1, -1, -1}, {-1, 1, 1},   {-1, 1, -1}, {-1, -1, 1}, {-1, -1, -1},
};

static enum status grid_make(struct occlusion *o, const struct scene *scene, struct error *e)
{
    double cell = 2 * scene->particles.spacing, nodes;
    for (;; cell *= 1.25) {
        nodes = 1;
        for (int a = 0; a < 3; a++)
            nodes *= ceil((scene->domain.max[a] - scene->domain.min[a]) / cell) + 1 + 2 * MARGIN;
        if (nodes <= NODES_MAX)
            break;
    }
    for (int a = 0; a < 3; a++)
        o->count[a] = (int)ceil((scene->domain.max[a] - scene->domain.min[a]) / cell) + 1 + 2 * MARGIN;
    o->cell = (float)cell;
    o->nodes = (size_t)nodes;
    if (o->nodes > o->room) {
        free(o->fill);
        free(o->open);
        o->fill = malloc(o->nodes * sizeof *o->fill);
        o->open = malloc(o->nodes * sizeof *o->open);
        o->room = o->fill && o->open ? o->nodes : 0;
    }
    return o->room ? STATUS_OK : error_set(e, STATUS_RUN, "out of memory for ambient occlusion");
}

/* The node below a place, and how far it is beyond, in cells; false where no grid is. */
static bool place_find(const struct occlusion *o, const float p[3], size_t *node, float part[3])
{
    int at[3];
    for (int a = 0; a < 3; a++) {
        float x = p[a] / o->cell + MARGIN;
        if (!(x >= 0 && x < (float)(o->count[a] - 1)))
            return false;
        at[a] = (int)x;
        part[a] = x - (float)at[a];
    }
    *node = ((size_t)at[2] * (size_t)o->count[1] + (size_t)at[1]) * (size_t)o->count[0] + (size_t)at[0];
    return true;
}

/* Corner k of a cell (bits: x y z), and its weight. */
static size_t corner(const struct occlusion *o, size_t node, int k, const float part[3], float *weight)
{
    *weight = (k & 1 ? part[0] : 1 - part[0]) * (k & 2 ? part[1] : 1 - part[1]) *
              (k & 4 ? part[2] : 1 - part[2]);
    return node + (size_t)(k & 1) + (size_t)(k >> 1 & 1) * (size_t)o->count[0] +
           (size_t)(k >> 2) * (size_t)o->count[0] * (size_t)o->count[1];
}

/* In order of the particles, so that sums have the same bits. */
static void fill_make(struct occlusion *o, double spacing, const struct render_frame *frame)
{
    const float share = (float)(spacing * spacing * spacing) / (o->cell * o->cell * o->cell);
    float part[3], weight;
    size_t node;
    memset(o->fill, 0, o->nodes * sizeof *o->fill);
    for (size_t i = 0; i < frame->count; i++)
        if (place_find(o, frame->position + 3 * i, &node, part))
            for (int k = 0; k < 8; k++) {
                size_t at = corner(o, node, k, part, &weight);
                o->fill[at] += weight * share;
            }
}

static float openness(const struct occlusion *o, int x, int y, int z)
{
    float sum = 0;
    for (int d = 0; d < DIRECTIONS; d++) {
        float left = 1;
        for (int step = 1; step <= STEPS; step++) {
            int i = x + step * directions[d][0], j = y + step * directions[d][1];
            int k = z + step * directions[d][2];
            if (i < 0 || j < 0 || k < 0 || i >= o->count[0] || j >= o->count[1] || k >= o->count[2])
                break;
            float full = o->fill[((size_t)k * (size_t)o->count[1] + (size_t)j) * (size_t)o->count[0] +
                                 (size_t)i];
            left *= full < 1 ? 1 - full : 0;
        }
        sum += left;
    }
    return sum / DIRECTIONS;
}

enum status occlusion_make(struct occlusion *o, const struct scene *scene,
                           const struct render_frame *frame, int threads, struct error *e)
{
    if (grid_make(o, scene, e))
        return e->status;
    fill_make(o, scene->particles.spacing, frame);
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads)
    for (int z = 0; z < o->count[2]; z++)
        for (int y = 0; y < o->count[1]; y++)
            for (int x = 0; x < o->count[0]; x++)
                o->open[((size_t)z * (size_t)o->count[1] + (size_t)y) * (size_t)o->count[0] +
                        (size_t)x] = openness(o, x, y, z);
    return STATUS_OK;
}

float occlusion_shade(const struct occlusion *o, const float position[3], float strength)
{
    float part[3], open = 0, weight;
    size_t node;
    if (!place_find(o, position, &node, part))
        return 1;
    for (int k = 0; k < 8; k++) {
        size_t at = corner(o, node, k, part, &weight);
        open += weight * o->open[at];
    }
    open = 2 * open < 1 ? 2 * open : 1; /* a flat surface is open */
    return 1 - strength * (1 - open);
}

void occlusion_free(struct occlusion *o)
{
    free(o->fill);
    free(o->open);
    memset(o, 0, sizeof *o);
}
