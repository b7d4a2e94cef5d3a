/* Lines and faces of the domain as triangles in the picture. */
#ifndef RENDER_MESH_H
#define RENDER_MESH_H

#include "render/camera.h"

#include <stdbool.h>
#include <stddef.h>

/* Three vertices of each triangle: x, y in -1..1, y upwards; 1 / distance, or when orthographic the
 * distance, so that it is linear in the picture; of a line the signed pixels across it, of a face what its
 * cover lacks to 1. */
struct mesh {
    float (*vertex)[4];
    size_t count, room;
    bool failed; /* memory was short */
};

/* What lines and faces are seen by; nothing nearer than `near` m is drawn. */
struct mesh_view {
    struct camera camera; /* its size is in drawn pixels */
    double near;
};

/* A line from a to b (m, relative to domain.min), `half` pixels to either side and half a one for its
 * soft edge. */
void mesh_line(struct mesh *mesh, const struct mesh_view *view, const double a[3], const double b[3],
               double half);

/* Corners of a rectangle, in order round it: which of its two ends along each axis. */
extern const int mesh_around[4][2];

/* A face with four corners, in order round it, and their cover, 0..1; NULL: 1. */
void mesh_face(struct mesh *mesh, const struct mesh_view *view, const double corner[4][3],
               const float *cover);

void mesh_free(struct mesh *mesh);

#endif
