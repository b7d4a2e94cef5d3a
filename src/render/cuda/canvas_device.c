/* Draws spheres on a device of a launch layer: particles are there, or are uploaded slice by slice; kernels are
 * queued, and the domain's triangles made meanwhile; the picture is waited for once, at the end. */
#include "render/cuda/canvas_device.h"

#include "render/balls.h"
#include "render/cuda/draw_kernels.h"
#include "render/sampling.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PIXEL = sizeof(uint32_t) };

/* The same bytes in pinned memory and on the device. */
struct mirror {
    void *host, *device;
    size_t bytes;
};

struct canvas {
    struct render_setup setup;
    struct sampling grid;
    const struct device_row *row;
    const struct kernel *kernels;
    struct device *device;
    const struct splat_isa *isa; /* of colours, which are made here */
    struct occlusion occlusion;
    struct mirror position, rgb, rays, blends, map, pixel;
    void *balls, *mask;          /* on the device */
    size_t ball_bytes, mask_bytes;
    uint64_t *seen, *nearest;    /* nearest: only with setup.raw */
    uint64_t *raw;               /* `nearest`, read back */
    char name[DEVICE_NAME + 16];
};

static size_t samples_of(const struct canvas *c)
{
    return (size_t)c->grid.width * (size_t)c->grid.height;
}

static size_t pixels_of(const struct canvas *c)
{
    return samples_of(c) / (size_t)(c->grid.samples * c->grid.samples);
}

static void mirror_free(struct canvas *c, struct mirror *m)
{
    if (m->host)
        c->row->unpin(c->device, m->host);
    if (m->device)
        c->row->destroy(c->device, m->device);
    *m = (struct mirror){0};
}

/* Makes room, which loses what was there; nothing may be queued. */
static enum status mirror_reserve(struct canvas *c, struct mirror *m, const char *label, size_t bytes,
                                  struct error *e)
{
    if (bytes <= m->bytes)
        return STATUS_OK;
    mirror_free(c, m);
    bytes += bytes / 4;
    m->host = c->row->pin(c->device, bytes, e);
    m->device = m->host ? c->row->create(c->device, label, bytes, e) : NULL;
    m->bytes = m->device ? bytes : 0;
    return m->device ? STATUS_OK : e->status;
}

static void mirror_upload(struct canvas *c, struct mirror *m, size_t from, size_t bytes)
{
    if (bytes > 0)
        c->row->upload(c->device, (char *)m->device + from, (const char *)m->host + from, bytes);
}

/* The same for what is on the device only. */
static enum status room_reserve(struct canvas *c, void **block, size_t *room, const char *label, size_t bytes,
                                struct error *e)
{
    if (bytes <= *room)
        return STATUS_OK;
    if (*block)
        c->row->destroy(c->device, *block);
    *room = 0;
    *block = c->row->create(c->device, label, bytes + bytes / 4, e);
    *room = *block ? bytes + bytes / 4 : 0;
    return *block ? STATUS_OK : e->status;
}

void canvas_device_close(void *canvas)
{
    struct canvas *c = canvas;
    if (!c)
        return;
    if (c->device) {
        void *const blocks[] = {c->balls, c->mask, c->seen, c->nearest};
        mirror_free(c, &c->position);
        mirror_free(c, &c->rgb);
        mirror_free(c, &c->rays);
        mirror_free(c, &c->blends);
        mirror_free(c, &c->map);
        mirror_free(c, &c->pixel);
        for (size_t k = 0; k < sizeof blocks / sizeof *blocks; k++)
            if (blocks[k])
                c->row->destroy(c->device, blocks[k]);
        c->row->close(c->device);
    }
    sampling_close(&c->grid);
    occlusion_free(&c->occlusion);
    free(c->raw);
    free(c);
}

/* What a picture of this size needs. */
static enum status picture_make(struct canvas *c, struct error *e)
{
    const struct sampling *g = &c->grid;
    const size_t rays = ((size_t)g->width + (size_t)g->height) * sizeof(float);
    c->seen = c->row->create(c->device, "samples of the picture", samples_of(c) * sizeof *c->seen, e);
    if (!c->seen || mirror_reserve(c, &c->pixel, "the picture", pixels_of(c) * PIXEL, e) ||
        mirror_reserve(c, &c->rays, "rays", rays, e))
        return e->status;
    if (!c->setup.raw)
        return STATUS_OK;
    c->nearest = c->row->create(c->device, "the picture", pixels_of(c) * sizeof *c->nearest, e);
    c->raw = c->nearest ? malloc(pixels_of(c) * sizeof *c->raw) : NULL;
    if (c->nearest && !c->raw)
        return error_set(e, STATUS_RUN, "out of memory for the picture");
    return c->nearest ? STATUS_OK : e->status;
}

static enum status device_find(struct canvas *c, struct error *e)
{
    const char *why = "";
    struct device_info info;
    if (c->row->count(&why) < 1)
        return error_set(e, STATUS_BACKEND, "there is no GPU that CUDA can use%s%s", *why ? ": " : "", why);
    if (c->row->info(c->setup.device, &info, e) || c->row->open(&c->device, c->setup.device, e))
        return e->status;
    snprintf(c->name, sizeof c->name, "cuda (%s)", info.name);
    return STATUS_OK;
}

enum status canvas_device_open(void **canvas, const struct device_row *device, const struct kernel *kernels,
                               const struct render_setup *setup, struct error *e)
{
    struct canvas *c;
    *canvas = NULL;
    if (strcmp(setup->scene->render.style, "surface") == 0)
        return error_set(e, STATUS_BACKEND, "render.style surface is drawn by --renderer cpu only");
    c = calloc(1, sizeof *c);
    if (!c)
        return error_set(e, STATUS_RUN, "out of memory");
    c->setup = *setup;
    c->row = device;
    c->kernels = kernels;
    c->isa = splat_isa_find(setup->isa);
    if (sampling_open(&c->grid, &c->setup, "cuda", e) || device_find(c, e) || picture_make(c, e)) {
        canvas_device_close(c);
        return e->status;
    }
    *canvas = c;
    return STATUS_OK;
}

enum status canvas_device_share(void *canvas, const struct slots *slots, struct error *e)
{
    struct canvas *c = canvas;
    if (slots->source.row != c->row || slots->source.device != c->setup.device)
        return error_set(e, STATUS_BACKEND, "they are computed by another device");
    if (mirror_reserve(c, &c->map, "colours", sizeof c->grid.map, e))
        return e->status;
    memcpy(c->map.host, c->grid.map, sizeof c->grid.map);
    mirror_upload(c, &c->map, 0, sizeof c->grid.map);
    return STATUS_OK;
}

static void launch(struct canvas *c, enum draw_kernel kernel, size_t threads, const struct draw_work *work)
{
    c->row->launch(c->device, &c->kernels[kernel], threads, work);
}

/* Places and colours of particles first..end - 1 into pinned memory. */
static void slice_pack(struct canvas *c, const struct ball_view *view, const struct render_frame *frame,
                       size_t first, size_t end)
{
    float *position = c->position.host;
    uint32_t *rgb = c->rgb.host;
#pragma omp parallel for schedule(static) num_threads(c->grid.threads)
    for (size_t i = first; i < end; i += CHUNK) {
        struct ball ball[CHUNK] = {{0}};
        const size_t count = end - i < CHUNK ? end - i : CHUNK;
        memcpy(position + 3 * i, frame->position + 3 * i, 3 * count * sizeof *position);
        balls_color(view, &c->occlusion, frame, i, count, ball);
        for (size_t l = 0; l < count; l++)
            memcpy(&rgb[i + l], ball[l].rgb, sizeof *rgb);
    }
}

enum { SLICE = 1 << 17 }; /* particles that are uploaded while the next are packed; a multiple of CHUNK */

/* The frame's particles are on the device, or will be. */
static void particles_follow(struct canvas *c, const struct render_frame *frame, struct draw_work *w)
{
    c->row->follow(c->device, frame->slot->filled);
    w->position = frame->slot->to.position;
    w->word = frame->slot->to.word;
    w->values = !c->setup.solid;
    w->map = c->map.device;
    w->scale = frame->scale ? *frame->scale : c->setup.scale;
}

static enum status particles_upload(struct canvas *c, const struct render_frame *frame, struct draw_work *w,
                                    struct error *e)
{
    const struct scene *scene = c->setup.scene;
    const struct ball_view view = {.loops = c->isa->project, .threads = c->grid.threads, .setup = &c->setup,
                                   .map = c->grid.map};
    const size_t place = 3 * sizeof(float), count = frame->count;
    if (scene->render.occlusion > 0 && occlusion_make(&c->occlusion, scene, frame, c->grid.threads, e))
        return e->status;
    if (mirror_reserve(c, &c->position, "spheres", count * place, e) ||
        mirror_reserve(c, &c->rgb, "spheres", count * sizeof(uint32_t), e))
        return e->status;
    for (size_t i = 0; i < count; i += SLICE) {
        const size_t some = count - i < SLICE ? count - i : SLICE;
        slice_pack(c, &view, frame, i, i + some);
        mirror_upload(c, &c->position, i * place, some * place);
        mirror_upload(c, &c->rgb, i * sizeof(uint32_t), some * sizeof(uint32_t));
    }
    w->position = c->position.device;
    w->word = c->rgb.device;
    return STATUS_OK;
}

static void rays_upload(struct canvas *c, const struct camera *camera, struct splat *splat)
{
    const struct sampling *g = &c->grid;
    const size_t width = (size_t)g->width, height = (size_t)g->height;
    float *rays = c->rays.host;
    sampling_rays(&c->grid, camera);
    memcpy(rays, g->ray_x, width * sizeof *rays);
    memcpy(rays + width, g->ray_y, height * sizeof *rays);
    mirror_upload(c, &c->rays, 0, (width + height) * sizeof *rays);
    splat->ray_x = c->rays.device;
    splat->ray_y = splat->ray_x + width;
}

/* Queues finding what samples show. */
static enum status spheres_queue(struct canvas *c, const struct render_frame *frame, struct draw_work *w,
                                 struct error *e)
{
    if (frame->count >= UINT32_MAX)
        return error_set(e, STATUS_RUN, "out of memory for drawing %zu particles", frame->count);
    if (room_reserve(c, &c->balls, &c->ball_bytes, "spheres", frame->count * sizeof(struct ball), e))
        return e->status;
    launch(c, DRAW_clear, samples_of(c), w);
    if (frame->slot)
        particles_follow(c, frame, w);
    else if (particles_upload(c, frame, w, e))
        return e->status;
    w->balls = c->balls;
    w->splat.balls = c->balls;
    launch(c, DRAW_place, frame->count, w);
    launch(c, DRAW_splat, frame->count * DRAW_THREADS, w);
    return STATUS_OK;
}

/* Queues the domain's triangles, and which tiles each may cover. */
static enum status domain_queue(struct canvas *c, const struct camera *camera, const struct render_frame *frame,
                                struct draw_work *w, struct error *e)
{
    struct sampling *g = &c->grid;
    const size_t tiles = (size_t)w->columns * (size_t)((g->height + g->tile - 1) / g->tile);
    if (!wire_wanted(c->setup.scene))
        return STATUS_OK;
    if (sampling_wire(g, camera, frame, e) ||
        blends_make(&g->blends, &g->wire, BLEND_ALL, g->width, g->height, e))
        return e->status;
    const size_t count = g->blends.count, bytes = count * sizeof *g->blends.blend;
    w->words = (count + 31) / 32;
    if (mirror_reserve(c, &c->blends, "the domain", bytes, e) ||
        room_reserve(c, &c->mask, &c->mask_bytes, "the domain", tiles * w->words * sizeof *w->mask, e))
        return e->status;
    if (count > 0)
        memcpy(c->blends.host, g->blends.blend, bytes);
    mirror_upload(c, &c->blends, 0, bytes);
    w->splat.blends = c->blends.device;
    w->splat.blend_count = count;
    w->mask = c->mask;
    launch(c, DRAW_cull, tiles * w->words, w);
    return STATUS_OK;
}

static enum status raw_read(struct canvas *c, const struct render_frame *frame, struct image *image,
                            struct error *e)
{
    if (c->row->read(c->device, c->raw, c->nearest, pixels_of(c) * sizeof *c->raw, e))
        return e->status;
    for (size_t i = 0; i < pixels_of(c); i++) {
        const uint32_t depth = (uint32_t)(c->raw[i] >> 32);
        float z;
        memcpy(&z, &depth, sizeof z);
        sampling_raw(frame, z, (uint32_t)c->raw[i], image->raw + RAW_PLANES * i);
    }
    return STATUS_OK;
}

/* By way of pinned memory, which the driver copies to directly. */
static enum status picture_read(struct canvas *c, struct image *image, struct error *e)
{
    const size_t row = (size_t)image->width * PIXEL;
    const char *from = c->pixel.host;
    if (c->row->read(c->device, c->pixel.host, c->pixel.device, pixels_of(c) * PIXEL, e))
        return e->status;
#pragma omp parallel for schedule(static) num_threads(c->grid.threads)
    for (int y = 0; y < image->height; y++)
        memcpy(image->rgba + (size_t)y * row, from + (size_t)y * row, row);
    return STATUS_OK;
}

static enum status picture_draw(struct canvas *c, const struct camera *camera, const struct render_frame *frame,
                                struct image *image, struct error *e)
{
    const struct sampling *g = &c->grid;
    struct draw_work w = {.splat = sampling_splat(g, camera, c->setup.radius, image),
                          .from = sampling_viewpoint(g, camera, c->setup.radius),
                          .seen = c->seen, .width = g->width, .height = g->height, .tile = g->tile,
                          .columns = (g->width + g->tile - 1) / g->tile,
                          .pixel = c->pixel.device, .nearest = c->nearest};
    rays_upload(c, camera, &w.splat);
    if (spheres_queue(c, frame, &w, e) || domain_queue(c, camera, frame, &w, e))
        return e->status;
    launch(c, DRAW_shade, pixels_of(c), &w);
    if (image->raw)
        launch(c, DRAW_nearest, pixels_of(c), &w);
    if (picture_read(c, image, e))
        return e->status;
    return image->raw ? raw_read(c, frame, image, e) : STATUS_OK;
}

enum status canvas_device_draw(void *canvas, const struct camera *camera, const struct render_frame *frame,
                               struct image *image, struct error *e)
{
    struct canvas *c = canvas;
    struct error ignored;
    enum status status = picture_draw(c, camera, frame, image, e);
    if (status)
        c->row->wait(c->device, &ignored); /* for copies from pinned memory */
    return status;
}

const char *canvas_device_name(const void *canvas)
{
    return ((const struct canvas *)canvas)->name;
}
