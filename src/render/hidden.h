/* Leaves out spheres that others hide completely, before they cost any drawing. */
#ifndef RENDER_HIDDEN_H
#define RENDER_HIDDEN_H

#include "render/camera.h"

#include <stddef.h>
#include <stdint.h>

/* Packed particles: x y z as float bits, and one word that is kept as it is. Moves those that may
 * be seen to the front, in their order, and returns how many; the picture does not change.
 * `radius` in m; `samples` of a pixel, in x and in y; `depth` is room for width * height floats of the camera. */
size_t hidden_drop(const struct camera *camera, uint32_t (*packed)[4], size_t count,
                   double radius, int samples, float *depth);

#endif
