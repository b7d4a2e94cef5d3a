/* Makes the pixels of a picture from the samples that OpenGL drew. */
#ifndef RENDER_RESOLVE_H
#define RENDER_RESOLVE_H

#include "render/gl.h"
#include "scene/scene.h"

#include <stdint.h>

struct resolve {
    GLuint program, array, framebuffer, picture;
    GLuint background; /* texture of a texel for each row of pixels */
    int width, height; /* of the picture, pixels */
    bool over;         /* samples are drawn over nothing; the background is put behind their mean */
};

/* For pictures of so many pixels, each of samples x samples; deep: of 16 bits. As sprites_open and
 * sprites_close. */
enum status resolve_open(struct resolve *resolve, const struct gl *gl, const struct scene *scene, int width,
                         int height, int samples, bool deep, struct error *e);
void resolve_close(struct resolve *resolve, const struct gl *gl);

/* Takes the mean of the samples in the texture `drawn`, rows from the bottom, and reads it back: RGBA bytes,
 * rows from the top. STATUS_BACKEND. */
enum status resolve_read(const struct resolve *resolve, const struct gl *gl, GLuint drawn, uint8_t *rgba,
                         struct error *e);

#endif
