/* What is written over a frame: colour bar, title and time stamp. */
#include "render/overlay.h"

#if HAVE_CAIRO

#include "render/camera.h"
#include "render/maps.h"

#include <cairo.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT_HEIGHT_MIN = 8 /* pixels; smaller is not legible */, TICK_MAX = 8 };

struct overlay {
    cairo_surface_t *still; /* of the picture's size */
    cairo_surface_t *stamp; /* redrawn for each frame, at the lower left */
    double size;            /* of text, pixels */
    double ink;             /* grey level of text, 0 or 1; the halo is the background */
    const double *background;
    int decimals;           /* of the time stamp */
};

static cairo_t *painter(cairo_surface_t *surface, double size)
{
    cairo_t *cr = cairo_create(surface);
    cairo_font_options_t *options = cairo_font_options_create();
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_SLIGHT);
    cairo_set_font_options(cr, options);
    cairo_font_options_destroy(options);
    cairo_select_font_face(cr, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr, size);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    return cr;
}

static double text_width(cairo_t *cr, const char *text)
{
    cairo_text_extents_t extents;
    cairo_text_extents(cr, text, &extents);
    return extents.x_advance;
}

/* Text with a halo of the background, legible over particles too; (x, y) is its baseline start. */
static void text_draw(const struct overlay *o, cairo_t *cr, double x, double y, const char *text)
{
    cairo_move_to(cr, x, y);
    cairo_text_path(cr, text);
    cairo_set_source_rgba(cr, o->background[0], o->background[1], o->background[2], 0.7);
    cairo_set_line_width(cr, o->size * 0.22);
    cairo_stroke_preserve(cr);
    cairo_set_source_rgba(cr, o->ink, o->ink, o->ink, 0.92);
    cairo_fill(cr);
}

/* The round step (1, 2 or 5 times a power of ten) that gives the most ticks up to `most`. */
static double tick_step(double span, int most)
{
    double power = pow(10, floor(log10(span / most)));
    static const double factors[] = {1, 2, 5, 10};
    for (size_t i = 0; i < 4; i++)
        if (span / (power * factors[i]) <= most)
            return power * factors[i];
    return power * 20;
}

/* The power of ten, a multiple of 3, that is put before the unit to keep tick texts short. */
static int tick_exponent(const double range[2])
{
    double largest = fmax(fabs(range[0]), fabs(range[1]));
    if (!isfinite(largest) || largest == 0 || (largest >= 0.01 && largest < 10000))
        return 0;
    return 3 * (int)floor(log10(largest) / 3 + 1e-9);
}

static void tick_text(char *text, size_t size, double value, double step, int exponent)
{
    double scale = pow(10, exponent);
    int decimals = (int)fmin(9, fmax(0, -floor(log10(step / scale) + 1e-9)));
    snprintf(text, size, "%.*f", decimals, fabs(value) < step / 2 ? 0 : value / scale);
}

/* "speed (m/s)", "pressure (10^3 Pa)" with the exponent raised. */
static void bar_name(char *text, size_t size, const struct render_setup *setup)
{
    static const char *const digits[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                         "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    const char *label = setup->label ? setup->label : "", *unit = setup->unit ? setup->unit : "";
    int exponent = tick_exponent(setup->range), n = abs(exponent);
    char power[40] = "";
    if (exponent)
        snprintf(power, sizeof power, "10%s%s%s%s%s", exponent < 0 ? "\u207b" : "",
                 n >= 100 ? digits[n / 100 % 10] : "", n >= 10 ? digits[n / 10 % 10] : "",
                 digits[n % 10], *unit ? " " : "");
    if (*unit || exponent)
        snprintf(text, size, "%s (%s%s)", label, power, unit);
    else
        snprintf(text, size, "%s", label);
}

struct bar {
    double x, y, width, height; /* pixels */
    const double *range;
};

static void bar_fill(const struct overlay *o, cairo_t *cr, const struct bar *bar,
                     const struct render_map *map)
{
    uint8_t rgb[MAP_SIZE][3];
    cairo_pattern_t *gradient = cairo_pattern_create_linear(0, bar->y + bar->height, 0, bar->y);
    map->fill(rgb);
    for (int i = 0; i < MAP_SIZE; i++)
        cairo_pattern_add_color_stop_rgb(gradient, i / (MAP_SIZE - 1.0), rgb[i][0] / 255.0,
                                         rgb[i][1] / 255.0, rgb[i][2] / 255.0);
    cairo_rectangle(cr, bar->x, bar->y, bar->width, bar->height);
    cairo_set_source(cr, gradient);
    cairo_fill_preserve(cr);
    cairo_pattern_destroy(gradient);
    cairo_set_source_rgba(cr, o->ink, o->ink, o->ink, 0.6);
    cairo_set_line_width(cr, fmax(1, o->size / 16));
    cairo_stroke(cr);
}

/* Calls for each tick; draws it, or only measures when `draw` is false. Returns the widest text. */
static double bar_ticks(const struct overlay *o, cairo_t *cr, const struct bar *bar, bool draw)
{
    double low = bar->range[0], high = bar->range[1], span = high - low, widest = 0;
    int most = (int)fmin(TICK_MAX - 1, fmax(1, bar->height / (2.2 * o->size)));
    double step = tick_step(span, most);
    int exponent = tick_exponent(bar->range);
    double first = ceil(low / step - 1e-9);
    for (int i = 0; i <= TICK_MAX && (first + i) * step <= high + 1e-9 * span; i++) {
        double value = (first + i) * step;
        double y = bar->y + bar->height * (high - value) / span;
        char text[64];
        tick_text(text, sizeof text, value, step, exponent);
        widest = fmax(widest, text_width(cr, text));
        if (!draw)
            continue;
        cairo_set_source_rgba(cr, o->ink, o->ink, o->ink, 0.8);
        cairo_set_line_width(cr, fmax(1, o->size / 16));
        cairo_move_to(cr, bar->x + bar->width, y);
        cairo_rel_line_to(cr, o->size * 0.3, 0);
        cairo_stroke(cr);
        text_draw(o, cr, bar->x + bar->width + o->size * 0.5, y + o->size * 0.36, text);
    }
    return widest;
}

/* A vertical bar at the right edge, ticks to its right, name and unit above. */
static void bar_draw(const struct overlay *o, const struct render_setup *setup, cairo_t *cr,
                     const struct scene *scene)
{
    const struct variant *row = variant_find(&render_maps, scene->color.map);
    double width = scene->movie.size[0], height = scene->movie.size[1], edge = o->size * 1.2;
    struct bar bar = {.width = floor(o->size * 0.9), .height = floor(height * 0.42),
                      .range = setup->range};
    bool ticks = setup->range[1] > setup->range[0] && isfinite(setup->range[1] - setup->range[0]);
    double widest = ticks ? bar_ticks(o, cr, &bar, false) : 0;
    char name[300];
    bar_name(name, sizeof name, setup);
    bar.x = floor(width - edge - widest - o->size * 0.5 - bar.width) + 0.5;
    bar.y = floor((height - bar.height) / 2) + 0.5;
    bar_fill(o, cr, &bar, (const struct render_map *)(row ? row : render_maps.rows[0]));
    if (ticks)
        bar_ticks(o, cr, &bar, true);
    text_draw(o, cr, fmax(0, fmin(bar.x, width - edge - text_width(cr, name))),
              bar.y - o->size * 0.75, name);
}

static void title_draw(const struct overlay *o, const struct scene *scene)
{
    double size = o->size * 1.35;
    cairo_t *cr = painter(o->still, size);
    double free_width = scene->movie.size[0] - 2.4 * o->size, width = text_width(cr, scene->title);
    if (width > free_width) { /* a long title shrinks rather than being cut */
        size *= free_width / width;
        cairo_set_font_size(cr, size);
    }
    if (size >= TEXT_HEIGHT_MIN)
        text_draw(o, cr, o->size * 1.2, o->size * 1.1 + size * 0.76, scene->title);
    cairo_destroy(cr);
}

static enum status still_make(struct overlay *o, const struct render_setup *setup,
                              struct error *e)
{
    const struct scene *scene = setup->scene;
    o->still = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, scene->movie.size[0],
                                          scene->movie.size[1]);
    if (scene->render.time)
        o->stamp = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, (int)ceil(o->size * 12),
                                              (int)ceil(o->size * 1.7));
    if (cairo_surface_status(o->still) != CAIRO_STATUS_SUCCESS ||
        (o->stamp && cairo_surface_status(o->stamp) != CAIRO_STATUS_SUCCESS))
        return error_set(e, STATUS_RUN, "no memory for the text over the picture");
    if (scene->render.title && scene->title[0])
        title_draw(o, scene);
    if (scene->color.legend && !setup->solid) {
        cairo_t *cr = painter(o->still, o->size);
        bar_draw(o, setup, cr, scene);
        cairo_destroy(cr);
    }
    cairo_surface_flush(o->still);
    return STATUS_OK;
}

enum status overlay_open(struct overlay **overlay, const struct render_setup *setup,
                         struct error *e)
{
    const struct scene *scene = setup->scene;
    const double *back = scene->render.background;
    double size = camera_text_size(scene);
    double interval = scene->movie.speed / scene->movie.fps;
    bool wanted = scene->render.time || (scene->render.title && scene->title[0]) ||
                  (scene->color.legend && !setup->solid);
    struct overlay *o;
    enum status status;
    *overlay = NULL;
    if (!wanted || size == 0)
        return STATUS_OK;
    o = calloc(1, sizeof *o);
    if (!o)
        return error_set(e, STATUS_RUN, "out of memory");
    o->size = size;
    o->background = back;
    o->ink = back[0] * 0.30 + back[1] * 0.59 + back[2] * 0.11 > 0.5 ? 0 : 1;
    o->decimals = interval > 0 ? (int)fmin(6, fmax(1, ceil(-log10(interval)))) : 3;
    status = still_make(o, setup, e);
    if (status != STATUS_OK) {
        overlay_close(o);
        o = NULL;
    }
    *overlay = o;
    return status;
}

/* Puts a premultiplied ARGB surface over RGBA pixels, its upper left at (left, top). */
static void blend(cairo_surface_t *surface, int left, int top, struct image *image)
{
    int width = cairo_image_surface_get_width(surface);
    int height = cairo_image_surface_get_height(surface);
    int stride = cairo_image_surface_get_stride(surface);
    const unsigned char *data = cairo_image_surface_get_data(surface);
    width = width < image->width - left ? width : image->width - left;
    height = height < image->height - top ? height : image->height - top;
    for (int y = 0; y < height; y++) {
        size_t first = (size_t)(y + top) * (size_t)image->width + (size_t)left;
        uint8_t *pixel = image->rgba + first * 4;
        for (int x = 0; x < width; x++, pixel += 4) {
            uint32_t argb;
            memcpy(&argb, data + (size_t)y * (size_t)stride + (size_t)x * 4, sizeof argb);
            if (argb >> 24 == 0)
                continue;
            for (int k = 0; k < 3; k++)
                pixel[k] = (uint8_t)((argb >> (16 - 8 * k) & 255) +
                                     (pixel[k] * (255 - (argb >> 24)) + 127) / 255);
        }
    }
}

void overlay_draw(struct overlay *o, double time, struct image *image)
{
    if (!o)
        return;
    blend(o->still, 0, 0, image);
    if (o->stamp) {
        char text[64];
        cairo_t *cr = painter(o->stamp, o->size);
        cairo_set_operator(cr, CAIRO_OPERATOR_CLEAR);
        cairo_paint(cr);
        cairo_set_operator(cr, CAIRO_OPERATOR_OVER);
        snprintf(text, sizeof text, "t = %.*f s", o->decimals, time);
        text_draw(o, cr, o->size * 0.2, o->size * 1.2, text);
        cairo_destroy(cr);
        cairo_surface_flush(o->stamp);
        blend(o->stamp, (int)o->size, image->height - (int)(o->size * 2.4), image);
    }
}

void overlay_close(struct overlay *o)
{
    if (!o)
        return;
    if (o->still)
        cairo_surface_destroy(o->still);
    if (o->stamp)
        cairo_surface_destroy(o->stamp);
    free(o);
}

#define MISSING NULL
#else

#include "base/log.h"

enum status overlay_open(struct overlay **overlay, const struct render_setup *setup,
                         struct error *e)
{
    const struct scene *scene = setup->scene;
    (void)e;
    if (scene->color.legend || scene->render.time || scene->render.title)
        log_info("frames come without title, time and colour bar: this build has no cairo (make "
                 "CAIRO=1, Debian package libcairo2-dev)");
    *overlay = NULL;
    return STATUS_OK;
}

void overlay_draw(struct overlay *overlay, double time, struct image *image)
{
    (void)overlay;
    (void)time;
    (void)image;
}

void overlay_close(struct overlay *overlay)
{
    (void)overlay;
}

#define MISSING "build with make CAIRO=1 (Debian package libcairo2-dev); frames come without text"
#endif

static const struct variant text_row = {
    .name = "text", .doc = "colour bar, title and time stamp by cairo", .missing = MISSING};
static const struct variant *const rows[] = {&text_row};

const struct variant_table render_overlays = {
    .name = "overlays",
    .doc = "what is written over frames (color.legend, render.time, render.title)",
    .rows = rows,
    .count = sizeof rows / sizeof rows[0],
};
