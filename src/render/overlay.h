/* What is written over a frame: colour bar, title, time stamp, labels, scale bar and axes. */
#ifndef RENDER_OVERLAY_H
#define RENDER_OVERLAY_H

#include "render/render.h"

struct overlay;

/* Places all parts, and draws what stays the same for the film. *overlay is NULL when the scene wants
 * nothing, the picture is too small for text, or the build has no cairo. STATUS_RUN when memory is
 * short. The setup must outlive it. */
enum status overlay_open(struct overlay **overlay, const struct render_setup *setup,
                         struct error *e);

/* Puts it over a frame of movie.size. Accepts NULL. */
void overlay_draw(struct overlay *overlay, const struct render_frame *frame, struct image *image);

/* Adds the same to image->over (base/vectors.h) as lines and text, its upper left at (left, top). */
void overlay_record(const struct render_setup *setup, const struct render_frame *frame,
                    struct image *image, int left, int top);
void overlay_close(struct overlay *overlay);

#endif
