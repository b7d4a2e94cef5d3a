/* Makes the pixels of a picture from the samples that OpenGL drew. */
#include "render/resolve.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char vertex_text[] =
#include "shaders/resolve.vert.h"
    ;
static const char fragment_text[] =
#include "shaders/resolve.frag.h"
    ;

/* The background in the middle of a row of pixels; its alpha is 0 where there is none. */
static void background_of(const struct scene *scene, int y, int height, float back[4])
{
    double part = (y + 0.5) / height;
    for (int k = 0; k < 3; k++) {
        double low = scene->render.background[k], high = scene->render.background_top[k];
        back[k] = (float)(isnan(high) ? low : high + part * (low - high));
    }
    back[3] = scene->render.transparent ? 0 : 1;
}

static enum status background_upload(struct resolve *r, const struct gl *gl, const struct scene *scene,
                                     struct error *e)
{
    float(*rows)[4] = malloc((size_t)r->height * sizeof *rows);
    if (!rows)
        return error_set(e, STATUS_RUN, "out of memory for the background");
    for (int y = 0; y < r->height; y++)
        background_of(scene, y, r->height, rows[y]);
    gl->GenTextures(1, &r->background);
    gl->BindTexture(GL_TEXTURE_2D, r->background);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, r->height, 0, GL_RGBA, GL_FLOAT, rows);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    free(rows);
    return STATUS_OK;
}

/* The shader's constants are put before it: with uniforms in their place llvmpipe takes three times as long. */
static enum status program_make(struct resolve *r, const struct gl *gl, int samples, bool deep, struct error *e)
{
    static const char *const words[] = {"false", "true"};
    char text[sizeof fragment_text + 100];
    snprintf(text, sizeof text, "#version 330 core\n#define SAMPLES %d\n#define DEEP %s\n#define OVER %s\n%s",
             samples, words[deep], words[r->over], fragment_text);
    if (gl_program(gl, &r->program, "resolve", vertex_text, text, NULL, e))
        return e->status;
    gl->UseProgram(r->program);
    gl->Uniform1i(gl->GetUniformLocation(r->program, "drawn"), 0);
    gl->Uniform1i(gl->GetUniformLocation(r->program, "background"), 1);
    gl->GenVertexArrays(1, &r->array); /* empty, as for sprites */
    return STATUS_OK;
}

/* Of whole numbers, which no driver rounds. */
static enum status framebuffer_open(struct resolve *r, const struct gl *gl, struct error *e)
{
    gl->GenFramebuffers(1, &r->framebuffer);
    gl->GenRenderbuffers(1, &r->picture);
    gl->BindFramebuffer(GL_FRAMEBUFFER, r->framebuffer);
    gl->BindRenderbuffer(GL_RENDERBUFFER, r->picture);
    gl->RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8UI, r->width, r->height);
    gl->FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, r->picture);
    if (gl_check(gl, "while making the picture's memory", e) != STATUS_OK)
        return e->status;
    GLenum state = gl->CheckFramebufferStatus(GL_FRAMEBUFFER);
    if (state != GL_FRAMEBUFFER_COMPLETE)
        return error_set(e, STATUS_BACKEND, "OpenGL cannot draw bytes off-screen (framebuffer 0x%04x)", state);
    return STATUS_OK;
}

enum status resolve_open(struct resolve *r, const struct gl *gl, const struct scene *scene, int width,
                         int height, int samples, bool deep, struct error *e)
{
    r->width = width;
    r->height = height;
    r->over = scene->render.transparent || !isnan(scene->render.background_top[0]);
    enum status status = program_make(r, gl, samples, deep, e);
    if (status == STATUS_OK)
        status = background_upload(r, gl, scene, e);
    if (status != STATUS_OK)
        return status;
    return framebuffer_open(r, gl, e);
}

void resolve_close(struct resolve *r, const struct gl *gl)
{
    if (r->program) {
        gl->DeleteProgram(r->program);
        gl->DeleteVertexArrays(1, &r->array);
        gl->DeleteFramebuffers(1, &r->framebuffer);
        gl->DeleteRenderbuffers(1, &r->picture);
        gl->DeleteTextures(1, &r->background);
    }
    memset(r, 0, sizeof *r);
}

enum status resolve_read(const struct resolve *r, const struct gl *gl, GLuint drawn, uint8_t *rgba,
                         struct error *e)
{
    gl->BindFramebuffer(GL_FRAMEBUFFER, r->framebuffer);
    gl->Viewport(0, 0, r->width, r->height);
    gl->Disable(GL_DEPTH_TEST);
    gl->Disable(GL_BLEND);
    gl->UseProgram(r->program);
    gl->BindVertexArray(r->array);
    gl->ActiveTexture(GL_TEXTURE0 + 1);
    gl->BindTexture(GL_TEXTURE_2D, r->background);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D, drawn);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl->ReadPixels(0, 0, r->width, r->height, GL_RGBA_INTEGER, GL_UNSIGNED_BYTE, rgba);
    return gl_check(gl, "while reading a frame", e);
}
