/* Encoder "svg": pictures x-%04d.svg, or one, x.svg; letters are outlines. */
#include "encode/vector.h"

#if HAVE_CAIRO

#include <cairo-svg.h>

static void text_write(const char *text, FILE *stream)
{
    for (; *text; text++)
        if (*text == '&')
            fputs("&amp;", stream);
        else if (*text == '<')
            fputs("&lt;", stream);
        else
            putc(*text, stream);
}

/* Behind the second tag, <svg ...>. */
static void metadata_write(const struct vector_page *page)
{
    if (page->title[0]) {
        fputs("\n<title>", page->stream);
        text_write(page->title, page->stream);
        fputs("</title>", page->stream);
    }
    fprintf(page->stream, "\n<desc>%s</desc>", page->subject);
}

static cairo_status_t on_bytes(void *closure, const unsigned char *bytes, unsigned count)
{
    struct vector_page *page = closure;
    for (unsigned i = 0; i < count; i++) {
        putc(bytes[i], page->stream);
        if (page->tags < 2 && bytes[i] == '>' && ++page->tags == 2)
            metadata_write(page);
    }
    return ferror(page->stream) ? CAIRO_STATUS_WRITE_ERROR : CAIRO_STATUS_SUCCESS;
}

static cairo_surface_t *create(struct vector_page *page, double width, double height)
{
    cairo_surface_t *surface = cairo_svg_surface_create_for_stream(on_bytes, page, width, height);
    cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
    return surface;
}

static const struct vector_kind kind = {.ending = ".svg", .pixel = 1, .create = create};

static enum status svg_check(const struct encode_target *target, struct error *e)
{
    return vector_check(target, &kind, e);
}

static enum status svg_open(struct encoder **encoder, const struct encode_target *target,
                            struct error *e)
{
    return vector_open(encoder, target, &kind, e);
}

#endif

extern const struct encoder_row encoder_svg;
const struct encoder_row encoder_svg = {
    .variant = {.name = "svg",
                .doc = "the same as x-%04d.svg or x.svg, letters as outlines",
                .missing = VECTOR_MISSING},
    .extensions = (const char *const[]){".svg", NULL},
    .wants_pixels = true,
    .wants_vectors = true,
#if HAVE_CAIRO
    .check = svg_check,
    .open = svg_open,
    .frame = vector_frame,
    .close = vector_close,
#endif
};
