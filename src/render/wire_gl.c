/* Draws the domain's floor, faces and edges by OpenGL. */
#include "render/wire_gl.h"

#include <string.h>

static const char vertex_text[] =
#include "shaders/wire.vert.h"
    ;
static const char fragment_text[] =
#include "shaders/wire.frag.h"
    ;

enum status wire_open(struct wire_gl *w, const struct gl *gl, struct error *e)
{
    static const char *const attributes[] = {"vertex", NULL};
    enum status status = gl_program(gl, &w->program, "wire", vertex_text, fragment_text,
                                    attributes, e);
    if (status != STATUS_OK)
        return status;
    w->color = gl->GetUniformLocation(w->program, "color");
    w->half_width = gl->GetUniformLocation(w->program, "half_width");
    w->far = gl->GetUniformLocation(w->program, "far");
    w->parallel = gl->GetUniformLocation(w->program, "parallel");
    gl->GenVertexArrays(1, &w->array);
    gl->BindVertexArray(w->array);
    gl->GenBuffers(1, &w->buffer);
    gl->BindBuffer(GL_ARRAY_BUFFER, w->buffer);
    gl->EnableVertexAttribArray(0);
    gl->VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, NULL);
    return gl_check(gl, "while preparing to draw lines", e);
}

void wire_close(struct wire_gl *w, const struct gl *gl)
{
    if (w->program) {
        gl->DeleteProgram(w->program);
        gl->DeleteVertexArrays(1, &w->array);
        gl->DeleteBuffers(1, &w->buffer);
    }
    wire_free(&w->wire);
    memset(w, 0, sizeof *w);
}

static void layer_draw(const struct wire_gl *w, const struct gl *gl, const struct wire_layer *layer)
{
    const float *c = layer->color;
    gl->DepthMask(layer->solid);
    gl->DepthFunc(layer->behind ? GL_GEQUAL : GL_LESS);
    gl->Uniform1f(w->half_width, layer->half_width);
    gl->Uniform4f(w->color, c[0], c[1], c[2], c[3]);
    gl->DrawArrays(GL_TRIANGLES, (GLint)layer->first, (GLsizei)layer->count);
}

enum status wire_draw(struct wire_gl *w, const struct gl *gl, const struct wire_view *view,
                      struct error *e)
{
    const struct wire *wire = &w->wire;
    if (wire_make(&w->wire, view, e))
        return e->status;
    gl->UseProgram(w->program);
    gl->Uniform1f(w->far, (float)view->far);
    gl->Uniform1i(w->parallel, wire->parallel);
    gl->BindVertexArray(w->array);
    gl->BindBuffer(GL_ARRAY_BUFFER, w->buffer);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(wire->mesh.count * sizeof *wire->mesh.vertex),
                   wire->mesh.vertex, GL_STREAM_DRAW);
    gl->Enable(GL_DEPTH_TEST);
    gl->Enable(GL_BLEND);
    gl->BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (size_t i = 0; i < wire->count; i++)
        layer_draw(w, gl, &wire->layers[i]);
    gl->DepthMask(1);
    gl->Disable(GL_BLEND);
    return STATUS_OK;
}
