/* Draws the domain's floor, faces and edges by OpenGL. */
#ifndef RENDER_WIRE_GL_H
#define RENDER_WIRE_GL_H

#include "render/gl.h"
#include "render/wire.h"

struct wire_gl {
    GLuint program, array, buffer;
    GLint color, half_width, far, parallel; /* uniform locations */
    struct wire wire;
};

/* As sprites_open and sprites_close. */
enum status wire_open(struct wire_gl *wire, const struct gl *gl, struct error *e);
void wire_close(struct wire_gl *wire, const struct gl *gl);

/* Draws over the spheres; view->far is depth 1. STATUS_RUN when memory is short. */
enum status wire_draw(struct wire_gl *wire, const struct gl *gl, const struct wire_view *view,
                      struct error *e);

#endif
