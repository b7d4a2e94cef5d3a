/* The domain: its floor, and its edges as thin lines, faint where something is in front. */
#ifndef RENDER_WIRE_H
#define RENDER_WIRE_H

#include "render/camera.h"
#include "render/gl.h"

struct wire {
    GLuint program, array, buffer;
    GLint color, half_width, far; /* uniform locations */
};

/* As sprites_open and sprites_close. */
enum status wire_open(struct wire *wire, const struct gl *gl, struct error *e);
void wire_close(struct wire *wire, const struct gl *gl);

/* Draw over the spheres; `far` m is depth 1, `samples` the pixels drawn per pixel shown, in x. */
void wire_draw(const struct wire *wire, const struct gl *gl, const struct scene *scene,
               const struct camera *camera, double far, int samples);

#endif
