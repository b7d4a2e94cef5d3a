/* Fills the bodies of a scene with particles, and its walls with boundary particles. */
#ifndef PARTICLES_FILL_H
#define PARTICLES_FILL_H

#include "particles/particles.h"
#include "particles/space.h"
#include "scene/scene.h"

/* Points at which particles start: metres, absolute; body index each. */
struct fill {
    size_t count, room;
    double (*point)[3];
    int *body; /* index into scene->bodies; -1 for walls */
};

/* Points of all bodies: lattice cells whose centre lies inside, displaced by `jitter`, or as many
 * uniformly random points; those in obstacles are left out. The same points on every machine: random
 * numbers depend on (seed, index) alone. STATUS_RUN when memory is short, STATUS_USAGE when obstacles
 * leave nothing of a body. */
enum status fill_bodies(const struct scene *scene, struct fill *fill, struct error *e);

/* About how many points fill_bodies and fill_walls make; of boxes and walls, exactly. */
double fill_bodies_estimate(const struct scene *scene);
double fill_walls_estimate(const struct scene *scene, double depth);

/* Volume that each particle of a body stands for, m^3; of a lattice body, one cell. */
double fill_cell_volume(const struct scene *scene, const struct scene_body *body);

/* Lattice layers outside the faces that are made of particles, `depth` metres deep. */
enum status fill_walls(const struct scene *scene, double depth, struct fill *fill,
                       struct error *e);

/* Appends a point. STATUS_RUN when memory is short. */
enum status fill_add(struct fill *fill, const double p[3], int body, struct error *e);

/* Moves a point that lies outside the domain, or on its faces, just inside. */
void fill_keep_inside(const struct scene *scene, double p[3]);

void fill_free(struct fill *fill);

#endif
