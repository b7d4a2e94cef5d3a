/* The particles of a scene before the first step. */
#ifndef PARTICLES_START_H
#define PARTICLES_START_H

#include "particles/fill.h"

/* Volume (m^3) and particles of each fluid: their quotient is what a particle stands for. */
void start_count(const struct scene *scene, const struct fill *fill, double *fluid_volume,
                 size_t *fluid_particles);

/* Particles at the points of `fill`: ids in that order, velocities and pressures of their bodies
 * and flows, rest density, fields `fields`. STATUS_RUN when memory is short. */
enum status start_bodies(const struct scene *scene, const struct space *space,
                         const struct fill *fill, unsigned fields, struct particles *particles,
                         struct error *e);

/* Wall particles at the points of `fill`: position and id only. */
enum status start_walls(const struct space *space, const struct fill *fill,
                        struct particles *particles, struct error *e);

#endif
