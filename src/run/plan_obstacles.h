/* Checks that fluid on one side of an obstacle does not feel what is on the other. */
#ifndef RUN_PLAN_OBSTACLES_H
#define RUN_PLAN_OBSTACLES_H

#include "scene/scene.h"

/* Refuses obstacles that are thinner than the support radius, m, between sides that fluid reaches. STATUS_USAGE. */
enum status plan_obstacles(const struct scene *scene, double support, struct error *e);

#endif
