/* Draws particles as lit spheres, off-screen, by OpenGL, by CUDA, or by the processors. */
#ifndef RENDER_RENDER_H
#define RENDER_RENDER_H

#include "base/error.h"
#include "base/image.h"
#include "base/variant.h"
#include "device/device.h"
#include "particles/shown.h"
#include "render/maps.h"
#include "render/scale.h"
#include "scene/scene.h"

#include <stddef.h>

struct canvas_row; /* render/canvas.h */

extern const struct variant_table render_table;    /* "renderers": egl, cuda, cpu, osmesa */
extern const struct variant_table render_maps;     /* "maps": viridis, ... */
extern const struct variant_table render_overlays; /* "overlays": text; missing without cairo */

/* What stays the same for a whole film. */
struct render_setup {
    const struct scene *scene;   /* camera, movie.size, render.*, domain, title, labels */
    const char *renderer;        /* row of render_table, or "auto" */
    const struct canvas_row *canvas; /* instead of a row of the table; NULL: the table's */
    int threads;                 /* of the cpu renderer; 0: all processors */
    const char *isa;             /* of the cpu renderer: a row of "isas"; NULL, "auto": the best */
    int device;                  /* number of the CUDA device: of the cuda renderer, and see on_device */
    bool on_device;              /* frames are in its memory: OpenGL is asked for on the same GPU */
    double radius;               /* drawn sphere radius, m */
    struct color_scale scale;    /* of values, in the unit below; pinned for the film */
    uint8_t palette[MAP_SIZE][3];/* colours from the low to the high end */
    const char *label, *unit;    /* of the colour bar: "speed", "m/s" */
    const char *(*name)(const struct scene *scene, size_t number); /* of counts, or NULL */
    bool raw;                    /* images get raw numbers */
    bool vectors;                /* images get what is written over them as lines and text, too */
    bool solid;                  /* no colour map: particles carry their own colour */
    bool symmetric;              /* a range that is found in each frame is symmetric about zero */
};

/* Frames whose particles are in the memory of a device: where a back end leaves them. */
struct render_source {
    const struct device_row *row;  /* NULL: in the host's memory */
    const struct kernel *kernels;  /* on that device, by enum draw_kernel (render/cuda) */
    int device;
    size_t count;                  /* particles of every frame */
    double low[3], high[3];        /* where they can be, m, relative to domain.min */
};

enum { RENDER_SLOTS = 3 };

/* A place for a frame's particles on a device. */
struct render_slot {
    struct shown_to to;
    struct device_event *filled;   /* happens when the frame is there */
};

/* What changes with each frame. Particles in ascending id: of equal depths the first wins. They are in the
 * arrays, or in a slot. */
struct render_frame {
    long index;                  /* frame number, from 0 */
    double time;                 /* s */
    size_t count;
    const float *position;       /* count * 3, m, relative to domain.min */
    const float *value;          /* count; colour scalar, or NULL when setup.solid */
    const uint8_t *color;        /* count * 4 RGBA when setup.solid, else NULL */
    const struct render_slot *slot; /* instead of the three; NULL: they are used */
    size_t bodies;               /* particles but for those of walls, which come last; of ranges by frame */
    const struct color_scale *scale; /* of this frame's values; NULL: the setup's */
};

struct renderer;

/* STATUS_BACKEND when no renderer can be had; the message says what was tried and what to install.
 * A renderer may be used by the thread that opened it only. */
enum status renderer_open(struct renderer **renderer, const struct render_setup *setup,
                          struct error *e);
/* Its name, e.g. "cpu (avx512, 2 threads)" or "egl (llvmpipe ...)". */
const char *renderer_name(const struct renderer *renderer);

/* Makes RENDER_SLOTS slots for frames of a device, which are drawn from there where the renderer can, else
 * copied to the host: the log says why. Until it is drawn, a frame's slot must stay as it is. */
enum status renderer_slots(struct renderer *renderer, const struct render_source *source,
                           struct render_slot **slots, struct error *e);

/* Draws one frame. `image` may be zeroed or of any size: it is made anew unless it has movie.size.
 * STATUS_BACKEND when GL fails, STATUS_RUN when memory is short. */
enum status renderer_draw(struct renderer *renderer, const struct render_frame *frame,
                          struct image *image, struct error *e);
void renderer_close(struct renderer *renderer); /* accepts NULL */

#endif
