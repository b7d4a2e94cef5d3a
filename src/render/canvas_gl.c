/* Renderers that draw by OpenGL into an off-screen framebuffer, each in a context of its own. */
#include "render/canvas.h"

#include "base/log.h"
#include "render/context.h"
#include "render/gl.h"
#include "render/hidden.h"
#include "render/resolve.h"
#include "render/sprites_device.h"
#include "render/wire_gl.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct canvas {
    struct render_setup setup;
    const struct gl_context_row *row;
    void *context;
    struct gl gl;
    struct sprites sprites;
    struct sprites_device device;
    struct wire_gl wire;
    struct resolve resolve;
    GLuint framebuffer, color, depth; /* color is a texture */
    int width, height; /* of a frame, pixels */
    int samples;       /* drawn pixels per frame pixel, in x and in y */
    float *cover;      /* width * height, for hidden_drop */
    char name[300];
};

/* The scene's picture must fit the machine's limits; without room for all samples, fewer. */
static enum status size_check(struct canvas *r, struct error *e)
{
    GLint buffer = 0, texture = 0, viewport[2] = {0, 0}, most;
    r->gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &buffer);
    r->gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &texture);
    r->gl.GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport);
    most = viewport[0] < viewport[1] ? viewport[0] : viewport[1];
    most = buffer < most ? buffer : most;
    most = texture < most ? texture : most;
    if (r->width < 1 || r->height < 1 || r->width > most || r->height > most)
        return error_set(e, STATUS_BACKEND, "a picture of %d x %d pixels cannot be drawn: %s draws "
                         "up to %d x %d; choose another --size", r->width, r->height, r->name,
                         most, most);
    r->samples = (int)r->setup.scene->render.samples;
    while (r->samples > 1 && (r->width > most / r->samples || r->height > most / r->samples))
        r->samples--;
    if (r->samples < r->setup.scene->render.samples)
        log_info("warning: render.samples is %d, not %d: %s draws up to %d x %d samples; --renderer cpu draws more",
                 r->samples, (int)r->setup.scene->render.samples, r->name, most, most);
    return STATUS_OK;
}

/* 8 bits are too coarse for large faces over one another; on llvmpipe 16 take a third longer. */
static bool is_deep(const struct canvas *r)
{
    return r->setup.scene->render.box == BOX_FACES;
}

static enum status framebuffer_open(struct canvas *r, struct error *e)
{
    const struct gl *gl = &r->gl;
    GLsizei width = r->width * r->samples, height = r->height * r->samples;
    GLenum state;
    gl->GenFramebuffers(1, &r->framebuffer);
    gl->GenTextures(1, &r->color);
    gl->GenRenderbuffers(1, &r->depth);
    gl->BindFramebuffer(GL_FRAMEBUFFER, r->framebuffer);
    gl->BindTexture(GL_TEXTURE_2D, r->color);
    gl->TexImage2D(GL_TEXTURE_2D, 0, is_deep(r) ? GL_RGBA16 : GL_RGBA8, width, height, 0, GL_RGBA,
                   GL_UNSIGNED_BYTE, NULL);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->BindRenderbuffer(GL_RENDERBUFFER, r->depth);
    gl->RenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width, height);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, r->color, 0);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, r->depth);
    if (gl_check(gl, "while making the picture's memory", e) != STATUS_OK)
        return e->status;
    state = gl->CheckFramebufferStatus(GL_FRAMEBUFFER);
    if (state != GL_FRAMEBUFFER_COMPLETE)
        return error_set(e, STATUS_BACKEND, "%s cannot draw off-screen (framebuffer 0x%04x)",
                         r->name, state);
    r->cover = malloc((size_t)r->width * (size_t)r->height * sizeof *r->cover);
    if (!r->cover)
        return error_set(e, STATUS_RUN, "out of memory for the picture");
    return STATUS_OK;
}

/* Everything that needs the context current. */
static enum status resources_open(struct canvas *r, struct error *e)
{
    const char *gl_name;
    enum status status = gl_load(&r->gl, r->row->getproc, r->context, e);
    if (status != STATUS_OK)
        return status;
    gl_name = (const char *)r->gl.GetString(GL_RENDERER);
    snprintf(r->name, sizeof r->name, "%s (%s)", r->row->name, gl_name ? gl_name : "?");
    status = size_check(r, e);
    if (status == STATUS_OK)
        status = framebuffer_open(r, e);
    if (status == STATUS_OK)
        status = sprites_open(&r->sprites, &r->gl, &r->setup, e);
    if (status == STATUS_OK && wire_wanted(r->setup.scene))
        status = wire_open(&r->wire, &r->gl, e);
    if (status == STATUS_OK)
        status = resolve_open(&r->resolve, &r->gl, r->setup.scene, r->width, r->height, r->samples, is_deep(r),
                              e);
    return status;
}

static void resources_close(struct canvas *r)
{
    const struct gl *gl = &r->gl;
    resolve_close(&r->resolve, gl);
    wire_close(&r->wire, gl);
    sprites_device_close(&r->device);
    sprites_close(&r->sprites, gl);
    if (r->framebuffer) {
        gl->DeleteFramebuffers(1, &r->framebuffer);
        gl->DeleteTextures(1, &r->color);
        gl->DeleteRenderbuffers(1, &r->depth);
    }
}

static void canvas_close(void *canvas)
{
    struct canvas *r = canvas;
    struct error ignored;
    if (!r)
        return;
    if (r->context && r->row->bind(r->context, &ignored) == STATUS_OK) {
        resources_close(r);
        r->row->unbind(r->context);
    }
    r->row->close(r->context);
    free(r->cover);
    free(r);
}

static enum status canvas_open(void **canvas, const struct canvas_row *row,
                               const struct render_setup *setup, struct error *e)
{
    struct canvas *r = calloc(1, sizeof *r);
    *canvas = NULL;
    if (!r)
        return error_set(e, STATUS_RUN, "out of memory");
    r->setup = *setup;
    const char *cannot = NULL;
    if (strcmp(setup->scene->render.style, "surface") == 0)
        cannot = "render.style surface";
    if (setup->raw)
        cannot = "a raw image (pfm)";
    if (setup->scene->render.occlusion > 0)
        cannot = "render.occlusion";
    if (cannot) {
        free(r);
        return error_set(e, STATUS_BACKEND, "%s is drawn by --renderer cpu only", cannot);
    }
    r->row = row->context;
    r->width = setup->scene->movie.size[0];
    r->height = setup->scene->movie.size[1];
    enum status status = r->row->open(&r->context, setup->on_device ? setup->device : -1, e);
    if (status == STATUS_OK)
        status = r->row->bind(r->context, e);
    if (status == STATUS_OK) {
        status = resources_open(r, e);
        r->row->unbind(r->context);
    }
    if (status == STATUS_OK)
        *canvas = r;
    else
        canvas_close(r);
    return status;
}

/* Depth 1: behind the domain and every particle. A power of two, so that depths are divided by it exactly, and are the
 * same bits wherever the farthest particle is. */
static double far_distance(const struct canvas *r, const struct camera *camera, size_t count)
{
    double far = r->device.slots ? sprites_device_reach(&r->device, camera, r->setup.radius)
                                 : sprites_reach(&r->sprites, count, camera, r->setup.radius);
    for (int i = 0; i < 8; i++) {
        double corner[3], view[3];
        camera_corner(r->setup.scene, i, r->setup.radius, corner);
        camera_view(camera, corner, view);
        far = fmax(far, view[2]);
    }
    int exponent;
    frexp(far > 0 ? far * 1.001 : 1, &exponent);
    return ldexp(1, exponent);
}

static enum status gl_draw(struct canvas *r, const struct camera *camera,
                           const struct render_frame *frame, struct error *e)
{
    const struct gl *gl = &r->gl;
    const struct scene *scene = r->setup.scene;
    const double *back = scene->render.background;
    GLsizei width = r->width * r->samples, height = r->height * r->samples;
    const size_t count = frame->slot ? frame->count
                                     : hidden_drop(camera, r->sprites.packed, frame->count, r->setup.radius,
                                                   r->samples, r->cover);
    const double far = far_distance(r, camera, count);
    gl->BindFramebuffer(GL_FRAMEBUFFER, r->framebuffer);
    gl->Viewport(0, 0, width, height);
    gl->Disable(GL_DITHER);
    gl->Disable(GL_BLEND);
    gl->DepthMask(1);
    if (r->resolve.over)
        gl->ClearColor(0, 0, 0, 0);
    else
        gl->ClearColor((float)back[0], (float)back[1], (float)back[2], 1);
    gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (count)
        sprites_draw(&r->sprites, gl, count, camera, far);
    const struct wire_view view = {scene, camera, frame, far, r->samples, 1};
    if (wire_wanted(scene) && wire_draw(&r->wire, gl, &view, e))
        return e->status;
    return gl_check(gl, "while drawing a frame", e);
}

static enum status canvas_draw(void *canvas, const struct camera *camera,
                               const struct render_frame *frame, struct image *image, struct error *e)
{
    struct canvas *r = canvas;
    if ((!frame->slot && sprites_prepare(&r->sprites, &r->setup, frame, e)) || r->row->bind(r->context, e))
        return e->status;
    enum status status = STATUS_OK;
    if (frame->slot)
        status = sprites_device_prepare(&r->device, &r->sprites, &r->setup, frame, e);
    if (status == STATUS_OK)
        status = gl_draw(r, camera, frame, e);
    if (status == STATUS_OK)
        status = resolve_read(&r->resolve, &r->gl, r->color, image->rgba, e);
    r->row->unbind(r->context);
    return status;
}

static enum status canvas_share(void *canvas, const struct slots *slots, struct error *e)
{
    struct canvas *r = canvas;
    const int gpu = r->row->cuda(r->context);
    if (gpu >= 0 && gpu != slots->source.device)
        return error_set(e, STATUS_BACKEND, "OpenGL is on another GPU, cuda:%d", gpu);
    if (r->row->bind(r->context, e))
        return e->status;
    enum status status = sprites_device_open(&r->device, &r->sprites, &r->gl, slots, e);
    r->row->unbind(r->context);
    return status;
}

static const char *canvas_name(const void *canvas)
{
    return ((const struct canvas *)canvas)->name;
}

/* Mesa's rasterisers for processors. */
static bool canvas_software(const void *canvas)
{
    const char *name = canvas_name(canvas);
    return strstr(name, "llvmpipe") || strstr(name, "softpipe") || strstr(name, "swrast");
}

const struct canvas_row canvas_egl = {
    .variant = {.name = "egl", .doc = "OpenGL 3.3 core on an EGL device (GPU) or surfaceless (Mesa software)",
                .missing = EGL_MISSING},
    .context = &context_egl,
    .open = canvas_open,
    .share = canvas_share,
    .draw = canvas_draw,
    .name = canvas_name,
    .software = canvas_software,
    .close = canvas_close,
};

const struct canvas_row canvas_osmesa = {
    .variant = {.name = "osmesa", .doc = "OpenGL 3.3 core by Mesa software, into memory (libOSMesa)",
                .missing = OSMESA_MISSING},
    .context = &context_osmesa,
    .open = canvas_open,
    .share = canvas_share,
    .draw = canvas_draw,
    .name = canvas_name,
    .software = canvas_software,
    .close = canvas_close,
};
