/* Particles as lit spheres with exact perspective and depth. */
#include "render/sprites.h"

#include "render/look.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char vertex_text[] =
#include "shaders/sprite.vert.h"
    ;
static const char fragment_text[] =
#include "shaders/sprite.frag.h"
    ;

/* Three vertices each are numbered by an int. Mesa's softpipe (22.3) splits long draw calls, and numbers the
 * vertices of each part from 0 (2026-11-25: right with 1,024 particles, wrong with a whole dam break). */
enum { CHUNK_MAX = 1 << 26, CHUNK_SOFTPIPE = 1 << 10 };

static size_t chunk_choose(const struct gl *gl)
{
    GLint texels = 65536; /* what GL 3.3 guarantees */
    const char *name = (const char *)gl->GetString(GL_RENDERER);
    gl->GetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &texels);
    size_t most = name && strstr(name, "softpipe") ? CHUNK_SOFTPIPE : CHUNK_MAX;
    return (size_t)texels < most ? (size_t)texels : most;
}

static void map_upload(struct sprites *s, const struct gl *gl, const struct render_setup *setup)
{
    gl->GenTextures(1, &s->map);
    gl->BindTexture(GL_TEXTURE_1D, s->map);
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl->TexImage1D(GL_TEXTURE_1D, 0, GL_RGB8, MAP_SIZE, 0, GL_RGB, GL_UNSIGNED_BYTE,
                   setup->palette);
    gl->TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl->TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl->TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
}

static void uniforms_find(struct sprites *s, const struct gl *gl, const struct render_setup *setup)
{
    s->view = gl->GetUniformLocation(s->program, "view");
    s->scale = gl->GetUniformLocation(s->program, "scale");
    s->parallel = gl->GetUniformLocation(s->program, "parallel");
    s->far = gl->GetUniformLocation(s->program, "far");
    s->key_light = gl->GetUniformLocation(s->program, "key_light");
    s->material = gl->GetUniformLocation(s->program, "material");
    s->shine = gl->GetUniformLocation(s->program, "shine");
    s->rim = gl->GetUniformLocation(s->program, "rim");
    s->outline = setup->scene->render.outline;
    gl->UseProgram(s->program);
    gl->Uniform1i(gl->GetUniformLocation(s->program, "particles"), 0);
    gl->Uniform1i(gl->GetUniformLocation(s->program, "map"), 1);
    gl->Uniform1i(gl->GetUniformLocation(s->program, "solid"), setup->solid);
    gl->Uniform1f(gl->GetUniformLocation(s->program, "radius"), (float)setup->radius);
}

enum status sprites_open(struct sprites *s, const struct gl *gl, const struct render_setup *setup,
                         struct error *e)
{
    enum status status = gl_program(gl, &s->program, "sprites", vertex_text, fragment_text, NULL,
                                    e);
    if (status != STATUS_OK)
        return status;
    uniforms_find(s, gl, setup);
    s->chunk = chunk_choose(gl);
    gl->GenVertexArrays(1, &s->array); /* empty, but core profile wants one */
    gl->GenBuffers(1, &s->buffer);
    gl->GenTextures(1, &s->texture);
    map_upload(s, gl, setup);
    return gl_check(gl, "while preparing to draw particles", e);
}

void sprites_close(struct sprites *s, const struct gl *gl)
{
    if (s->program) {
        gl->DeleteProgram(s->program);
        gl->DeleteVertexArrays(1, &s->array);
        gl->DeleteBuffers(1, &s->buffer);
        gl->DeleteTextures(1, &s->texture);
        gl->DeleteTextures(1, &s->map);
    }
    free(s->packed);
    memset(s, 0, sizeof *s);
}

enum status sprites_prepare(struct sprites *s, const struct render_setup *setup,
                            const struct render_frame *frame, struct error *e)
{
    if (frame->count > s->capacity) {
        size_t room = frame->count + frame->count / 4;
        void *larger = frame->count <= SIZE_MAX / 32 ? realloc(s->packed, room * sizeof *s->packed)
                                                     : NULL;
        if (!larger)
            return error_set(e, STATUS_RUN, "out of memory for drawing %zu particles",
                             frame->count);
        s->packed = larger;
        s->capacity = room;
    }
    const struct color_scale *scale = frame->scale ? frame->scale : &setup->scale;
    for (size_t i = 0; i < frame->count; i++) {
        float t;
        memcpy(s->packed[i], frame->position + 3 * i, 3 * sizeof(float));
        if (setup->solid) {
            memcpy(&s->packed[i][3], frame->color + 4 * i, 4);
        } else {
            t = scale_place(scale, frame->value[i]);
            memcpy(&s->packed[i][3], &t, sizeof t);
        }
    }
    return STATUS_OK;
}

double sprites_reach(const struct sprites *s, size_t count, const struct camera *camera,
                     double radius)
{
    double far = 0;
    const double *f = camera->forward;
    for (size_t i = 0; i < count; i++) {
        float p[3];
        double z;
        memcpy(p, s->packed[i], sizeof p);
        z = (p[0] - camera->eye[0]) * f[0] + (p[1] - camera->eye[1]) * f[1] +
            (p[2] - camera->eye[2]) * f[2];
        if (z > far && z < 1e30) /* no infinity, no NAN */
            far = z;
    }
    return far > 0 ? far + radius : 0;
}

/* Column-major matrix into camera axes, z towards the viewer. The product with the eye is taken in
 * double, so that a distant eye costs no precision. */
static void view_matrix(const struct camera *camera, float m[16])
{
    for (int k = 0; k < 3; k++) {
        m[4 * k + 0] = (float)camera->right[k];
        m[4 * k + 1] = (float)camera->up[k];
        m[4 * k + 2] = (float)-camera->forward[k];
        m[4 * k + 3] = 0;
    }
    double origin[3] = {0, 0, 0}, view[3];
    camera_view(camera, origin, view);
    m[12] = (float)view[0];
    m[13] = (float)view[1];
    m[14] = (float)-view[2];
    m[15] = 1;
}

static void look_set(const struct sprites *s, const struct gl *gl)
{
    struct look look = look_make(s->outline);
    gl->Uniform3f(s->key_light, look.key[0], look.key[1], look.key[2]);
    gl->Uniform4f(s->material, look.base, look.sky, look.diffuse, look.facing);
    gl->Uniform1f(s->shine, look.shine);
    gl->Uniform1f(s->rim, look.rim);
}

/* Four ways were timed on llvmpipe (least ms per frame, 1280x720, four samples per pixel, two
 * threads) with 50k and 200k spheres in sight: points 123 and 250, instanced quads 154 and 245,
 * quads numbered by gl_VertexID 110 and 249, triangles numbered by gl_VertexID 121 and 235. Points
 * vanish when their centre leaves the picture, are limited in size, and differ between
 * rasterisers; the others agree. A triangle has the fewest vertices. */
void sprites_draw(const struct sprites *s, const struct gl *gl, size_t count,
                  const struct camera *camera, double far)
{
    float view[16];
    view_matrix(camera, view);
    gl->UseProgram(s->program);
    gl->UniformMatrix4fv(s->view, 1, GL_FALSE, view);
    gl->Uniform2f(s->scale, (float)(1 / camera_half_x(camera)), (float)(1 / camera_half_y(camera)));
    gl->Uniform1i(s->parallel, camera->orthographic);
    gl->Uniform1f(s->far, (float)far);
    look_set(s, gl);
    gl->BindVertexArray(s->array);
    gl->ActiveTexture(GL_TEXTURE0 + 1);
    gl->BindTexture(GL_TEXTURE_1D, s->map);
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_BUFFER, s->texture);
    gl->BindBuffer(GL_TEXTURE_BUFFER, s->buffer);
    gl->Enable(GL_DEPTH_TEST);
    gl->DepthFunc(GL_LESS);
    gl->DepthMask(1);
    for (size_t first = 0; first < count; first += s->chunk) {
        size_t n = count - first < s->chunk ? count - first : s->chunk;
        if (!s->is_filled)
            gl->BufferData(GL_TEXTURE_BUFFER, (GLsizeiptr)(n * sizeof *s->packed), s->packed + first,
                           GL_STREAM_DRAW);
        gl->TexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32UI, s->buffer);
        gl->DrawArrays(GL_TRIANGLES, 0, (GLsizei)(3 * n));
    }
}
