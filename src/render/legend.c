/* The colour bar: colours, ticks, name and unit, at the right edge. */
#include "render/legend.h"

#if HAVE_CAIRO

#include "render/ticks.h"

#include <math.h>

enum { TEXTS_MAX = 7 }; /* of a smooth bar */

/* The colour at place 0..1 of the map, mixed as on particles. */
static void color_at(const uint8_t (*palette)[3], double place, double rgb[3])
{
    int low = (int)fmin(floor(place * (MAP_SIZE - 1)), MAP_SIZE - 2);
    double part = place * (MAP_SIZE - 1) - low;
    for (int k = 0; k < 3; k++)
        rgb[k] = ((1 - part) * palette[low][k] + part * palette[low + 1][k]) / 255;
}

static void fill_smooth(const struct layout_box *bar, const uint8_t (*palette)[3], cairo_t *cr)
{
    cairo_pattern_t *gradient = cairo_pattern_create_linear(0, bar->y + bar->height, 0, bar->y);
    for (int i = 0; i < MAP_SIZE; i++)
        cairo_pattern_add_color_stop_rgb(gradient, i / (MAP_SIZE - 1.0), palette[i][0] / 255.0,
                                         palette[i][1] / 255.0, palette[i][2] / 255.0);
    cairo_rectangle(cr, bar->x, bar->y, bar->width, bar->height);
    cairo_set_source(cr, gradient);
    cairo_fill(cr);
    cairo_pattern_destroy(gradient);
}

/* Steps end on whole pixels. */
static void fill_steps(const struct layout_box *bar, const uint8_t (*palette)[3], int steps,
                       cairo_t *cr)
{
    cairo_set_antialias(cr, CAIRO_ANTIALIAS_NONE);
    for (int k = 0; k < steps; k++) {
        double rgb[3], low = round(bar->height * k / steps);
        double high = round(bar->height * (k + 1) / steps);
        color_at(palette, (double)k / (steps - 1), rgb);
        cairo_rectangle(cr, bar->x, bar->y + bar->height - high, bar->width, high - low);
        cairo_set_source_rgb(cr, rgb[0], rgb[1], rgb[2]);
        cairo_fill(cr);
    }
    cairo_set_antialias(cr, CAIRO_ANTIALIAS_DEFAULT);
}

static void fill(const struct ink *ink, const struct layout_box *bar,
                 const struct render_setup *setup, int steps, cairo_t *cr)
{
    if (steps > 1)
        fill_steps(bar, setup->palette, steps, cr);
    else
        fill_smooth(bar, setup->palette, cr);
    cairo_rectangle(cr, bar->x, bar->y, bar->width, bar->height);
    cairo_set_source_rgba(cr, ink->tone, ink->tone, ink->tone, 0.6);
    cairo_set_line_width(cr, fmax(1, ink->size / 16));
    cairo_stroke(cr);
}

static void ticks_draw(const struct ink *ink, const struct layout_box *bar,
                       const struct ticks *ticks, cairo_t *cr)
{
    double right = bar->x + bar->width;
    for (int i = 0; i < ticks->count; i++) {
        const char *text = ticks->items[i].text;
        double y = bar->y + bar->height * (1 - ticks->items[i].part);
        cairo_set_source_rgba(cr, ink->tone, ink->tone, ink->tone, *text ? 0.8 : 0.5);
        cairo_set_line_width(cr, fmax(1, ink->size / 16));
        cairo_move_to(cr, right, y);
        cairo_rel_line_to(cr, ink->size * (*text ? 0.3 : 0.16), 0);
        cairo_stroke(cr);
        if (*text)
            ink_text(ink, cr, right + ink->size * 0.5, y + ink->size * 0.36, text);
    }
}

static double widest(cairo_t *cr, const struct ticks *ticks)
{
    double most = 0;
    for (int i = 0; i < ticks->count; i++)
        most = fmax(most, ink_width(cr, ticks->items[i].text));
    return most;
}

void legend_draw(const struct ink *ink, const struct render_setup *setup,
                 const struct color_scale *scale, bool still, cairo_t *cr, struct layout_box *box)
{
    double width = setup->scene->movie.size[0], height = setup->scene->movie.size[1];
    double size = ink->size, edge = size * 1.2, text, start;
    struct layout_box bar = {.width = floor(size * 0.9)};
    bool each = scale->steps > 1; /* a text for each colour, where there is room */
    double line = (scale->counts ? 1.25 : each ? 1.5 : 2.2) * size; /* between texts */
    double names = scale->counts ? fmin(0.55 * height, line * scale->steps) : 0;
    bar.height = floor(fmax(0.42 * height, names));
    int most = (int)fmax(2, bar.height / line);
    struct ticks ticks;
    char name[300];
    ticks_make(&ticks, setup, scale, each || most < TEXTS_MAX ? most : TEXTS_MAX);
    ticks_name(&ticks, setup, name, sizeof name);
    text = fmax(widest(cr, &ticks), still ? 0 : 3.5 * size);
    bar.x = floor(width - edge - text - size * 0.5 - bar.width) + 0.5;
    bar.y = floor((height - bar.height) / 2) + 0.5;
    fill(ink, &bar, setup, scale->steps, cr);
    ticks_draw(ink, &bar, &ticks, cr);
    start = fmax(0, fmin(bar.x, width - edge - ink_width(cr, name)));
    ink_text(ink, cr, start, bar.y - size * 0.75, name);
    *box = (struct layout_box){fmin(start, bar.x), bar.y - 2 * size, 0, bar.height + 2.5 * size};
    box->width = width - box->x;
}

#endif
