/* What is written over a frame: places of its parts, those that change, and blending. */
#include "render/overlay.h"

#include "base/log.h"

#if HAVE_CAIRO

#include "render/camera.h"
#include "render/layout.h"
#include "render/legend.h"
#include "render/marks.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT_HEIGHT_MIN = 8 /* pixels; smaller is not legible */ };

/* What is drawn anew for each frame. */
enum part { PART_LEGEND, PART_TIME, PART_AXES, PART_BAR, PART_COUNT };

struct overlay {
    const struct render_setup *setup;
    struct ink ink;
    struct layout layout;
    cairo_surface_t *still; /* of the picture's size; NULL: drawn anew, too */
    struct {
        bool wanted;
        struct layout_box box;
        cairo_surface_t *surface; /* of the box; NULL without `still` */
    } parts[PART_COUNT];
    int decimals; /* of the time stamp */
};

static double text_height(double size)
{
    return size * 1.25; /* baseline at 1.0 */
}

static void time_text(const struct overlay *o, double time, char text[64])
{
    snprintf(text, 64, "t = %.*f s", o->decimals, time);
}

static enum status surface_create(int width, int height, cairo_surface_t **surface, struct error *e)
{
    *surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
    if (cairo_surface_status(*surface) != CAIRO_STATUS_SUCCESS)
        return error_set(e, STATUS_RUN, "no memory for the text over the picture");
    return STATUS_OK;
}

/* Notes where a part that changes lies. */
static void part_want(struct overlay *o, enum part part, const struct layout_box *box)
{
    double margin = ceil(o->ink.size * 0.2); /* of halos */
    struct layout_box *own = &o->parts[part].box;
    own->x = fmax(0, floor(box->x - margin));
    own->y = fmax(0, floor(box->y - margin));
    own->width = ceil(box->x + box->width + margin) - own->x;
    own->height = ceil(box->y + box->height + margin) - own->y;
    o->parts[part].wanted = true;
}

/* Places a part that changes; one without room is left out. */
static void part_place(struct overlay *o, enum part part, enum label_place at, double width,
                       double height)
{
    struct layout_box box;
    if (layout_place(&o->layout, at, width, height, &box))
        part_want(o, part, &box);
}

/* A text too wide for the picture shrinks rather than being cut. */
static void label_draw(struct overlay *o, cairo_t *cr, enum label_place at, double size,
                       const char *text)
{
    cairo_save(cr);
    cairo_set_font_size(cr, size);
    double room = o->layout.width - 2 * o->layout.side, width = ink_width(cr, text);
    struct layout_box box;
    if (width > room) {
        size *= room / width;
        cairo_set_font_size(cr, size);
        width = room;
    }
    if (size >= TEXT_HEIGHT_MIN && layout_place(&o->layout, at, width, text_height(size), &box))
        ink_text(&o->ink, cr, box.x, box.y + size, text);
    else if (o->still) /* said once */
        log_info("no room for the text \"%s\"", text);
    cairo_restore(cr);
}

static void legend_place(struct overlay *o, cairo_t *cr)
{
    const struct render_setup *setup = o->setup;
    bool still = isnan(setup->scene->color.percentiles[0]);
    struct layout_box box;
    if (!setup->scene->color.legend || setup->solid)
        return;
    if (still) {
        legend_draw(&o->ink, setup, &setup->scale, true, cr, &box);
    } else { /* anywhere at the right edge */
        box = (struct layout_box){floor(o->layout.width * 0.6), o->layout.height * 0.2, 0, 0};
        box.width = o->layout.width - box.x;
        box.height = o->layout.height * 0.6;
        part_want(o, PART_LEGEND, &box);
    }
    layout_take(&o->layout, &box);
}

static void parts_place(struct overlay *o, cairo_t *cr)
{
    const struct scene *scene = o->setup->scene;
    double width, height, axes = marks_axes_size(&o->ink);
    char text[64];
    time_text(o, scene->time.end, text);
    if (scene->render.time)
        part_place(o, PART_TIME, LABEL_BOTTOM_LEFT, ink_width(cr, text), text_height(o->ink.size));
    if (scene->render.axes)
        part_place(o, PART_AXES, LABEL_BOTTOM_LEFT, axes, axes);
    marks_bar_size(&o->ink, scene, cr, &width, &height);
    if (scene->render.scale_bar)
        part_place(o, PART_BAR, LABEL_BOTTOM_RIGHT, width, height);
}

/* Places all parts, and draws those that stay the same. */
static void all_place(struct overlay *o, cairo_t *cr)
{
    const struct scene *scene = o->setup->scene;
    legend_place(o, cr);
    if (scene->render.title && scene->title[0])
        label_draw(o, cr, LABEL_TOP_LEFT, o->ink.size * 1.35, scene->title);
    parts_place(o, cr);
    for (size_t i = 0; i < scene->label_count; i++)
        label_draw(o, cr, scene->labels[i].at, o->ink.size * scene->labels[i].size,
                   scene->labels[i].text);
}

/* Surfaces, and what stays the same on them. */
static enum status all_open(struct overlay *o, struct error *e)
{
    const int *size = o->setup->scene->movie.size;
    if (surface_create(size[0], size[1], &o->still, e))
        return e->status;
    cairo_t *cr = ink_painter(o->still, o->ink.size);
    all_place(o, cr);
    cairo_destroy(cr);
    cairo_surface_flush(o->still);
    for (int k = 0; k < PART_COUNT; k++) {
        const struct layout_box *box = &o->parts[k].box;
        if (o->parts[k].wanted &&
            surface_create((int)box->width, (int)box->height, &o->parts[k].surface, e))
            return e->status;
    }
    return STATUS_OK;
}

static bool is_wanted(const struct render_setup *setup)
{
    const struct scene *scene = setup->scene;
    return scene->render.time || scene->render.axes || scene->render.scale_bar ||
           scene->label_count || (scene->render.title && scene->title[0]) ||
           (scene->color.legend && !setup->solid);
}

/* False when nothing is to be written. */
static bool overlay_make(struct overlay *o, const struct render_setup *setup)
{
    const struct scene *scene = setup->scene;
    const double *back = scene->render.background;
    double size = camera_text_size(scene), interval = scene->movie.speed / scene->movie.fps;
    memset(o, 0, sizeof *o);
    o->setup = setup;
    o->ink = (struct ink){size, back[0] * 0.30 + back[1] * 0.59 + back[2] * 0.11 > 0.5 ? 0 : 1, back};
    o->layout = (struct layout){.width = scene->movie.size[0], .height = scene->movie.size[1],
                                .side = size * 1.2, .end = size * 0.95, .gap = size * 0.4};
    o->decimals = interval > 0 ? (int)fmin(6, fmax(1, ceil(-log10(interval)))) : 3;
    return is_wanted(setup) && size > 0;
}

enum status overlay_open(struct overlay **overlay, const struct render_setup *setup,
                         struct error *e)
{
    struct overlay made, *o;
    *overlay = NULL;
    if (!overlay_make(&made, setup))
        return STATUS_OK;
    o = malloc(sizeof *o);
    if (!o)
        return error_set(e, STATUS_RUN, "out of memory");
    *o = made;
    if (all_open(o, e)) {
        overlay_close(o);
        return e->status;
    }
    *overlay = o;
    return STATUS_OK;
}

/* Puts a premultiplied ARGB pixel over an RGBA pixel, whose colours are not multiplied. */
static void pixel_blend(uint32_t argb, uint8_t *pixel)
{
    uint32_t own = argb >> 24, under = pixel[3] * (255 - own), alpha = 255 * own + under; /* of 255^2 */
    for (int k = 0; k < 3; k++) {
        uint32_t color = argb >> (16 - 8 * k) & 255;
        if (pixel[3] == 255)
            pixel[k] = (uint8_t)(color + (pixel[k] * (255 - own) + 127) / 255);
        else
            pixel[k] = (uint8_t)((255 * (255 * color) + pixel[k] * under + alpha / 2) / alpha);
    }
    pixel[3] = (uint8_t)((alpha + 127) / 255);
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
            if (argb >> 24)
                pixel_blend(argb, pixel);
        }
    }
}

/* Draws in coordinates of the picture. */
static void part_draw(const struct overlay *o, enum part part, const struct render_frame *frame,
                      const struct camera *camera, cairo_t *cr)
{
    const struct scene *scene = o->setup->scene;
    double margin = ceil(o->ink.size * 0.2);
    struct layout_box box = o->parts[part].box, drawn;
    char text[64];
    box = (struct layout_box){box.x + margin, box.y + margin, box.width - 2 * margin,
                              box.height - 2 * margin};
    switch (part) {
    case PART_LEGEND:
        legend_draw(&o->ink, o->setup, frame->scale ? frame->scale : &o->setup->scale, false, cr,
                    &drawn);
        break;
    case PART_TIME:
        time_text(o, frame->time, text);
        ink_text(&o->ink, cr, box.x, box.y + o->ink.size, text);
        break;
    case PART_AXES: marks_axes_draw(&o->ink, camera, &box, cr); break;
    case PART_BAR: marks_bar_draw(&o->ink, scene, camera, &box, cr); break;
    case PART_COUNT: break;
    }
}

void overlay_draw(struct overlay *o, const struct render_frame *frame, struct image *image)
{
    struct camera camera;
    if (!o)
        return;
    blend(o->still, 0, 0, image);
    camera_make(&camera, o->setup->scene, o->setup->radius, frame->time);
    for (int k = 0; k < PART_COUNT; k++) {
        cairo_surface_t *surface = o->parts[k].surface;
        const struct layout_box *box = &o->parts[k].box;
        if (!surface)
            continue;
        cairo_t *cr = ink_painter(surface, o->ink.size);
        cairo_set_operator(cr, CAIRO_OPERATOR_CLEAR);
        cairo_paint(cr);
        cairo_set_operator(cr, CAIRO_OPERATOR_OVER);
        cairo_translate(cr, -box->x, -box->y);
        part_draw(o, (enum part)k, frame, &camera, cr);
        cairo_destroy(cr);
        cairo_surface_flush(surface);
        blend(surface, (int)box->x, (int)box->y, image);
    }
}

void overlay_record(const struct render_setup *setup, const struct render_frame *frame,
                    struct image *image, int left, int top)
{
    struct camera camera;
    struct overlay o;
    if (!overlay_make(&o, setup))
        return;
    camera_make(&camera, setup->scene, setup->radius, frame->time);
    cairo_t *cr = ink_painter(image->over, o.ink.size);
    cairo_translate(cr, left, top);
    all_place(&o, cr);
    for (int k = 0; k < PART_COUNT; k++)
        if (o.parts[k].wanted)
            part_draw(&o, (enum part)k, frame, &camera, cr);
    cairo_destroy(cr);
}

void overlay_close(struct overlay *o)
{
    if (!o)
        return;
    if (o->still)
        cairo_surface_destroy(o->still);
    for (int k = 0; k < PART_COUNT; k++)
        if (o->parts[k].surface)
            cairo_surface_destroy(o->parts[k].surface);
    free(o);
}

#define MISSING NULL
#else

enum status overlay_open(struct overlay **overlay, const struct render_setup *setup,
                         struct error *e)
{
    const struct scene *scene = setup->scene;
    (void)e;
    if (scene->color.legend || scene->render.time || scene->render.title ||
        scene->render.scale_bar || scene->render.axes || scene->label_count)
        log_info("frames come without text and marks: this build has no cairo (make CAIRO=1, Debian "
                 "package libcairo2-dev)");
    *overlay = NULL;
    return STATUS_OK;
}

void overlay_draw(struct overlay *overlay, const struct render_frame *frame, struct image *image)
{
    (void)overlay;
    (void)frame;
    (void)image;
}

void overlay_record(const struct render_setup *setup, const struct render_frame *frame,
                    struct image *image, int left, int top)
{
    (void)setup;
    (void)frame;
    (void)image;
    (void)left;
    (void)top;
}

void overlay_close(struct overlay *overlay)
{
    (void)overlay;
}

#define MISSING "build with make CAIRO=1 (Debian package libcairo2-dev); frames come without text"
#endif

static const struct variant text_row = {
    .name = "text", .doc = "colour bar, title, time, labels, scale bar and axes by cairo",
    .missing = MISSING};
static const struct variant *const rows[] = {&text_row};

const struct variant_table render_overlays = {
    .name = "overlays",
    .doc = "what is written over frames (color.legend, render.time, title, scale_bar, axes; labels)",
    .rows = rows,
    .count = sizeof rows / sizeof rows[0],
};
