/* Checks the camera, of the whole film or at each keyframe: direction, up, order of times. */
#include "scene/load.h"

#include <math.h>
#include <stdio.h>

static double length(const double v[3])
{
    return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static const double *either(const double *own, const double *else_this)
{
    return isnan(own[0]) ? else_this : own;
}

/* `name` is what messages call the camera; the places are those of its eye and up. */
static enum status check_view(struct load *load, const struct scene_keyframe *at, const char *name,
                              struct place eye, struct place up)
{
    double view[3], across[3];
    for (int a = 0; a < 3; a++)
        view[a] = at->target[a] - at->eye[a];
    if (!(length(at->up) > 0))
        return load_fail(load, up, "%s.up has no direction; the usual one is [0, 1, 0]", name);
    if (isnan(at->eye[0]))
        return STATUS_OK;
    if (!(length(view) > 0))
        return load_fail(load, eye, "%s.eye is its target; move it away", name);
    for (int a = 0; a < 3; a++)
        across[a] = view[(a + 1) % 3] * at->up[(a + 2) % 3] - view[(a + 2) % 3] * at->up[(a + 1) % 3];
    if (length(across) < 1e-6 * length(view) * length(at->up))
        return load_fail(load, up, "%s.up points along the view; choose another direction, for "
                         "example [0, 0, 1]", name);
    return STATUS_OK;
}

static enum status check_keyframe(struct load *load, const double target[3], size_t i)
{
    const struct scene *s = load->scene;
    const struct scene_keyframe *key = &s->keyframes[i];
    struct scene_keyframe at = *key;
    char name[40];
    snprintf(name, sizeof name, "camera.keyframes.%zu", i);
    if (i > 0 && !(key->time > key[-1].time))
        return load_fail(load, load_element_place(load, ARRAY_KEYFRAMES, i,
                         "camera.keyframes[].time"), "%s.time %g s is not after the %g s of the one "
                         "before; put the keyframes in order", name, key->time, key[-1].time);
    for (int a = 0; a < 3; a++) {
        at.target[a] = either(key->target, target)[a];
        at.up[a] = either(key->up, s->camera.up)[a];
    }
    return check_view(load, &at, name,
                      load_element_place(load, ARRAY_KEYFRAMES, i, "camera.keyframes[].eye"),
                      load_element_place(load, ARRAY_KEYFRAMES, i, "camera.keyframes[].up"));
}

enum status check_camera(struct load *load)
{
    const struct scene *s = load->scene;
    struct scene_keyframe still = {.time = 0};
    double middle[3];
    for (int a = 0; a < 3; a++) {
        middle[a] = (s->domain.min[a] + s->domain.max[a]) / 2;
        still.eye[a] = s->camera.eye[a];
        still.target[a] = isnan(s->camera.target[0]) ? middle[a] : s->camera.target[a];
        still.up[a] = s->camera.up[a];
    }
    if (s->keyframe_count && !isnan(s->camera.eye[0]))
        return load_fail(load, load_place(load, "camera.eye"), "camera.eye and camera.keyframes: the "
                         "camera can be at one place only; remove either");
    enum status status = check_view(load, &still, "camera", load_place(load, "camera.eye"),
                                    load_place(load, "camera.up"));
    for (size_t i = 0; i < s->keyframe_count && !status; i++)
        status = check_keyframe(load, still.target, i);
    return status;
}
