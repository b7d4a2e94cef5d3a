/* A renderer: what draws spheres and the domain, and what is written over it. */
#include "render/render.h"

#include "base/log.h"
#include "base/vectors.h"
#include "render/camera.h"
#include "render/canvas.h"
#include "render/overlay.h"
#include "render/percentiles.h"
#include "render/slots.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct renderer {
    struct render_setup setup;
    const struct canvas_row *row;
    void *canvas;
    struct overlay *overlay;
    struct slots slots;
    bool shares;       /* the canvas draws from slots */
    int width, height; /* pixels */
};

/* The row that auto tries as number k: those that lead, then the others, either in the order of the table. */
static const struct canvas_row *row_to_try(const struct renderer *r, size_t k)
{
    for (int leads = 1; leads >= 0; leads--)
        for (size_t i = 0; i < render_table.count; i++) {
            const struct canvas_row *row = (const struct canvas_row *)render_table.rows[i];
            if ((row->leads && row->leads(&r->setup)) == leads && k-- == 0)
                return row;
        }
    return NULL;
}

/* Tries the rows of this build in order, and keeps what each one said. OpenGL that a processor emulates
 * is slower than the cpu renderer, which comes next. */
static enum status any_open(struct renderer *r, struct error *e)
{
    char tried[1800] = "";
    for (size_t i = 0; i < render_table.count; i++) {
        const struct canvas_row *row = row_to_try(r, i);
        size_t used = strlen(tried);
        const char *why = row->variant.missing;
        if (!why && row->open(&r->canvas, row, &r->setup, e) == STATUS_OK) {
            r->row = row;
            if (!row->software(r->canvas)) {
                if (used)
                    log_detail("renderers passed over:%s", tried);
                return STATUS_OK;
            }
            row->close(r->canvas);
            r->canvas = NULL;
            why = "there is no GPU for OpenGL, and cpu draws faster than OpenGL by software";
        }
        snprintf(tried + used, sizeof tried - used, "\n  %s: %.800s", row->variant.name,
                 why ? why : e->text);
    }
    return error_set(e, STATUS_BACKEND, "nothing to draw with:%s", tried);
}

static enum status canvas_choose(struct renderer *r, struct error *e)
{
    const char *name = r->setup.renderer;
    r->row = r->setup.canvas;
    if (!r->row && (!name || strcmp(name, "auto") == 0))
        return any_open(r, e);
    if (!r->row)
        r->row = (const struct canvas_row *)variant_find(&render_table, name);
    if (!r->row)
        return error_set(e, STATUS_BACKEND, "there is no renderer \"%s\"", name);
    if (r->row->variant.missing)
        return error_set(e, STATUS_BACKEND, "renderer %s is not in this build: %s", name,
                         r->row->variant.missing);
    if (r->row->open(&r->canvas, r->row, &r->setup, e) == STATUS_OK)
        return STATUS_OK;
    return error_context(e, "renderer %s", name);
}

enum status renderer_open(struct renderer **renderer, const struct render_setup *setup,
                          struct error *e)
{
    struct renderer *r = calloc(1, sizeof *r);
    *renderer = NULL;
    if (!r)
        return error_set(e, STATUS_RUN, "out of memory");
    r->setup = *setup;
    r->width = setup->scene->movie.size[0];
    r->height = setup->scene->movie.size[1];
    enum status status = canvas_choose(r, e);
    if (status == STATUS_OK)
        status = overlay_open(&r->overlay, &r->setup, e);
    if (status == STATUS_OK)
        *renderer = r;
    else
        renderer_close(r);
    return status;
}

const char *renderer_name(const struct renderer *r)
{
    return r->row->name(r->canvas);
}

void renderer_close(struct renderer *r)
{
    if (!r)
        return;
    overlay_close(r->overlay);
    if (r->canvas)
        r->row->close(r->canvas);
    slots_close(&r->slots);
    free(r);
}

/* What the host has to see of each frame; NULL: nothing. */
static const char *host_wanted(const struct render_setup *setup)
{
    const struct scene *scene = setup->scene;
    return setup->raw                                    ? "raw images have their values"
           : !isnan(scene->color.percentiles[0])         ? "color.percentiles are of their values"
           : scene->render.occlusion > 0                 ? "render.occlusion is computed there"
           : scene->render.shadow > 0                    ? "render.shadow is computed there"
                                                         : NULL;
}

static enum status canvas_share(struct renderer *r, struct error *e)
{
    const char *why = host_wanted(&r->setup);
    if (why)
        return error_set(e, STATUS_BACKEND, "%s", why);
    if (!r->row->share)
        return error_set(e, STATUS_BACKEND, "renderer %s draws there", r->row->variant.name);
    return r->row->share(r->canvas, &r->slots, e);
}

enum status renderer_slots(struct renderer *r, const struct render_source *source,
                           struct render_slot **slots, struct error *e)
{
    struct error why;
    if (slots_open(&r->slots, source, e))
        return e->status;
    r->shares = canvas_share(r, &why) == STATUS_OK;
    if (r->shares)
        log_detail("frames are drawn where they are computed");
    else
        log_detail("frames are copied to the host's memory: %s", why.text);
    *slots = r->slots.slot;
    return STATUS_OK;
}

/* Particles in host memory unless the canvas has them, and the frame's own range. */
static enum status frame_prepare(struct renderer *r, struct render_frame *frame, struct color_scale *scale,
                                 struct error *e)
{
    if (frame->slot && !r->shares && slots_copy(&r->slots, frame, r->setup.solid, e))
        return e->status;
    if (frame->value && !isnan(r->setup.scene->color.percentiles[0])) {
        *scale = frame->scale ? *frame->scale : r->setup.scale;
        percentiles_range(&r->setup, frame->value, frame->bodies, scale);
        frame->scale = scale;
    }
    return STATUS_OK;
}

enum status renderer_draw(struct renderer *r, const struct render_frame *given,
                          struct image *image, struct error *e)
{
    struct camera camera;
    struct color_scale scale;
    struct render_frame own = *given, *frame = &own;
    if (!image->rgba || image->width != r->width || image->height != r->height) {
        image_free(image);
        if (image_create(image, r->width, r->height, e))
            return e->status;
    }
    camera_make(&camera, r->setup.scene, r->setup.radius, frame->time);
    if (frame_prepare(r, frame, &scale, e) || r->row->draw(r->canvas, &camera, frame, image, e))
        return error_context(e, "frame %ld", frame->index);
    if (r->setup.vectors) {
        if (vectors_start(image, e))
            return e->status;
        overlay_record(&r->setup, frame, image, 0, 0);
    }
    overlay_draw(r->overlay, frame, image);
    return STATUS_OK;
}
