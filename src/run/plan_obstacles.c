/* Finds obstacles through which fluid would feel fluid. */
#include "run/plan_obstacles.h"

#include "scene/solid.h"

static enum status fail_thin(const struct scene *scene, size_t k, int axis, double thick, double support,
                             struct error *e)
{
    const struct scene_obstacle *o = &scene->obstacles[k];
    return scene_fail_at(scene, o->place, e, "obstacles.%zu: this %s is %.4g m thick along %c, less than the "
                         "support radius of %.4g m, and fluid on either side of it would feel the other; make it "
                         "that thick, or particles.spacing %.3g m or less", k, shape_words[o->shape.kind], thick,
                         "xyz"[axis], support, scene->particles.spacing * thick / support * 0.99);
}

enum status plan_obstacles(const struct scene *scene, double support, struct error *e)
{
    for (size_t k = 0; k < scene->obstacle_count; k++) {
        const struct solid solid = solid_make(scene, &scene->obstacles[k]);
        double min[3], max[3];
        shape_bounds(&scene->obstacles[k].shape, min, max);
        for (int a = 0; a < 3; a++)
            if (solid.open[2 * a] && solid.open[2 * a + 1] && max[a] - min[a] < support * (1 - 1e-6))
                return fail_thin(scene, k, a, max[a] - min[a], support, e);
    }
    return STATUS_OK;
}
