/* The domain: its obstacles, its floor with the fluid's shadow, faces and edges, these faint where something is
 * in front. */
#ifndef RENDER_WIRE_H
#define RENDER_WIRE_H

#include "render/mesh.h"
#include "render/shadow.h"

/* Triangles that are blended over the spheres, one layer after another. */
struct wire_layer {
    size_t first, count; /* vertices of the mesh */
    float half_width;    /* of a line with soft sides, drawn pixels; 0: a face */
    float color[4];      /* and its cover, 0..1 */
    bool behind;         /* is drawn where a sphere is in front, not where it is nearer */
    bool back;           /* is on the far side of the domain, or in it: seen through a fluid */
    bool solid;          /* opaque: it hides later layers as a sphere does */
};

struct wire {
    struct mesh mesh;
    struct shadow shadow;
    struct wire_layer *layers;
    size_t count, room;
    bool parallel; /* orthographic: the mesh has distances, not their inverse */
};

/* Whether the scene shows anything of the domain. */
bool wire_wanted(const struct scene *scene);

/* What is drawn, and how. */
struct wire_view {
    const struct scene *scene;
    const struct camera *camera;
    const struct render_frame *frame; /* whose particles cast the shadow */
    double far;                       /* m, farther than all that is drawn */
    int samples;                      /* pixels drawn per pixel shown, in x */
    int threads;
};

/* STATUS_RUN when memory is short. */
enum status wire_make(struct wire *wire, const struct wire_view *view, struct error *e);
void wire_free(struct wire *wire);

/* Ends a layer of the vertices since the last one; mesh.failed when memory is short. */
void wire_layer_end(struct wire *wire, struct wire_layer layer);

#endif
