/* The samples of a picture, their rays and background, and the domain as triangles over them: what renderers
 * prepare that draw spheres without OpenGL. */
#ifndef RENDER_SAMPLING_H
#define RENDER_SAMPLING_H

#include "render/blend.h"
#include "render/camera.h"
#include "render/place.h"
#include "render/render.h"

struct sampling {
    const struct render_setup *setup;
    int samples, threads; /* samples per pixel, in x and in y */
    int width, height;    /* samples */
    int tile;             /* samples of a tile's side: whole pixels */
    float *ray_x, *ray_y; /* of each column and row */
    uint32_t map[MAP_SIZE]; /* the palette, red in the lowest byte */
    struct wire wire;       /* the domain, and its triangles */
    struct blends blends;
};

/* `setup` must outlive it. STATUS_BACKEND when the picture is too large for `renderer`; STATUS_RUN when memory
 * is short. Needs sampling_close in any case. */
enum status sampling_open(struct sampling *sampling, const struct render_setup *setup, const char *renderer,
                          struct error *e);
void sampling_close(struct sampling *sampling);

/* Ray directions at the samples' middles; where rays are parallel, their places. */
void sampling_rays(struct sampling *sampling, const struct camera *camera);

struct viewpoint sampling_viewpoint(const struct sampling *sampling, const struct camera *camera, double radius);

/* All but spheres and triangles. */
struct splat sampling_splat(const struct sampling *sampling, const struct camera *camera, double radius,
                            struct image *image);

/* Makes the domain's layers where it is shown; STATUS_RUN when memory is short. */
enum status sampling_wire(struct sampling *sampling, const struct camera *camera,
                          const struct render_frame *frame, struct error *e);

/* Writes raw numbers of one pixel, which shows `ball` (UINT32_MAX: none) at a depth. */
void sampling_raw(const struct render_frame *frame, float depth, uint32_t ball, float raw[RAW_PLANES]);

#endif
