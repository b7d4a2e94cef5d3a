/* Particles as lit spheres with exact perspective and depth. */
#ifndef RENDER_SPRITES_H
#define RENDER_SPRITES_H

#include "render/camera.h"
#include "render/gl.h"
#include "render/render.h"

#include <stdint.h>

struct sprites {
    GLuint program, array, buffer, texture, map;
    GLint view, scale, parallel, far, key_light, material, shine, rim; /* uniform locations */
    double outline;                         /* rim / radius */
    size_t chunk;                           /* particles per draw call */
    uint32_t (*packed)[4];                  /* x y z as float bits, then t as float bits or RGBA8 */
    size_t capacity;                        /* of packed */
    bool is_filled;                         /* the buffer has the particles: they are not packed */
};

/* Builds programs and buffers in the current context; STATUS_BACKEND. Call sprites_close also
 * after a failure, on a struct that was zeroed before. */
enum status sprites_open(struct sprites *sprites, const struct gl *gl,
                         const struct render_setup *setup, struct error *e);
void sprites_close(struct sprites *sprites, const struct gl *gl);

/* Packs the particles for the next sprites_draw; STATUS_RUN when memory is short. */
enum status sprites_prepare(struct sprites *sprites, const struct render_setup *setup,
                            const struct render_frame *frame, struct error *e);

/* The largest distance along the camera's axis of the prepared particles' far ends, m; 0 if none
 * is in front. */
double sprites_reach(const struct sprites *sprites, size_t count, const struct camera *camera,
                     double radius);

/* Draws the prepared particles; `far` m is depth 1. Of equal depths the first particle wins. */
void sprites_draw(const struct sprites *sprites, const struct gl *gl, size_t count,
                  const struct camera *camera, double far);

#endif
