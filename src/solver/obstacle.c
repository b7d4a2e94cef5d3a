/* Turns the obstacles of a scene into what stops particles. */
#include "scene/solid.h"
#include "solver/solver.h"

#include <math.h>

/* A flat face as counts from the middle, rounded outwards. */
static int64_t face_counts(const struct solid *solid, const struct space *space, int face, double at)
{
    double counts = (at - space_metres(space, face / 2, space_count(space, face / 2, solid->middle[face / 2]))) /
                    space->unit[face / 2];
    int64_t most = face & 1 ? OBSTACLE_FAR : -OBSTACLE_FAR;
    return !solid->open[face] ? most : (int64_t)(face & 1 ? ceil(counts) : floor(counts));
}

static struct obstacle obstacle_make(const struct scene_obstacle *from, const struct solid *solid,
                                     const struct space *space)
{
    struct obstacle o = {.radius = from->shape.radius};
    double min[3], max[3];
    shape_bounds(&from->shape, min, max);
    for (int a = 0; a < 3; a++) {
        o.middle[a] = space_count(space, a, solid->middle[a]);
        o.flat[a] = shape_is_flat(&from->shape, a);
        o.low[a] = face_counts(solid, space, 2 * a, min[a]);
        o.high[a] = face_counts(solid, space, 2 * a + 1, max[a]);
    }
    return o;
}

void obstacles_choose(const struct scene *scene, const struct space *space, struct solver_choice *choice)
{
    struct obstacles *all = &choice->each.obstacles;
    all->count = (int)scene->obstacle_count;
    all->restitution = (float)scene->domain.restitution;
    for (int a = 0; a < 3; a++)
        all->unit[a] = space->unit[a];
    for (int k = 0; k < all->count; k++) {
        const struct solid solid = solid_make(scene, &scene->obstacles[k]);
        all->obstacle[k] = obstacle_make(&scene->obstacles[k], &solid, space);
    }
    choice->wall_particles = choice->wall_particles || all->count > 0;
}
