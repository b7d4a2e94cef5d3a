/* The domain: its floor, and its edges as thin lines, faint where something is in front. */
#ifndef RENDER_WIRE_H
#define RENDER_WIRE_H

#include "render/camera.h"

#include <stdbool.h>
#include <stddef.h>

enum { EDGE_COUNT = 12, LINE_VERTICES = 6, FACE_VERTICES = 3 * (5 - 2), WIRE_LAYERS = 3 };

/* Triangles that are blended over the spheres, one layer after another. */
struct wire_layer {
    float (*vertex)[4]; /* x, y in -1..1, y upwards; 1 / distance (see parallel); signed drawn pixels across the line */
    size_t count;       /* three of each triangle */
    float half_width;   /* of a line with soft sides, drawn pixels; 0: a face */
    float color[4];     /* and its cover, 0..1 */
    bool behind;        /* is drawn where a sphere is in front, not where it is nearer */
};

struct wire {
    float floor[FACE_VERTICES][4], edges[EDGE_COUNT * LINE_VERTICES][4];
    struct wire_layer layers[WIRE_LAYERS];
    size_t count;
    bool parallel; /* orthographic: distance instead of its inverse, so that it is linear in the picture */
};

/* `far` m is farther than all that is drawn, `samples` the pixels drawn per pixel shown, in x. */
void wire_make(struct wire *wire, const struct scene *scene, const struct camera *camera, double far,
               int samples);

#endif
