/* Moves the camera along its keyframes by Catmull-Rom splines. */
#include "render/camera_path.h"

#include <math.h>
#include <string.h>

/* Every member is a number to be moved. */
_Static_assert(sizeof(struct scene_keyframe) == 11 * sizeof(double), "only doubles");

static const double fov_least = 1, fov_most = 150; /* degrees: curves may pass over their keys */

/* A number of each keyframe. */
struct track {
    const struct scene_keyframe *keys;
    size_t count, offset;
};

static double value(const struct track *t, size_t i)
{
    double number;
    memcpy(&number, (const char *)&t->keys[i] + t->offset, sizeof number);
    return number;
}

/* Mean speed from key i to the next. */
static double speed(const struct track *t, size_t i)
{
    return (value(t, i + 1) - value(t, i)) / (t->keys[i + 1].time - t->keys[i].time);
}

/* The speed at key i: of the parabola through it and its neighbours, so that equal speeds stay equal
 * for any spacing of the times; at the ends that of the only segment. */
static double tangent(const struct track *t, size_t i)
{
    if (i == 0 || i == t->count - 1)
        return speed(t, i ? i - 1 : 0);
    double before = t->keys[i].time - t->keys[i - 1].time;
    double after = t->keys[i + 1].time - t->keys[i].time;
    return (speed(t, i - 1) * after + speed(t, i) * before) / (before + after);
}

/* Catmull and Rom (1974) with the times as knots, as a cubic Hermite curve of key i to the next; at
 * the keys their numbers exactly. */
static double curve(const struct track *t, size_t i, double time)
{
    double length = t->keys[i + 1].time - t->keys[i].time, u = (time - t->keys[i].time) / length;
    double v = 1 - u, mean = speed(t, i);
    return v * value(t, i) + u * value(t, i + 1) +
           u * v * length * (v * (tangent(t, i) - mean) - u * (tangent(t, i + 1) - mean));
}

/* The key that stands for `time`: the last that is not after it, or the first. */
static size_t key_before(const struct scene_keyframe *keys, size_t count, double time)
{
    size_t i = 0;
    while (i + 1 < count && keys[i + 1].time <= time)
        i++;
    return i;
}

/* A keyframe without gaps. */
static void resolve(const struct scene *scene, struct scene_keyframe *key)
{
    for (int k = 0; k < 3; k++) {
        double middle = (scene->domain.min[k] + scene->domain.max[k]) / 2;
        if (!isfinite(key->target[k]))
            key->target[k] = isfinite(scene->camera.target[k]) ? scene->camera.target[k] : middle;
        if (isnan(key->up[k]))
            key->up[k] = scene->camera.up[k];
    }
    if (isnan(key->fov))
        key->fov = scene->camera.fov;
}

static void still(const struct scene *scene, struct scene_keyframe *at)
{
    memcpy(at->eye, scene->camera.eye, sizeof at->eye);
    memcpy(at->target, scene->camera.target, sizeof at->target);
    memcpy(at->up, scene->camera.up, sizeof at->up);
    at->fov = scene->camera.fov;
    resolve(scene, at);
}

void camera_path(const struct scene *scene, double time, struct scene_keyframe *at)
{
    size_t count = scene->keyframe_count, i = key_before(scene->keyframes, count, time);
    *at = (struct scene_keyframe){.time = time};
    if (!count) {
        still(scene, at);
        return;
    }
    /* The curve reads one key to either side of the two. */
    size_t first = i ? i - 1 : 0, keys = count - first < 4 ? count - first : 4;
    struct scene_keyframe near[4];
    for (size_t k = 0; k < keys; k++) {
        near[k] = scene->keyframes[first + k];
        resolve(scene, &near[k]);
    }
    i -= first;
    if (!(time > near[i].time) || i + 1 == keys) {
        *at = near[i];
        at->time = time;
        return;
    }
    for (size_t offset = offsetof(struct scene_keyframe, eye); offset < sizeof *at;
         offset += sizeof(double)) {
        struct track track = {near, keys, offset};
        double number = curve(&track, i, time);
        memcpy((char *)at + offset, &number, sizeof number);
    }
    at->fov = fmin(fov_most, fmax(fov_least, at->fov));
}
