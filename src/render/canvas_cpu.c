/* The renderer that needs no OpenGL: spheres into tiles, by all processors (render/splat.h). */
#include "render/balls.h"
#include "render/canvas.h"
#include "render/sampling.h"
#include "render/surface.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct canvas {
    struct render_setup setup;
    struct sampling grid;
    struct blends back;     /* seen through a fluid */
    const struct splat_isa *isa;
    struct balls balls;
    struct tile *tiles;     /* of each thread */
    struct surface surface; /* of style surface */
    bool has_surface;
    char name[64];
};

static void canvas_close(void *canvas)
{
    struct canvas *c = canvas;
    if (!c)
        return;
    balls_free(&c->balls);
    sampling_close(&c->grid);
    blends_free(&c->back);
    surface_close(&c->surface);
    free(c->tiles);
    free(c);
}

static enum status room_make(struct canvas *c, struct error *e)
{
    const struct sampling *g = &c->grid;
    c->tiles = aligned_alloc(64, (size_t)g->threads * sizeof *c->tiles);
    bool ok = !c->has_surface || surface_open(&c->surface, g->width, g->height, !c->setup.solid);
    if (!ok || !c->tiles)
        return error_set(e, STATUS_RUN, "out of memory for the picture");
    return STATUS_OK;
}

static enum status canvas_open(void **canvas, const struct canvas_row *row,
                               const struct render_setup *setup, struct error *e)
{
    struct canvas *c = calloc(1, sizeof *c);
    (void)row;
    *canvas = NULL;
    if (!c)
        return error_set(e, STATUS_RUN, "out of memory");
    c->setup = *setup;
    c->has_surface = strcmp(setup->scene->render.style, "surface") == 0;
    c->isa = splat_isa_find(setup->isa);
    if (sampling_open(&c->grid, &c->setup, "cpu", e) || room_make(c, e)) {
        canvas_close(c);
        return e->status;
    }
    snprintf(c->name, sizeof c->name, "cpu (%s, %d thread%s)", c->isa->name, c->grid.threads,
             c->grid.threads == 1 ? "" : "s");
    *canvas = c;
    return STATUS_OK;
}

/* Tile i of the picture, without its contents. */
static struct tile *tile_of(struct canvas *c, int i)
{
    const struct bins *bins = &c->balls.bins;
    struct tile *tile = &c->tiles[omp_get_thread_num()];
    tile->left = i % bins->columns * bins->tile;
    tile->top = i / bins->columns * bins->tile;
    tile->width = c->grid.width - tile->left < bins->tile ? c->grid.width - tile->left : bins->tile;
    tile->height = c->grid.height - tile->top < bins->tile ? c->grid.height - tile->top : bins->tile;
    return tile;
}

/* What each pixel of a filled tile shows: the nearest of its samples. */
static void raw_keep(const struct canvas *c, const struct render_frame *frame, const struct tile *tile,
                     struct image *image)
{
    const int n = c->grid.samples;
    for (int y = 0; y < tile->height / n; y++)
        for (int x = 0; x < tile->width / n; x++) {
            float depth = INFINITY;
            uint32_t ball = UINT32_MAX;
            for (int j = 0; j < n * n; j++) {
                int row = y * n + j / n, column = x * n + j % n;
                if (tile->depth[row][column] < depth) {
                    depth = tile->depth[row][column];
                    ball = tile->ball[row][column];
                }
            }
            sampling_raw(frame, depth, ball,
                         image->raw + RAW_PLANES * ((size_t)(tile->top / n + y) * (size_t)image->width +
                                                    (size_t)(tile->left / n + x)));
        }
}

/* Finds what tile i shows; returns the spheres that may cover it. */
static struct ball_list tile_find(struct canvas *c, int i, const struct splat *splat,
                                  const struct render_frame *frame, struct tile *tile,
                                  struct image *image)
{
    const struct ball_list list = balls_of_tile(&c->balls, i);
    c->isa->fill(splat, tile, &list);
    if (image->raw)
        raw_keep(c, frame, tile, image);
    return list;
}

static void spheres_draw(struct canvas *c, const struct splat *splat, const struct render_frame *frame,
                         struct image *image)
{
    const int count = c->balls.bins.columns * c->balls.bins.rows;
#pragma omp parallel for schedule(dynamic, 1) num_threads(c->grid.threads)
    for (int i = 0; i < count; i++) {
        struct tile *tile = tile_of(c, i);
        tile_find(c, i, splat, frame, tile, image);
        c->isa->shade(splat, tile);
        c->isa->finish(splat, tile);
    }
}

static void surface_smooth_all(struct canvas *c, size_t step)
{
    struct surface *f = &c->surface;
#pragma omp parallel for schedule(dynamic, 8) num_threads(c->grid.threads)
    for (int y = 0; y < f->height; y++)
        c->isa->surface->smooth(f, y, step);
    float *depth = f->depth;
    f->depth = f->other;
    f->other = depth;
}

static void surface_soften_all(struct canvas *c, size_t step)
{
    struct surface *f = &c->surface;
#pragma omp parallel for schedule(dynamic, 8) num_threads(c->grid.threads)
    for (int y = 0; y < f->height; y++)
        c->isa->surface->soften(f, y, step);
    float *thickness = f->thickness;
    f->thickness = f->other;
    f->other = thickness;
}

enum { SURFACE_ROUNDS = 3 };

static void surface_draw(struct canvas *c, const struct splat *splat, const struct render_frame *frame,
                         struct image *image)
{
    const int count = c->balls.bins.columns * c->balls.bins.rows;
    struct surface *f = &c->surface;
#pragma omp parallel for schedule(dynamic, 1) num_threads(c->grid.threads)
    for (int i = 0; i < count; i++) {
        struct tile *tile = tile_of(c, i);
        const struct ball_list list = tile_find(c, i, splat, frame, tile, image);
        c->isa->surface->keep(f, tile);
        if (!f->opaque)
            c->isa->surface->thicken(splat, f, tile, &list);
        if (f->back_count)
            c->isa->surface->behind(splat, f, tile);
    }
    for (int round = 0; round < SURFACE_ROUNDS; round++) {
        surface_smooth_all(c, 1);
        surface_smooth_all(c, f->pitch);
    }
    if (!f->opaque) {
        surface_soften_all(c, 1);
        surface_soften_all(c, f->pitch);
    }
#pragma omp parallel for schedule(dynamic, 1) num_threads(c->grid.threads)
    for (int i = 0; i < count; i++) {
        struct tile *tile = tile_of(c, i);
        c->isa->surface->shade(splat, f, tile);
        c->isa->finish(splat, tile);
    }
}

/* Triangles of the domain; none where it is not shown. */
static enum status domain_make(struct canvas *c, const struct camera *camera,
                               const struct render_frame *frame, struct error *e)
{
    struct sampling *g = &c->grid;
    if (!wire_wanted(c->setup.scene))
        return STATUS_OK;
    if (sampling_wire(g, camera, frame, e))
        return e->status;
    const bool through = c->has_surface && !c->surface.opaque;
    if (blends_make(&g->blends, &g->wire, through ? BLEND_OVER : BLEND_ALL, g->width, g->height, e))
        return e->status;
    if (through && blends_make(&c->back, &g->wire, BLEND_BACK, g->width, g->height, e))
        return e->status;
    c->surface.back = c->back.blend;
    c->surface.back_count = c->back.count;
    return STATUS_OK;
}

enum { SURFACE_LENGTHS = 16 }; /* light decays by e in this part of the domain's largest side */

/* Spheres of a surface overlap: they are larger than those that are drawn as such. */
static double surface_prepare(struct canvas *c, const struct camera *camera)
{
    const struct scene *scene = c->setup.scene;
    double radius = 1.7 * c->setup.radius, side = 0;
    for (int a = 0; a < 3; a++)
        side = fmax(side, scene->domain.max[a] - scene->domain.min[a]);
    surface_scale(&c->surface, radius, scene->particles.spacing, c->grid.height / 2.0 / camera_half_y(camera));
    c->surface.parallel = camera->orthographic;
    c->surface.clarity = (float)(side / SURFACE_LENGTHS);
    surface_view(&c->surface, camera, scene);
    return radius;
}

static enum status canvas_draw(void *canvas, const struct camera *camera,
                               const struct render_frame *frame, struct image *image, struct error *e)
{
    struct canvas *c = canvas;
    struct sampling *g = &c->grid;
    const double radius = c->has_surface ? surface_prepare(c, camera) : c->setup.radius;
    struct splat splat = sampling_splat(g, camera, radius, image);
    struct ball_view view = {.from = sampling_viewpoint(g, camera, radius), .loops = c->isa->project,
                             .tile = g->tile, .threads = g->threads, .setup = &c->setup, .map = g->map};
    sampling_rays(g, camera);
    if (balls_make(&c->balls, &view, frame, e))
        return e->status;
    splat.balls = c->balls.ball;
    if (domain_make(c, camera, frame, e))
        return e->status;
    splat.blends = g->blends.blend;
    splat.blend_count = g->blends.count;
    if (c->has_surface)
        surface_draw(c, &splat, frame, image);
    else
        spheres_draw(c, &splat, frame, image);
    return STATUS_OK;
}

static const char *canvas_name(const void *canvas)
{
    return ((const struct canvas *)canvas)->name;
}

static bool canvas_software(const void *canvas)
{
    (void)canvas;
    return false; /* it is made for processors */
}

const struct canvas_row canvas_cpu = {
    .variant = {.name = "cpu", .doc = "spheres by all processors, without OpenGL; the same bits everywhere"},
    .open = canvas_open,
    .draw = canvas_draw,
    .name = canvas_name,
    .software = canvas_software,
    .close = canvas_close,
};
