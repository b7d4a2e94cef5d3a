/* Checks the shapes of bodies and obstacles: size, inside the domain, how many. */
#include "scene/load.h"

#include <math.h>

/* The element's place of a key: "max". */
static struct place shape_place(const struct load *load, int array, size_t i, const char *key)
{
    char path[KEY_TEXT_SIZE];
    snprintf(path, sizeof path, "%s%s", scene_arrays[array].prefix, key);
    return load_element_place(load, array, i, path);
}

/* The key to blame for a shape's extent. */
static const char *extent_key(const struct shape *s, int axis)
{
    return s->kind == SHAPE_BOX ? "max" : shape_is_flat(s, axis) ? "height" : "radius";
}

static enum status check_size(struct load *load, int array, size_t i, const struct shape *s)
{
    double min[3], max[3], d = load->scene->particles.spacing;
    const char *name = scene_arrays[array].name;
    shape_bounds(s, min, max);
    for (int a = 0; a < 3; a++) {
        struct place place = shape_place(load, array, i, extent_key(s, a));
        if (!(max[a] > min[a]))
            return load_fail(load, place, "%s.%zu.max is not above %s.%zu.min along %c: %g and %g", name, i, name,
                             i, "xyz"[a], max[a], min[a]);
        if (max[a] - min[a] < d * (1 - 1e-9))
            return load_fail(load, place, "%s.%zu: this %s is %g m along %c, less than "
                             "particles.spacing %g m, and would have no particle; make it larger "
                             "or the spacing smaller", name, i, shape_words[s->kind], max[a] - min[a],
                             "xyz"[a], d);
    }
    return STATUS_OK;
}

static enum status check_inside(struct load *load, int array, size_t i, const struct shape *shape)
{
    const struct scene *s = load->scene;
    double min[3], max[3], slack = 1e-6 * s->particles.spacing;
    shape_bounds(shape, min, max);
    for (int a = 0; a < 3; a++) {
        bool low = min[a] < s->domain.min[a] - slack, high = max[a] > s->domain.max[a] + slack;
        if (!low && !high)
            continue;
        const char *key = shape->kind != SHAPE_BOX ? "center" : low ? "min" : "max";
        return load_fail(load, shape_place(load, array, i, key), "%s.%zu: this %s reaches %c = %g m, "
                         "outside the domain, which %s at %g m; move it in or enlarge the domain",
                         scene_arrays[array].name, i, shape_words[shape->kind], "xyz"[a],
                         low ? min[a] : max[a], low ? "begins" : "ends",
                         low ? s->domain.min[a] : s->domain.max[a]);
    }
    return STATUS_OK;
}

enum status check_shape(struct load *load, int array, size_t i, const struct shape *shape)
{
    enum status status = check_size(load, array, i, shape);
    return status ? status : check_inside(load, array, i, shape);
}

enum status check_obstacles(struct load *load)
{
    struct scene *s = load->scene;
    if (s->obstacle_count > OBSTACLES_MAX)
        return load_fail(load, load->arrays[ARRAY_OBSTACLES].place, "obstacles: there are %zu, and at most %d "
                         "are supported; join or remove some", s->obstacle_count, OBSTACLES_MAX);
    for (size_t i = 0; i < s->obstacle_count; i++) {
        struct scene_obstacle *obstacle = &s->obstacles[i];
        obstacle->place = load_position(load, load->arrays[ARRAY_OBSTACLES].elements[i]);
        if (check_shape(load, ARRAY_OBSTACLES, i, &obstacle->shape))
            return load->e->status;
    }
    return STATUS_OK;
}
