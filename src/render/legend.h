/* The colour bar: colours, ticks, name and unit, at the right edge. */
#ifndef RENDER_LEGEND_H
#define RENDER_LEGEND_H

#include "render/ink.h"
#include "render/layout.h"
#include "render/render.h"

#if HAVE_CAIRO

/* Draws the bar of a picture of movie.size; `box` becomes what it covers. `still`: the scale is that of
 * all frames; else texts keep room for others, so that the bar stands still. */
void legend_draw(const struct ink *ink, const struct render_setup *setup,
                 const struct color_scale *scale, bool still, cairo_t *cr, struct layout_box *box);

#endif
#endif
