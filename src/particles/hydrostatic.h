/* Which bodies start under the weight of the fluid above them, and the pressure that it makes. */
#ifndef PARTICLES_HYDROSTATIC_H
#define PARTICLES_HYDROSTATIC_H

#include "scene/scene.h"

struct hydrostatic {
    const struct scene *scene;
    double gravity;  /* m/s^2 */
    double up[3];    /* unit vector against gravity; zero without gravity */
    int axis;        /* along which gravity acts, or -1 */
    bool *body;      /* by body: starts hydrostatic */
};

/* A body with bodies[].start "hydrostatic" does; with "auto", when it is a settled tank: a box that
 * stands still and whose every face but the upper one touches a closed wall, another such body,
 * or, through a periodic face, one of those again. Not when gravity acts along a periodic axis.
 * STATUS_RUN when memory is short. */
enum status hydrostatic_create(struct hydrostatic *h, const struct scene *scene, struct error *e);
void hydrostatic_free(struct hydrostatic *h);

/* Pressure at x in that body, Pa: density |g| depth below the body's highest point, and the same
 * through each hydrostatic body that is stacked above x (gravity along an axis). */
double hydrostatic_pressure(const struct hydrostatic *h, size_t body, const double x[3]);

#endif
