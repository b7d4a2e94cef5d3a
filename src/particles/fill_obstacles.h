/* Fills obstacles with boundary particles, and keeps the particles of bodies out of them. */
#ifndef PARTICLES_FILL_OBSTACLES_H
#define PARTICLES_FILL_OBSTACLES_H

#include "particles/fill.h"
#include "scene/solid.h"

/* Appends boundary particles of all obstacles, the outermost half a spacing below the surface, a spacing
 * apart, down to `depth` metres: boxes by lattices, cylinders by rings, spheres by spirals on shells. What lies
 * inside an earlier obstacle is left to that. The same points on every machine. STATUS_RUN when memory is
 * short. */
enum status fill_obstacles(const struct scene *scene, double depth, struct fill *fill,
                           struct error *e);

/* About how many they are. */
double fill_obstacles_estimate(const struct scene *scene, double depth);

/* The obstacles of a scene, made once. */
struct fill_solids {
    const struct scene *scene;
    struct solid solid[OBSTACLES_MAX];
};
void fill_solids_make(struct fill_solids *solids, const struct scene *scene);

/* Whether p, where a body would start a particle, is outside all obstacles. */
bool fill_is_free(const struct fill_solids *solids, const double p[3]);

/* Moves p half a spacing off all obstacles, as far as there is room; false where it then is in one. */
bool fill_make_room(const struct fill_solids *solids, double p[3]);

#endif
