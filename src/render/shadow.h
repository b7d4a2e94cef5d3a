/* The fluid's soft shadow on the floor.
 *
 * Particles are moved along the key light onto the floor and spread over the nodes of a grid by bilinear
 * weights. With n layers of particles over a node, 1 - exp(-n) of its light is taken (exp by its first terms);
 * a binomial kernel of 5 x 5 nodes softens that. The grid is fixed in the domain, and all is continuous in
 * place: no flicker. Weights are whole numbers, so that sums do not depend on threads. */
#ifndef RENDER_SHADOW_H
#define RENDER_SHADOW_H

#include "render/camera.h"
#include "render/render.h"

enum { SHADOW_CELLS = 32, SHADOW_MARGIN = 2, SHADOW_NODES = SHADOW_CELLS + 1 + 2 * SHADOW_MARGIN };

/* Which face of the domain is the floor. */
struct shadow_floor {
    int axis;
    bool at_max;
};

struct shadow {
    int cells[2];   /* of the floor, along the two axes after its own */
    double cell[2]; /* m */
    float taken[SHADOW_NODES][SHADOW_NODES]; /* of the light, 0..1; SHADOW_MARGIN nodes around the floor */
};

/* Of the frame's particles, under the light of this camera. */
void shadow_make(struct shadow *shadow, const struct scene *scene, const struct camera *camera,
                 struct shadow_floor floor, const struct render_frame *frame, int threads);

/* At node i, j of the floor: 0..cells. */
static inline float shadow_taken(const struct shadow *shadow, int i, int j)
{
    return shadow->taken[i + SHADOW_MARGIN][j + SHADOW_MARGIN];
}

#endif
