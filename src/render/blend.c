/* Turns the domain's floor, faces and edges into triangles in samples. */
#include "render/blend.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* a + b x + c y through three values at three points. */
static void plane_make(double p[3][2], double area, const float value[3], double out[3])
{
    double u = (double)value[1] - (double)value[0], v = (double)value[2] - (double)value[0];
    double ux = p[1][0] - p[0][0], uy = p[1][1] - p[0][1];
    double vx = p[2][0] - p[0][0], vy = p[2][1] - p[0][1];
    out[1] = (u * vy - v * uy) / area;
    out[2] = (v * ux - u * vx) / area;
    out[0] = (double)value[0] - out[1] * p[0][0] - out[2] * p[0][1];
}

/* The edge from a to b, positive on its left. It is computed from the lesser of its ends, so that its
 * numbers are exactly opposite in the triangle on the other side. */
static void edge_make(const double a[2], const double b[2], double sign, double out[3], bool *owns)
{
    bool swap = a[0] > b[0] || (a[0] == b[0] && a[1] > b[1]);
    const double *p = swap ? b : a, *q = swap ? a : b;
    double s = swap ? -sign : sign, dx = q[0] - p[0], dy = q[1] - p[1];
    out[0] = s * (dy * p[0] - dx * p[1]);
    out[1] = s * -dy;
    out[2] = s * dx;
    *owns = s > 0;
}

static int bound(double x, int count)
{
    return x > 0 ? x < count ? (int)x : count : 0;
}

/* False where the triangle has no area. */
static bool blend_make(const struct wire_layer *layer, bool parallel, const float (*vertex)[4], int width, int height,
                       struct blend *out)
{
    double p[3][2], low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    float inverse[3], across[3];
    for (int i = 0; i < 3; i++) {
        p[i][0] = ((double)vertex[i][0] + 1) / 2 * width;
        p[i][1] = (1 - (double)vertex[i][1]) / 2 * height;
        inverse[i] = vertex[i][2];
        across[i] = vertex[i][3];
        for (int a = 0; a < 2; a++) {
            low[a] = fmin(low[a], p[i][a]);
            high[a] = fmax(high[a], p[i][a]);
        }
    }
    double area = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[2][0] - p[0][0]) * (p[1][1] - p[0][1]);
    if (!(fabs(area) > 0) || !isfinite(area))
        return false;
    *out = (struct blend){.half_width = layer->half_width, .cover = layer->color[3],
                          .behind = layer->behind, .solid = layer->solid, .parallel = parallel,
                          .left = bound(low[0], width), .right = bound(high[0] + 1, width),
                          .top = bound(low[1], height), .bottom = bound(high[1] + 1, height)};
    memcpy(out->color, layer->color, 3 * sizeof *out->color);
    out->color[3] = 1; /* alpha, where there is */
    for (int i = 0; i < 3; i++)
        edge_make(p[i], p[(i + 1) % 3], area > 0 ? 1 : -1, out->edge[i], &out->owns[i]);
    plane_make(p, area, inverse, out->inverse);
    plane_make(p, area, across, out->across);
    return true;
}

static bool layer_is_in(const struct wire_layer *layer, enum blend_part part)
{
    return part == BLEND_ALL || (part == BLEND_BACK ? layer->back : !layer->behind);
}

enum status blends_make(struct blends *b, const struct wire *wire, enum blend_part part, int width,
                        int height, struct error *e)
{
    size_t most = 0;
    b->count = 0;
    for (size_t k = 0; k < wire->count; k++)
        most += wire->layers[k].count / 3;
    if (most > b->room) {
        blends_free(b);
        b->blend = malloc(most * sizeof *b->blend);
        b->room = b->blend ? most : 0;
        if (!b->blend)
            return error_set(e, STATUS_RUN, "out of memory for the domain's picture");
    }
    for (size_t k = 0; k < wire->count; k++) {
        const struct wire_layer *layer = &wire->layers[k];
        const float (*vertex)[4] = (const float (*)[4])(wire->mesh.vertex + layer->first);
        for (size_t i = 0; i + 3 <= layer->count && layer_is_in(layer, part); i += 3)
            b->count += blend_make(layer, wire->parallel, vertex + i, width, height, &b->blend[b->count]);
    }
    return STATUS_OK;
}

void blends_free(struct blends *b)
{
    free(b->blend);
    memset(b, 0, sizeof *b);
}
