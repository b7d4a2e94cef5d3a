/* Keeps what is written over an image as lines and text, by cairo. */
#include "base/vectors.h"

#include <stdlib.h>
#include <string.h>

#if HAVE_CAIRO

#include <cairo.h>

enum status vectors_start(struct image *image, struct error *e)
{
    size_t bytes = (size_t)image->width * 4 * (size_t)image->height;
    if (!image->plain)
        image->plain = malloc(bytes);
    cairo_surface_destroy(image->over);
    cairo_rectangle_t all = {0, 0, image->width, image->height};
    image->over = cairo_recording_surface_create(CAIRO_CONTENT_COLOR_ALPHA, &all);
    if (!image->plain || cairo_surface_status(image->over) != CAIRO_STATUS_SUCCESS)
        return error_set(e, STATUS_RUN, "out of memory for the text over %d x %d pixels",
                         image->width, image->height);
    memcpy(image->plain, image->rgba, bytes);
    return STATUS_OK;
}

/* A recording within a recording is shared between them, and not safely so between threads: it ends
 * here, in the thread that goes on with the other. */
void vectors_move(struct image *from, struct image *to, int left, int top)
{
    size_t line = (size_t)from->width * 4;
    for (int y = 0; y < from->height; y++)
        memcpy(to->plain + ((size_t)(top + y) * (size_t)to->width + (size_t)left) * 4,
               from->plain + (size_t)y * line, line);
    cairo_t *cr = cairo_create(to->over);
    cairo_set_source_surface(cr, from->over, left, top);
    cairo_paint(cr);
    cairo_destroy(cr);
    cairo_surface_destroy(from->over);
    from->over = NULL;
}

void vectors_free(struct image *image)
{
    free(image->plain);
    cairo_surface_destroy(image->over);
}

#else

enum status vectors_start(struct image *image, struct error *e)
{
    (void)image;
    return error_set(e, STATUS_RUN, "this build has no cairo, which lines and text need");
}

void vectors_move(struct image *from, struct image *to, int left, int top)
{
    (void)from;
    (void)to;
    (void)left;
    (void)top;
}

void vectors_free(struct image *image)
{
    (void)image;
}

#endif
