/* What the encoders of pictures with lines and text (pdf, svg) share: a page for each frame. */
#ifndef ENCODE_VECTOR_H
#define ENCODE_VECTOR_H

#include "encode/encode.h"

#if HAVE_CAIRO
#define VECTOR_MISSING NULL

#include <cairo.h>
#include <stdio.h>

/* A file that is being written. */
struct vector_page {
    FILE *stream;
    const char *title;            /* "": none */
    const char *creator, *subject;
    int tags;                     /* written so far, as far as its kind counts them */
};

/* How a kind of file is made. */
struct vector_kind {
    const char *ending; /* ".pdf" */
    double pixel;       /* its units */
    /* A surface of that many units that writes to the page; not NULL, but may be in error. */
    cairo_surface_t *(*create)(struct vector_page *page, double width, double height);
};

enum status vector_check(const struct encode_target *target, const struct vector_kind *kind,
                         struct error *e);
enum status vector_open(struct encoder **encoder, const struct encode_target *target,
                        const struct vector_kind *kind, struct error *e);
enum status vector_frame(struct encoder *encoder, const struct encode_frame *frame, struct error *e);
enum status vector_close(struct encoder *encoder, bool keep, struct error *e);

#else
#define VECTOR_MISSING "install libcairo2-dev (tools/install-deps does), then make CAIRO=1"
#endif

#endif
