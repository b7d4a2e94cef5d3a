/* Fixed-point positions: metres to 32-bit integers and back, one scale per axis.
 *
 * A coordinate is an unsigned 32-bit count of `unit[a]` metres from `origin[a]`. A periodic axis
 * spans exactly 2^32 units, so that the signed difference of two coordinates is already the
 * nearest image; other axes use the lower half, 2^31 units, and end two spacings above the upper
 * plane, so that a particle that crosses either plane in a step is seen on that side. Differences are exact, so accuracy does
 * not depend on where the domain lies or how large it is. */
#ifndef PARTICLES_SPACE_H
#define PARTICLES_SPACE_H

#include "scene/scene.h"

#include <stdbool.h>
#include <stdint.h>

struct space {
    double origin[3]; /* m */
    double length[3]; /* m, including what lies outside the domain */
    double unit[3];   /* m per count */
    bool periodic[3];
    uint32_t low[3], high[3]; /* the domain's planes, counts; not used on periodic axes */
};

/* The space of a scene; `margin` is added outside faces that carry wall particles, m. */
struct space space_create(const struct scene *scene, double margin);

/* Metres (absolute) to counts, rounded to nearest; the point must lie inside. */
uint32_t space_count(const struct space *space, int axis, double metres);

/* Counts to metres, absolute. */
double space_metres(const struct space *space, int axis, uint32_t count);

#endif
