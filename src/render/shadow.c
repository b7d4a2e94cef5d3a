/* The fluid's soft shadow on the floor, by a grid. */
#include "render/shadow.h"

#include "render/look.h"

#include <math.h>
#include <string.h>

enum { ONE = 1 << 12 }; /* the weight of a particle */

/* How particles fall onto the grid. */
struct fall {
    int axis, side[2]; /* the floor's, and those after it */
    double floor;      /* its place along axis, m */
    double slope[2];   /* along side, for 1 m of height above the floor; signed as that is */
};

static const double steepest = 1.0; /* slope: of a lower light, shadows would run away */

static struct fall fall_make(const struct scene *scene, const struct camera *camera, struct shadow_floor floor)
{
    const struct look look = look_make(scene->render.outline);
    struct fall fall = {.axis = floor.axis, .side = {(floor.axis + 1) % 3, (floor.axis + 2) % 3}};
    double key[3], inwards = floor.at_max ? -1 : 1;
    for (int k = 0; k < 3; k++)
        key[k] = (double)look.key[0] * camera->right[k] + (double)look.key[1] * camera->up[k] -
                 (double)look.key[2] * camera->forward[k];
    double u = key[fall.side[0]], v = key[fall.side[1]], aside = sqrt(u * u + v * v);
    double height = fmax(fmax(key[floor.axis] * inwards, aside / steepest), 1e-6);
    fall.floor = floor.at_max ? scene->domain.max[floor.axis] - scene->domain.min[floor.axis] : 0;
    fall.slope[0] = -inwards * u / height;
    fall.slope[1] = -inwards * v / height;
    return fall;
}

static void grid_make(struct shadow *s, const struct scene *scene, const struct fall *fall)
{
    double side[2];
    for (int k = 0; k < 2; k++)
        side[k] = scene->domain.max[fall->side[k]] - scene->domain.min[fall->side[k]];
    double least = fmax(fmax(side[0], side[1]) / SHADOW_CELLS, 1.5 * scene->particles.spacing);
    for (int k = 0; k < 2; k++) {
        s->cells[k] = (int)(side[k] / least * (1 + 1e-9));
        s->cells[k] = s->cells[k] < 1 ? 1 : s->cells[k];
        s->cell[k] = side[k] / s->cells[k];
    }
}

/* The node below the place that a particle falls on, and how far it is beyond, in cells; false off the grid. */
static inline bool node_find(const struct shadow *s, const struct fall *fall, const float p[3], int node[2],
                             float part[2])
{
    double height = p[fall->axis] - fall->floor;
    for (int k = 0; k < 2; k++) {
        double x = (p[fall->side[k]] + height * fall->slope[k]) / s->cell[k] + SHADOW_MARGIN;
        if (!(x >= 0 && x < s->cells[k] + 2 * SHADOW_MARGIN))
            return false;
        node[k] = (int)x;
        part[k] = (float)(x - node[k]);
    }
    return true;
}

/* Sums of weights at the nodes. */
static void weights_make(const struct shadow *s, const struct fall *fall, const struct render_frame *frame,
                         int threads, uint64_t *sum)
{
#pragma omp parallel for schedule(static) num_threads(threads) reduction(+ : sum[:SHADOW_NODES * SHADOW_NODES])
    for (size_t i = 0; i < frame->count; i++) {
        int node[2];
        float part[2];
        if (!node_find(s, fall, frame->position + 3 * i, node, part))
            continue;
        uint64_t *at = sum + node[0] * SHADOW_NODES + node[1];
        float u = part[0] * ONE, v = part[1];
        at[0] += (uint64_t)(int)((ONE - u) * (1 - v));
        at[1] += (uint64_t)(int)((ONE - u) * v);
        at[SHADOW_NODES] += (uint64_t)(int)(u * (1 - v));
        at[SHADOW_NODES + 1] += (uint64_t)(int)(u * v);
    }
}

/* 1 2 1 / 4 along nodes `step` apart of one row, `count` of them; what is beyond the ends is 0. */
static void row_soften(float *node, int step, int count)
{
    float before = 0;
    for (int i = 0; i < count; i++) {
        float here = node[i * step], after = i + 1 < count ? node[(i + 1) * step] : 0;
        node[i * step] = 0.25F * (before + after) + 0.5F * here;
        before = here;
    }
}

void shadow_make(struct shadow *s, const struct scene *scene, const struct camera *camera,
                 struct shadow_floor floor, const struct render_frame *frame, int threads)
{
    const struct fall fall = fall_make(scene, camera, floor);
    uint64_t sum[SHADOW_NODES * SHADOW_NODES] = {0};
    grid_make(s, scene, &fall);
    weights_make(s, &fall, frame, threads, sum);
    const double spacing = scene->particles.spacing;
    const float layer = (float)(spacing * spacing / (s->cell[0] * s->cell[1]) / ONE);
    const int rows = s->cells[0] + 1 + 2 * SHADOW_MARGIN, columns = s->cells[1] + 1 + 2 * SHADOW_MARGIN;
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++) {
            float n = (float)sum[i * SHADOW_NODES + j] * layer;
            s->taken[i][j] = 1 - 1 / (1 + n * (1 + n * (0.5F + n * (1 / 6.0F))));
        }
    for (int round = 0; round < 2; round++) {
        for (int i = 0; i < rows; i++)
            row_soften(s->taken[i], 1, columns);
        for (int j = 0; j < columns; j++)
            row_soften(&s->taken[0][j], SHADOW_NODES, rows);
    }
}
