/* Text and lines by cairo, legible over particles: each has a halo of the background. */
#include "render/ink.h"

#include <stdbool.h>
#include <stddef.h>

#if HAVE_CAIRO

/* A recording has no pixels that the shapes of letters could be fitted to. */
static bool is_recorded(cairo_surface_t *surface)
{
    return cairo_surface_get_type(surface) == CAIRO_SURFACE_TYPE_RECORDING;
}

cairo_t *ink_painter(cairo_surface_t *surface, double size)
{
    cairo_t *cr = cairo_create(surface);
    cairo_font_options_t *options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_hint_style(options, is_recorded(surface) ? CAIRO_HINT_STYLE_NONE
                                                                    : CAIRO_HINT_STYLE_SLIGHT);
    cairo_set_font_options(cr, options);
    cairo_font_options_destroy(options);
    cairo_select_font_face(cr, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr, size);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    return cr;
}

double ink_width(cairo_t *cr, const char *text)
{
    cairo_text_extents_t extents;
    cairo_text_extents(cr, text, &extents);
    return extents.x_advance;
}

static void halo(const struct ink *ink, cairo_t *cr, double width)
{
    const double *back = ink->background;
    cairo_set_source_rgba(cr, back[0], back[1], back[2], 0.7);
    cairo_set_line_width(cr, width);
    cairo_stroke_preserve(cr);
}

void ink_text(const struct ink *ink, cairo_t *cr, double x, double y, const char *text)
{
    cairo_move_to(cr, x, y);
    cairo_text_path(cr, text);
    halo(ink, cr, ink->size * 0.22);
    cairo_set_source_rgba(cr, ink->tone, ink->tone, ink->tone, 0.92);
    if (!is_recorded(cairo_get_target(cr))) {
        cairo_fill(cr);
        return;
    }
    cairo_new_path(cr); /* text stays text */
    cairo_move_to(cr, x, y);
    cairo_show_text(cr, text);
    cairo_new_path(cr);
}

void ink_stroke(const struct ink *ink, cairo_t *cr, double width, const double *rgb)
{
    halo(ink, cr, width + ink->size * 0.22);
    if (rgb)
        cairo_set_source_rgb(cr, rgb[0], rgb[1], rgb[2]);
    else
        cairo_set_source_rgba(cr, ink->tone, ink->tone, ink->tone, 0.92);
    cairo_set_line_width(cr, width);
    cairo_stroke(cr);
}

#endif
