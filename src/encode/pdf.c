/* Encoder "pdf": pages x-%04d.pdf, or one, x.pdf, a pixel 1/96 inch. */
#include "encode/vector.h"

#if HAVE_CAIRO

#include <cairo-pdf.h>

static cairo_status_t on_bytes(void *page, const unsigned char *bytes, unsigned count)
{
    FILE *stream = ((struct vector_page *)page)->stream;
    return fwrite(bytes, 1, count, stream) == count ? CAIRO_STATUS_SUCCESS
                                                     : CAIRO_STATUS_WRITE_ERROR;
}

/* No date: a picture made again is the same bytes. */
static cairo_surface_t *create(struct vector_page *page, double width, double height)
{
    cairo_surface_t *surface = cairo_pdf_surface_create_for_stream(on_bytes, page, width, height);
    if (page->title[0])
        cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, page->title);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_SUBJECT, page->subject);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, page->creator);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, NULL);
    return surface;
}

static const struct vector_kind kind = {.ending = ".pdf", .pixel = 72 / 96.0, .create = create};

static enum status pdf_check(const struct encode_target *target, struct error *e)
{
    return vector_check(target, &kind, e);
}

static enum status pdf_open(struct encoder **encoder, const struct encode_target *target,
                            struct error *e)
{
    return vector_open(encoder, target, &kind, e);
}

#endif

extern const struct encoder_row encoder_pdf;
const struct encoder_row encoder_pdf = {
    .variant = {.name = "pdf",
                .doc = "pictures x-%04d.pdf, or one, x.pdf, whose text and colour bar are sharp at any size",
                .missing = VECTOR_MISSING},
    .extensions = (const char *const[]){".pdf", NULL},
    .wants_pixels = true,
    .wants_vectors = true,
#if HAVE_CAIRO
    .check = pdf_check,
    .open = pdf_open,
    .frame = vector_frame,
    .close = vector_close,
#endif
};
