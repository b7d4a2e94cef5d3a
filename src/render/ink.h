/* Text and lines by cairo, legible over particles: each has a halo of the background. */
#ifndef RENDER_INK_H
#define RENDER_INK_H

#if HAVE_CAIRO

#include <cairo.h>

struct ink {
    double size;              /* of text, pixels */
    double tone;              /* grey level of text, 0 or 1 */
    const double *background; /* of the halo */
};

/* Draws on the surface; free with cairo_destroy. */
cairo_t *ink_painter(cairo_surface_t *surface, double size);
double ink_width(cairo_t *cr, const char *text);

/* (x, y) is the baseline's start. */
void ink_text(const struct ink *ink, cairo_t *cr, double x, double y, const char *text);

/* Draws the path as a line, `width` pixels wide, in red, green, blue; NULL: in the tone of text. */
void ink_stroke(const struct ink *ink, cairo_t *cr, double width, const double *rgb);

#endif
#endif
