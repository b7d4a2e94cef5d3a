/* What draws the spheres and the domain of a frame: a row of the table of renderers. */
#ifndef RENDER_CANVAS_H
#define RENDER_CANVAS_H

#include "render/camera.h"
#include "render/render.h"
#include "render/slots.h"

struct canvas_row {
    struct variant variant;
    const struct gl_context_row *context; /* of a row that draws by OpenGL, else NULL */
    /* Makes a canvas for pictures of movie.size; on failure nothing stays open. STATUS_BACKEND says what
     * was tried; STATUS_RUN when memory is short. */
    enum status (*open)(void **canvas, const struct canvas_row *row, const struct render_setup *setup,
                        struct error *e);
    /* Whether it can draw frames from those slots, which outlive it, without the host; STATUS_BACKEND says why
     * not. NULL: it never can. */
    enum status (*share)(void *canvas, const struct slots *slots, struct error *e);
    /* Draws into an image of movie.size. */
    enum status (*draw)(void *canvas, const struct camera *camera, const struct render_frame *frame,
                        struct image *image, struct error *e);
    /* "egl (llvmpipe ...)"; and whether a processor emulates it. */
    const char *(*name)(const void *canvas);
    bool (*software)(const void *canvas);
    void (*close)(void *canvas); /* accepts NULL */
    /* Whether auto tries it before the rows above it; NULL: never. */
    bool (*leads)(const struct render_setup *setup);
};

extern const struct canvas_row canvas_egl, canvas_cpu, canvas_osmesa;
extern const struct canvas_row canvas_cuda; /* only with CUDA=1 */

#endif
