/* Particles as the cpu renderer's spheres: what its loops that put them into camera axes read. */
#ifndef RENDER_PROJECT_H
#define RENDER_PROJECT_H

#include "render/maps.h"
#include "render/place.h"
#include "render/scale.h"
#include "render/splat.h"

/* Loops of render/project_loops.h, of each instruction set, for at most CHUNK particles: */
struct project_loops {
    /* Spheres without colour. One without extent is out of sight: behind the eye, around it, between
     * samples, or not a number. `position`: x y z of each, m. */
    void (*place)(const struct viewpoint *view, const float *position, size_t count, struct ball *balls);
    /* Their colours; `map`: MAP_SIZE colours, red in the lowest byte. */
    void (*color)(const struct color_scale *scale, const uint32_t *map, const float *value, size_t count,
                  struct ball *balls);
};

#endif
