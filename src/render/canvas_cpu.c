/* The renderer that needs no OpenGL: spheres into tiles, by all processors (render/splat.h). */
#include "render/balls.h"
#include "render/blend.h"
#include "render/camera.h"
#include "render/canvas.h"
#include "render/surface.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct canvas {
    struct render_setup setup;
    struct wire wire;     /* the domain, and its triangles */
    struct blends blends, back; /* back: seen through a fluid */
    const struct splat_isa *isa;
    int threads, samples; /* samples per pixel, in x and in y */
    int width, height;    /* samples */
    float *ray_x, *ray_y; /* of each column and row */
    struct balls balls;
    struct tile *tiles;   /* of each thread */
    uint32_t map[MAP_SIZE]; /* the palette, red in the lowest byte */
    struct surface surface; /* of style surface */
    bool has_surface;
    char name[64];
};

enum { MOST_SAMPLES = 65535 }; /* of width or height: struct ball has 16 bits */

/* The instruction set asked for, or the best that the processor has. */
static const struct splat_isa *isa_find(const char *name)
{
    static const struct splat_isa *const rows[] = {&splat_avx512, &splat_avx2, &splat_scalar};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (name && strcmp(name, rows[i]->name) == 0)
            return rows[i];
    for (size_t i = 0;; i++)
        if (rows[i]->supported())
            return rows[i];
}

static void canvas_close(void *canvas)
{
    struct canvas *c = canvas;
    if (!c)
        return;
    balls_free(&c->balls);
    wire_free(&c->wire);
    blends_free(&c->blends);
    blends_free(&c->back);
    surface_close(&c->surface);
    free(c->ray_x);
    free(c->ray_y);
    free(c->tiles);
    free(c);
}

static enum status room_make(struct canvas *c, struct error *e)
{
    size_t width = (size_t)c->width + TILE, height = (size_t)c->height + TILE;
    c->ray_x = calloc(width, sizeof *c->ray_x);
    c->ray_y = calloc(height, sizeof *c->ray_y);
    c->tiles = aligned_alloc(64, (size_t)c->threads * sizeof *c->tiles);
    bool ok = !c->has_surface || surface_open(&c->surface, c->width, c->height, !c->setup.solid);
    if (!ok || !c->ray_x || !c->ray_y || !c->tiles)
        return error_set(e, STATUS_RUN, "out of memory for the picture");
    return STATUS_OK;
}

static enum status canvas_open(void **canvas, const struct canvas_row *row,
                               const struct render_setup *setup, struct error *e)
{
    const int *size = setup->scene->movie.size;
    struct canvas *c = calloc(1, sizeof *c);
    (void)row;
    *canvas = NULL;
    if (!c)
        return error_set(e, STATUS_RUN, "out of memory");
    c->setup = *setup;
    c->has_surface = strcmp(setup->scene->render.style, "surface") == 0;
    c->isa = isa_find(setup->isa);
    c->threads = setup->threads > 0 ? setup->threads : omp_get_num_procs();
    c->samples = (int)setup->scene->render.samples;
    c->samples = c->samples < 1 ? 1 : c->samples;
    const int most = MOST_SAMPLES / c->samples;
    if (size[0] < 1 || size[1] < 1 || size[0] > most || size[1] > most) {
        canvas_close(c);
        return error_set(e, STATUS_BACKEND, "a picture of %d x %d pixels cannot be drawn: cpu draws up to "
                         "%d x %d; choose another --size", size[0], size[1], most, most);
    }
    c->width = size[0] * c->samples;
    c->height = size[1] * c->samples;
    snprintf(c->name, sizeof c->name, "cpu (%s, %d thread%s)", c->isa->name, c->threads,
             c->threads == 1 ? "" : "s");
    for (int i = 0; i < MAP_SIZE; i++)
        c->map[i] = setup->palette[i][0] | (uint32_t)setup->palette[i][1] << 8 |
                    (uint32_t)setup->palette[i][2] << 16;
    if (room_make(c, e)) {
        canvas_close(c);
        return e->status;
    }
    *canvas = c;
    return STATUS_OK;
}

/* Ray directions at the samples' middles; where rays are parallel, their places. */
static void rays_make(struct canvas *c, const struct camera *camera)
{
    for (int x = 0; x < c->width; x++)
        c->ray_x[x] = (float)(((x + 0.5) / c->width * 2 - 1) * camera_half_x(camera));
    for (int y = 0; y < c->height; y++)
        c->ray_y[y] = (float)((1 - (y + 0.5) / c->height * 2) * camera_half_y(camera));
}

/* Tile i of the picture, without its contents. */
static struct tile *tile_of(struct canvas *c, int i)
{
    const struct bins *bins = &c->balls.bins;
    struct tile *tile = &c->tiles[omp_get_thread_num()];
    tile->left = i % bins->columns * bins->tile;
    tile->top = i / bins->columns * bins->tile;
    tile->width = c->width - tile->left < bins->tile ? c->width - tile->left : bins->tile;
    tile->height = c->height - tile->top < bins->tile ? c->height - tile->top : bins->tile;
    return tile;
}

/* What each pixel of a filled tile shows: the nearest of its samples. */
static void raw_keep(const struct canvas *c, const struct render_frame *frame, const struct tile *tile,
                     struct image *image)
{
    const int n = c->samples;
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
            float *raw = image->raw + RAW_PLANES * ((size_t)(tile->top / n + y) * (size_t)image->width +
                                                    (size_t)(tile->left / n + x));
            raw[RAW_DEPTH] = depth;
            raw[RAW_VALUE] = ball == UINT32_MAX || !frame->value ? NAN : frame->value[ball];
            raw[RAW_ID] = ball == UINT32_MAX ? -1 : (float)ball;
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
#pragma omp parallel for schedule(dynamic, 1) num_threads(c->threads)
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
#pragma omp parallel for schedule(dynamic, 8) num_threads(c->threads)
    for (int y = 0; y < f->height; y++)
        c->isa->surface->smooth(f, y, step);
    float *depth = f->depth;
    f->depth = f->other;
    f->other = depth;
}

static void surface_soften_all(struct canvas *c, size_t step)
{
    struct surface *f = &c->surface;
#pragma omp parallel for schedule(dynamic, 8) num_threads(c->threads)
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
#pragma omp parallel for schedule(dynamic, 1) num_threads(c->threads)
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
#pragma omp parallel for schedule(dynamic, 1) num_threads(c->threads)
    for (int i = 0; i < count; i++) {
        struct tile *tile = tile_of(c, i);
        c->isa->surface->shade(splat, f, tile);
        c->isa->finish(splat, tile);
    }
}

static double far_distance(const struct canvas *c, const struct camera *camera)
{
    double far = 0;
    for (int i = 0; i < 8; i++) {
        double corner[3], view[3];
        camera_corner(c->setup.scene, i, c->setup.radius, corner);
        camera_view(camera, corner, view);
        far = fmax(far, view[2]);
    }
    return far > 0 ? far : 1;
}

static void background_make(const struct canvas *c, struct splat *splat)
{
    const struct scene *scene = c->setup.scene;
    splat->planes = scene->render.transparent ? 4 : 3;
    for (int k = 0; k < 3 && !scene->render.transparent; k++) {
        double low = scene->render.background[k], high = scene->render.background_top[k];
        high = isnan(high) ? low : high;
        splat->back[k] = (float)high;
        splat->fade[k] = (float)((low - high) / c->height);
    }
}

/* Triangles of the domain; none where it is not shown. */
static enum status domain_make(struct canvas *c, const struct camera *camera,
                               const struct render_frame *frame, struct error *e)
{
    const struct scene *scene = c->setup.scene;
    if (!wire_wanted(scene))
        return STATUS_OK;
    const struct wire_view view = {scene, camera, frame, far_distance(c, camera), c->samples, c->threads};
    if (wire_make(&c->wire, &view, e))
        return e->status;
    const bool through = c->has_surface && !c->surface.opaque;
    if (blends_make(&c->blends, &c->wire, through ? BLEND_OVER : BLEND_ALL, c->width, c->height, e))
        return e->status;
    if (through && blends_make(&c->back, &c->wire, BLEND_BACK, c->width, c->height, e))
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
    surface_scale(&c->surface, radius, scene->particles.spacing, c->height / 2.0 / camera_half_y(camera));
    c->surface.parallel = camera->orthographic;
    c->surface.clarity = (float)(side / SURFACE_LENGTHS);
    surface_view(&c->surface, camera, scene);
    return radius;
}

static struct viewpoint viewpoint_make(const struct canvas *c, const struct camera *camera, double radius)
{
    struct viewpoint v = {.half = {(float)(c->width / 2.0 / camera_half_x(camera)),
                                   (float)(-c->height / 2.0 / camera_half_y(camera))},
                          .size = {c->width, c->height}, .radius = (float)radius,
                          .lens = camera->orthographic ? 0 : 1};
    memcpy(v.eye, camera->eye, sizeof v.eye);
    memcpy(v.axis[0], camera->right, sizeof v.axis[0]);
    memcpy(v.axis[1], camera->up, sizeof v.axis[1]);
    memcpy(v.axis[2], camera->forward, sizeof v.axis[2]);
    return v;
}

static enum status canvas_draw(void *canvas, const struct camera *camera,
                               const struct render_frame *frame, struct image *image, struct error *e)
{
    struct canvas *c = canvas;
    const struct scene *scene = c->setup.scene;
    const double radius = c->has_surface ? surface_prepare(c, camera) : c->setup.radius;
    struct splat splat = {.ray_x = c->ray_x, .ray_y = c->ray_y, 
                          .lens = camera->orthographic ? 0 : 1, .radius = (float)radius,
                          .look = look_make(scene->render.outline),
                          .samples = c->samples, .rgba = image->rgba,
                          .pitch = (size_t)image->width};
    struct ball_view view = {.from = viewpoint_make(c, camera, radius), .loops = c->isa->project,
                             .tile = TILE / c->samples * c->samples,
                             .threads = c->threads, .setup = &c->setup, .map = c->map};
    background_make(c, &splat);
    rays_make(c, camera);
    if (balls_make(&c->balls, &view, frame, e))
        return e->status;
    splat.balls = c->balls.ball;
    if (domain_make(c, camera, frame, e))
        return e->status;
    splat.blends = c->blends.blend;
    splat.blend_count = c->blends.count;
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
