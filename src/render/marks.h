/* Marks of space over a picture: a length, and the directions of the axes. */
#ifndef RENDER_MARKS_H
#define RENDER_MARKS_H

#include "render/camera.h"
#include "render/ink.h"
#include "render/layout.h"

#if HAVE_CAIRO

/* Pixels that a mark takes. */
void marks_bar_size(const struct ink *ink, const struct scene *scene, cairo_t *cr, double *width,
                    double *height);
double marks_axes_size(const struct ink *ink);

/* A round length in the box, true at the distance of the camera's target, which it says, and nothing
 * when that is behind the eye; orthographic, it is true everywhere. */
void marks_bar_draw(const struct ink *ink, const struct scene *scene, const struct camera *camera,
                    const struct layout_box *box, cairo_t *cr);
void marks_axes_draw(const struct ink *ink, const struct camera *camera,
                     const struct layout_box *box, cairo_t *cr);

#endif
#endif
