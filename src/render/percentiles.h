/* The ends of a colour map by a frame's own values. */
#ifndef RENDER_PERCENTILES_H
#define RENDER_PERCENTILES_H

#include "render/render.h"

/* Sets the range to the scene's percentiles of `count` values; a log scale stays above 0, a symmetric one about
 * it. Of one value only the range stays as it is. */
void percentiles_range(const struct render_setup *setup, const float *values, size_t count,
                       struct color_scale *scale);

#endif
