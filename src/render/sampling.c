/* The samples of a picture, their rays and background, and the domain as triangles over them. */
#include "render/sampling.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_SAMPLES = 65535 }; /* of width or height: struct ball has 16 bits */

enum status sampling_open(struct sampling *s, const struct render_setup *setup, const char *renderer,
                          struct error *e)
{
    const int *size = setup->scene->movie.size;
    memset(s, 0, sizeof *s);
    s->setup = setup;
    s->threads = setup->threads > 0 ? setup->threads : omp_get_num_procs();
    s->samples = (int)setup->scene->render.samples;
    s->samples = s->samples < 1 ? 1 : s->samples;
    s->tile = TILE / s->samples * s->samples;
    const int most = MOST_SAMPLES / s->samples;
    if (size[0] < 1 || size[1] < 1 || size[0] > most || size[1] > most)
        return error_set(e, STATUS_BACKEND, "a picture of %d x %d pixels cannot be drawn: %s draws up to "
                         "%d x %d with render.samples %d; choose another --size, or fewer samples", size[0], size[1], renderer, most, most, s->samples);
    s->width = size[0] * s->samples;
    s->height = size[1] * s->samples;
    for (int i = 0; i < MAP_SIZE; i++)
        s->map[i] = setup->palette[i][0] | (uint32_t)setup->palette[i][1] << 8 |
                    (uint32_t)setup->palette[i][2] << 16;
    s->ray_x = calloc((size_t)s->width + TILE, sizeof *s->ray_x);
    s->ray_y = calloc((size_t)s->height + TILE, sizeof *s->ray_y);
    if (!s->ray_x || !s->ray_y)
        return error_set(e, STATUS_RUN, "out of memory for the picture");
    return STATUS_OK;
}

void sampling_close(struct sampling *s)
{
    wire_free(&s->wire);
    blends_free(&s->blends);
    free(s->ray_x);
    free(s->ray_y);
    memset(s, 0, sizeof *s);
}

void sampling_rays(struct sampling *s, const struct camera *camera)
{
    for (int x = 0; x < s->width; x++)
        s->ray_x[x] = (float)(((x + 0.5) / s->width * 2 - 1) * camera_half_x(camera));
    for (int y = 0; y < s->height; y++)
        s->ray_y[y] = (float)((1 - (y + 0.5) / s->height * 2) * camera_half_y(camera));
}

struct viewpoint sampling_viewpoint(const struct sampling *s, const struct camera *camera, double radius)
{
    struct viewpoint v = {.half = {(float)(s->width / 2.0 / camera_half_x(camera)),
                                   (float)(-s->height / 2.0 / camera_half_y(camera))},
                          .size = {s->width, s->height}, .radius = (float)radius,
                          .lens = camera->orthographic ? 0 : 1};
    memcpy(v.eye, camera->eye, sizeof v.eye);
    memcpy(v.axis[0], camera->right, sizeof v.axis[0]);
    memcpy(v.axis[1], camera->up, sizeof v.axis[1]);
    memcpy(v.axis[2], camera->forward, sizeof v.axis[2]);
    return v;
}

static void background_make(const struct sampling *s, struct splat *splat)
{
    const struct scene *scene = s->setup->scene;
    splat->planes = scene->render.transparent ? 4 : 3;
    for (int k = 0; k < 3 && !scene->render.transparent; k++) {
        double low = scene->render.background[k], high = scene->render.background_top[k];
        high = isnan(high) ? low : high;
        splat->fade[k] = (float)((low - high) / s->height);
        splat->back[k] = (float)(high + 0.5 * (low - high) / s->height);
    }
}

struct splat sampling_splat(const struct sampling *s, const struct camera *camera, double radius,
                            struct image *image)
{
    struct splat splat = {.ray_x = s->ray_x, .ray_y = s->ray_y, .lens = camera->orthographic ? 0 : 1,
                          .radius = (float)radius, .look = look_make(s->setup->scene->render.outline),
                          .samples = s->samples, .rgba = image->rgba, .pitch = (size_t)image->width};
    background_make(s, &splat);
    return splat;
}

static double far_distance(const struct sampling *s, const struct camera *camera)
{
    double far = 0;
    for (int i = 0; i < 8; i++) {
        double corner[3], view[3];
        camera_corner(s->setup->scene, i, s->setup->radius, corner);
        camera_view(camera, corner, view);
        far = fmax(far, view[2]);
    }
    return far > 0 ? far : 1;
}

enum status sampling_wire(struct sampling *s, const struct camera *camera, const struct render_frame *frame,
                          struct error *e)
{
    const struct wire_view view = {s->setup->scene, camera, frame, far_distance(s, camera), s->samples,
                                   s->threads};
    return wire_wanted(s->setup->scene) ? wire_make(&s->wire, &view, e) : STATUS_OK;
}

void sampling_raw(const struct render_frame *frame, float depth, uint32_t ball, float raw[RAW_PLANES])
{
    raw[RAW_DEPTH] = depth;
    raw[RAW_VALUE] = ball == UINT32_MAX || !frame->value ? NAN : frame->value[ball];
    raw[RAW_ID] = ball == UINT32_MAX ? -1 : (float)ball;
}
