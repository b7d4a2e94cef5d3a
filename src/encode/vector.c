/* Writes frames as pages: the picture as an image, and what is written over it as lines and text. */
#include "encode/vector.h"

#if HAVE_CAIRO

#include "base/memory.h"
#include "encode/numbered.h"

#include <stdlib.h>
#include <string.h>

struct encoder {
    struct numbered files;
    const struct vector_kind *kind;
    char *title, *subject;
};

enum status vector_check(const struct encode_target *target, const struct vector_kind *kind,
                         struct error *e)
{
    struct sequence names;
    return numbered_names(&names, target, kind->ending, e);
}

static void encoder_free(struct encoder *encoder)
{
    free(encoder->title);
    free(encoder->subject);
    memory_free(encoder);
}

enum status vector_open(struct encoder **made, const struct encode_target *target,
                        const struct vector_kind *kind, struct error *e)
{
    struct encoder *encoder = memory_create("encoder", 1, sizeof *encoder, e);
    *made = NULL;
    if (!encoder)
        return e->status;
    encoder->kind = kind;
    encoder->title = strdup(target->title ? target->title : "");
    encoder->subject = strdup(target->comment ? target->comment : "");
    if (!encoder->title || !encoder->subject)
        error_set(e, STATUS_RUN, "%s: no memory", target->path);
    else if (numbered_names(&encoder->files.names, target, kind->ending, e) == STATUS_OK) {
        *made = encoder;
        return STATUS_OK;
    }
    encoder_free(encoder);
    return e->status;
}

static bool is_opaque(const struct image *image)
{
    size_t bytes = (size_t)image->width * (size_t)image->height * 4;
    for (size_t i = 3; i < bytes; i += 4)
        if (image->plain[i] != 255)
            return false;
    return true;
}

/* RGBA, whose colours are not multiplied by alpha, as cairo's pixel. */
static uint32_t premultiplied(const uint8_t *p)
{
    uint32_t alpha = p[3], out = alpha << 24;
    for (int k = 0; k < 3; k++)
        out |= (p[k] * alpha + 127) / 255 << (16 - 8 * k);
    return out;
}

/* The pixels without what is written over them. */
static cairo_surface_t *pixels(const struct image *image)
{
    cairo_surface_t *surface = cairo_image_surface_create(
        is_opaque(image) ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32, image->width, image->height);
    if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS)
        return surface;
    unsigned char *data = cairo_image_surface_get_data(surface);
    size_t stride = (size_t)cairo_image_surface_get_stride(surface);
    const uint8_t *from = image->plain;
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++, from += 4) {
            uint32_t pixel = premultiplied(from);
            memcpy(data + (size_t)y * stride + (size_t)x * 4, &pixel, sizeof pixel);
        }
    cairo_surface_mark_dirty(surface);
    return surface;
}

/* What went wrong with the page, else with the drawing. */
static cairo_status_t page_draw(cairo_surface_t *page, double pixel, const struct image *image)
{
    cairo_surface_t *under = pixels(image);
    cairo_t *cr = cairo_create(page);
    cairo_scale(cr, pixel, pixel);
    cairo_set_source_surface(cr, under, 0, 0);
    cairo_paint(cr);
    cairo_set_source_surface(cr, image->over, 0, 0);
    cairo_paint(cr);
    cairo_show_page(cr);
    cairo_status_t drawn = cairo_status(cr), written;
    cairo_destroy(cr);
    cairo_surface_destroy(under);
    cairo_surface_finish(page);
    written = cairo_surface_status(page);
    return written ? written : drawn;
}

enum status vector_frame(struct encoder *encoder, const struct encode_frame *frame, struct error *e)
{
    const struct vector_kind *kind = encoder->kind;
    const struct image *image = frame->image;
    struct output_file file;
    struct error ignored;
    if (numbered_open(&encoder->files, frame->index, &file, e))
        return e->status;
    struct vector_page page = {.stream = file.stream, .title = encoder->title,
                               .creator = "sph-render " SPH_VERSION, .subject = encoder->subject};
    cairo_surface_t *surface =
        kind->create(&page, image->width * kind->pixel, image->height * kind->pixel);
    cairo_status_t drawn = page_draw(surface, kind->pixel, image);
    cairo_surface_destroy(surface);
    if (!drawn || drawn == CAIRO_STATUS_WRITE_ERROR) /* closing says why it could not be written */
        return numbered_close(&encoder->files, frame->index, &file, true, e);
    error_set(e, STATUS_RUN, "%s: %s", file.path, cairo_status_to_string(drawn));
    numbered_close(&encoder->files, frame->index, &file, false, &ignored);
    return e->status;
}

enum status vector_close(struct encoder *encoder, bool keep, struct error *e)
{
    enum status status = numbered_end(&encoder->files, keep, e);
    encoder_free(encoder);
    return status;
}

#endif
