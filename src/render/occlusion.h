/* Ambient occlusion baked per particle: how much of the surroundings is open around it.
 *
 * Particles are spread over the nodes of a grid by trilinear weights. From each node rays go into 14
 * directions, along axes and diagonals, three cells far; what is left of a ray is the product of 1 - fill
 * along it, and their mean is the node's openness: about 1/2 at a flat surface, less in a crease, 1 for a drop.
 * Particles take it trilinearly, so that it is continuous in space: no noise, and no flicker. */
#ifndef RENDER_OCCLUSION_H
#define RENDER_OCCLUSION_H

#include "render/render.h"

struct occlusion {
    float *fill, *open;  /* of nodes, x fastest */
    size_t nodes, room;
    int count[3];        /* nodes along each axis */
    float cell;          /* m */
};

/* From the frame's particles, `spacing` m apart, in the scene's domain. STATUS_RUN when memory is short. */
enum status occlusion_make(struct occlusion *occlusion, const struct scene *scene,
                           const struct render_frame *frame, int threads, struct error *e);

/* 1 where the place is open, 1 - `strength` where it is closed all around. */
float occlusion_shade(const struct occlusion *occlusion, const float position[3], float strength);

void occlusion_free(struct occlusion *occlusion);

#endif
