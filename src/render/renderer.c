/* A renderer: one context, one off-screen framebuffer, and what is drawn into it for each frame. */
#include "render/render.h"

#include "render/camera.h"
#include "render/context.h"
#include "render/gl.h"
#include "render/hidden.h"
#include "render/overlay.h"
#include "render/sprites.h"
#include "render/wire.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct renderer {
    struct render_setup setup;
    const struct gl_context_row *row;
    void *context;
    struct gl gl;
    struct sprites sprites;
    struct wire wire;
    struct overlay *overlay;
    GLuint framebuffer, color, depth;
    int width, height; /* of a frame, pixels */
    int samples;       /* drawn pixels per frame pixel, in x and in y */
    uint32_t *drawn;   /* RGBA bytes as read back, bottom row first */
    float *cover;      /* width * height, for hidden_drop */
    char name[300];
};

/* The scene's picture must fit the machine's limits; without room for 2 x 2 samples, 1 x 1. */
static enum status size_check(struct renderer *r, struct error *e)
{
    GLint buffer = 0, viewport[2] = {0, 0}, most;
    r->gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &buffer);
    r->gl.GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    most = viewport[0] < viewport[1] ? viewport[0] : viewport[1];
    most = buffer < most ? buffer : most;
    if (r->width < 1 || r->height < 1 || r->width > most || r->height > most)
        return error_set(e, STATUS_BACKEND, "a picture of %d x %d pixels cannot be drawn: %s draws "
                         "up to %d x %d; choose another --size", r->width, r->height, r->name,
                         most, most);
    r->samples = r->width <= most / 2 && r->height <= most / 2 ? 2 : 1;
    return STATUS_OK;
}

static enum status framebuffer_open(struct renderer *r, struct error *e)
{
    const struct gl *gl = &r->gl;
    GLsizei width = r->width * r->samples, height = r->height * r->samples;
    GLenum state;
    gl->GenFramebuffers(1, &r->framebuffer);
    gl->GenRenderbuffers(1, &r->color);
    gl->GenRenderbuffers(1, &r->depth);
    gl->BindFramebuffer(GL_FRAMEBUFFER, r->framebuffer);
    gl->BindRenderbuffer(GL_RENDERBUFFER, r->color);
    gl->RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    gl->BindRenderbuffer(GL_RENDERBUFFER, r->depth);
    gl->RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width, height);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, r->color);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, r->depth);
    if (gl_check(gl, "while making the picture's memory", e) != STATUS_OK)
        return e->status;
    state = gl->CheckFramebufferStatus(GL_FRAMEBUFFER);
    if (state != GL_FRAMEBUFFER_COMPLETE)
        return error_set(e, STATUS_BACKEND, "%s cannot draw off-screen (framebuffer 0x%04x)",
                         r->name, state);
    r->drawn = malloc((size_t)width * (size_t)height * 4);
    r->cover = malloc((size_t)r->width * (size_t)r->height * sizeof *r->cover);
    if (!r->drawn || !r->cover)
        return error_set(e, STATUS_RUN, "out of memory for the picture");
    return STATUS_OK;
}

/* Everything that needs the context current. */
static enum status resources_open(struct renderer *r, struct error *e)
{
    const char *gl_name;
    enum status status = gl_load(&r->gl, r->row->getproc, r->context, e);
    if (status != STATUS_OK)
        return status;
    gl_name = (const char *)r->gl.GetString(GL_RENDERER);
    snprintf(r->name, sizeof r->name, "%s (%s)", r->row->variant.name, gl_name ? gl_name : "?");
    status = size_check(r, e);
    if (status == STATUS_OK)
        status = framebuffer_open(r, e);
    if (status == STATUS_OK)
        status = sprites_open(&r->sprites, &r->gl, &r->setup, e);
    if (status == STATUS_OK && r->setup.scene->render.box)
        status = wire_open(&r->wire, &r->gl, e);
    return status;
}

static void resources_close(struct renderer *r)
{
    const struct gl *gl = &r->gl;
    wire_close(&r->wire, gl);
    sprites_close(&r->sprites, gl);
    if (r->framebuffer) {
        gl->DeleteFramebuffers(1, &r->framebuffer);
        gl->DeleteRenderbuffers(1, &r->color);
        gl->DeleteRenderbuffers(1, &r->depth);
    }
}

/* Opens one row; on failure leaves nothing open. */
static enum status row_open(struct renderer *r, const struct gl_context_row *row, struct error *e)
{
    enum status status = row->open(&r->context, e);
    r->row = row;
    if (status == STATUS_OK)
        status = row->bind(r->context, e);
    if (status == STATUS_OK) {
        status = resources_open(r, e);
        if (status != STATUS_OK)
            resources_close(r);
        row->unbind(r->context);
    }
    if (status != STATUS_OK) {
        row->close(r->context);
        free(r->drawn);
        free(r->cover);
        r->drawn = NULL;
        r->cover = NULL;
        r->context = NULL;
        r->row = NULL;
        r->framebuffer = 0;
    }
    return status;
}

/* Tries the rows of this build in order, and keeps what each one said. */
static enum status any_open(struct renderer *r, struct error *e)
{
    char tried[1800] = "";
    for (size_t i = 0; i < render_contexts.count; i++) {
        const struct variant *row = render_contexts.rows[i];
        size_t used = strlen(tried);
        if (!row->missing && row_open(r, (const struct gl_context_row *)row, e) == STATUS_OK)
            return STATUS_OK;
        snprintf(tried + used, sizeof tried - used, "\n  %s: %.800s", row->name,
                 row->missing ? row->missing : e->text);
    }
    return error_set(e, STATUS_BACKEND, "no OpenGL context to draw with:%s", tried);
}

static enum status context_open(struct renderer *r, const char *name, struct error *e)
{
    const struct variant *row;
    if (!name || strcmp(name, "auto") == 0)
        return any_open(r, e);
    row = variant_find(&render_contexts, name);
    if (!row)
        return error_set(e, STATUS_BACKEND, "there is no context \"%s\"", name);
    if (row->missing)
        return error_set(e, STATUS_BACKEND, "context %s is not in this build: %s", name,
                         row->missing);
    if (row_open(r, (const struct gl_context_row *)row, e) == STATUS_OK)
        return STATUS_OK;
    return error_context(e, "context %s", name);
}

enum status renderer_open(struct renderer **renderer, const struct render_setup *setup,
                          struct error *e)
{
    enum status status;
    struct renderer *r = calloc(1, sizeof *r);
    *renderer = NULL;
    if (!r)
        return error_set(e, STATUS_RUN, "out of memory");
    r->setup = *setup;
    r->width = setup->scene->movie.size[0];
    r->height = setup->scene->movie.size[1];
    status = context_open(r, setup->context, e);
    if (status == STATUS_OK)
        status = overlay_open(&r->overlay, &r->setup, e);
    if (status != STATUS_OK) {
        renderer_close(r);
        return status;
    }
    *renderer = r;
    return STATUS_OK;
}

const char *renderer_name(const struct renderer *r)
{
    return r->name;
}

void renderer_close(struct renderer *r)
{
    struct error ignored;
    if (!r)
        return;
    overlay_close(r->overlay);
    if (r->context) {
        if (r->row->bind(r->context, &ignored) == STATUS_OK) {
            resources_close(r);
            r->row->unbind(r->context);
        }
        r->row->close(r->context);
    }
    free(r->drawn);
    free(r->cover);
    free(r);
}

/* Depth 1: behind the domain and every particle. */
static double far_distance(const struct renderer *r, const struct camera *camera, size_t count)
{
    double far = sprites_reach(&r->sprites, count, camera, r->setup.radius);
    for (int i = 0; i < 8; i++) {
        double corner[3], view[3];
        camera_corner(r->setup.scene, i, r->setup.radius, corner);
        camera_view(camera, corner, view);
        far = fmax(far, view[2]);
    }
    return far > 0 ? far * 1.001 : 1;
}

static enum status gl_draw(struct renderer *r, const struct render_frame *frame, struct error *e)
{
    const struct gl *gl = &r->gl;
    const struct scene *scene = r->setup.scene;
    const double *back = scene->render.background;
    GLsizei width = r->width * r->samples, height = r->height * r->samples;
    struct camera camera;
    size_t count;
    double far;
    camera_make(&camera, scene, r->setup.radius, frame->time);
    count = hidden_drop(&camera, r->sprites.packed, frame->count, r->setup.radius, r->cover);
    far = far_distance(r, &camera, count);
    gl->BindFramebuffer(GL_FRAMEBUFFER, r->framebuffer);
    gl->Viewport(0, 0, width, height);
    gl->Disable(GL_DITHER);
    gl->Disable(GL_BLEND);
    gl->DepthMask(1);
    gl->ClearColor((float)back[0], (float)back[1], (float)back[2], 1);
    gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (count)
        sprites_draw(&r->sprites, gl, count, &camera, far);
    if (scene->render.box)
        wire_draw(&r->wire, gl, scene, &camera, far, r->samples);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl->ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, r->drawn);
    return gl_check(gl, "while drawing a frame", e);
}

/* The rounded mean of four RGBA pixels, two bytes at a time in the halves of a word. */
static uint32_t mean4(const uint32_t *upper, const uint32_t *lower)
{
    const uint32_t half = 0x00ff00ff, round = 0x00020002;
    uint32_t a = (upper[0] & half) + (upper[1] & half) + (lower[0] & half) + (lower[1] & half);
    uint32_t b = (upper[0] >> 8 & half) + (upper[1] >> 8 & half) + (lower[0] >> 8 & half) +
                 (lower[1] >> 8 & half);
    return ((a + round) >> 2 & half) | ((b + round) >> 2 & half) << 8;
}

/* Rows from the top, and the mean of 2 x 2 samples where there are. */
static void resolve(const struct renderer *r, struct image *image)
{
    size_t row = (size_t)r->width * (size_t)r->samples; /* pixels */
    uint32_t *out = (uint32_t *)(void *)image->rgba;
    for (int y = 0; y < r->height; y++, out += r->width) {
        const uint32_t *upper = r->drawn + (size_t)(r->height - 1 - y) * (size_t)r->samples * row;
        if (r->samples == 1)
            memcpy(out, upper, row * sizeof *upper);
        else
            for (int x = 0; x < r->width; x++)
                out[x] = mean4(upper + 2 * x, upper + row + 2 * x);
    }
}

enum status renderer_draw(struct renderer *r, const struct render_frame *frame,
                          struct image *image, struct error *e)
{
    enum status status = STATUS_OK;
    if (!image->rgba || image->width != r->width || image->height != r->height) {
        image_free(image);
        status = image_create(image, r->width, r->height, e);
    }
    if (status == STATUS_OK)
        status = sprites_prepare(&r->sprites, &r->setup, frame, e);
    if (status == STATUS_OK)
        status = r->row->bind(r->context, e);
    if (status != STATUS_OK)
        return status;
    status = gl_draw(r, frame, e);
    r->row->unbind(r->context);
    if (status != STATUS_OK)
        return error_context(e, "frame %ld", frame->index);
    resolve(r, image);
    overlay_draw(r->overlay, frame, image);
    return STATUS_OK;
}
