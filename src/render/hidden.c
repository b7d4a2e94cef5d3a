/* Leaves out spheres that others hide completely, before they cost any drawing.
 *
 * In a body of fluid most spheres are out of sight, and a software rasteriser pays for each of
 * their pixels, because spheres write their own depth. Two sweeps find them: the first keeps for
 * each pixel the least depth behind which nothing can be seen, the second drops the spheres that
 * are behind it on all their pixels. Both err on the side of drawing. */
#include "render/hidden.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

struct projection { /* from camera axes to pixels, y upwards */
    float scale_x, scale_y, middle_x, middle_y;
    int width, height;
    bool parallel; /* orthographic: nothing gets smaller with distance */
    float reach; /* of samples from the middle of a pixel, in x and in y */
};

static bool position_view(const struct camera *camera, const uint32_t particle[4], float view[3])
{
    float p[3];
    memcpy(p, particle, sizeof p);
    for (int k = 0; k < 3; k++) {
        const double *axis = k == 0 ? camera->right : k == 1 ? camera->up : camera->forward;
        view[k] = (float)((p[0] - camera->eye[0]) * axis[0] + (p[1] - camera->eye[1]) * axis[1] +
                          (p[2] - camera->eye[2]) * axis[2]);
    }
    return isfinite(view[0]) && isfinite(view[1]) && isfinite(view[2]);
}

/* x rounded down and one more, 0..count; plain C, as floorf is a call on the oldest x86-64. */
static int index_above(float x, int count)
{
    return x >= 0 ? x < (float)(count - 1) ? (int)x + 1 : count : 0;
}

static int index_below(float x, int count)
{
    return x > 0 ? x < (float)count ? (int)x : count : 0;
}

/* The disc through the centre, parallel to the picture, lies in the sphere: what is seen in its
 * projection, a circle, is in front of the centre. */
static void cover(const struct projection *to, const float view[3], float radius, float *depth)
{
    float z = to->parallel ? 1 : view[2];
    float x = to->middle_x + to->scale_x * view[0] / z;
    float y = to->middle_y + to->scale_y * view[1] / z;
    float scale = to->scale_x < to->scale_y ? to->scale_x : to->scale_y;
    float r = scale * radius / z * 0.995F - 0.01F;
    int bottom = index_above(y - r + to->reach - 0.5F, to->height);
    int top = index_above(y + r - to->reach - 0.5F, to->height);
    for (int row = bottom; row < top; row++) {
        float dy = fabsf((float)row + 0.5F - y) + to->reach;
        float half2 = r * r - dy * dy, half = half2 > 0 ? sqrtf(half2) - to->reach : -1;
        int left = index_above(x - half - 0.5F, to->width);
        int right = index_above(x + half - 0.5F, to->width);
        float *line = depth + (size_t)row * (size_t)to->width;
        for (int column = left; column < right; column++)
            if (view[2] < line[column])
                line[column] = view[2];
    }
}

/* First and last + 1 pixel of the projection of center +- radius at distances near and far. */
static void extent(float center, float radius, float near, float far, float scale, float middle, int count,
                   int *first, int *end)
{
    float low = center - radius, high = center + radius;
    low /= low < 0 ? near : far;
    high /= high > 0 ? near : far;
    *first = index_below(middle + scale * low - 0.02F, count);
    *end = index_above(middle + scale * high + 0.02F, count);
}

/* Behind what covers each pixel of its bounding box? Out of the picture counts as hidden. */
static bool is_hidden(const struct projection *to, const float view[3], float radius,
                      const float *depth)
{
    int left, right, bottom, top;
    float front = view[2] - 1.001F * radius - 1e-6F * view[2];
    float near = to->parallel ? 1 : view[2] - radius, far = to->parallel ? 1 : view[2] + radius;
    extent(view[0], radius, near, far, to->scale_x, to->middle_x, to->width, &left, &right);
    extent(view[1], radius, near, far, to->scale_y, to->middle_y, to->height, &bottom, &top);
    for (int row = bottom; row < top; row++) {
        const float *line = depth + (size_t)row * (size_t)to->width;
        for (int column = left; column < right; column++)
            if (!(line[column] < front))
                return false;
    }
    return true;
}

size_t hidden_drop(const struct camera *camera, uint32_t (*packed)[4], size_t count,
                   double radius, int samples, float *depth)
{
    float r = (float)radius, view[3];
    size_t kept = 0;
    struct projection to = {
        .middle_x = (float)camera->width / 2, .middle_y = (float)camera->height / 2,
        .width = camera->width, .height = camera->height, .parallel = camera->orthographic,
        .reach = (float)(samples - 1) / (float)(2 * samples)};
    to.scale_x = to.middle_x / (float)camera_half_x(camera);
    to.scale_y = to.middle_y / (float)camera_half_y(camera);
    for (size_t i = 0; i < (size_t)to.width * (size_t)to.height; i++)
        depth[i] = INFINITY;
    for (size_t i = 0; i < count; i++)
        if (position_view(camera, packed[i], view) && view[2] > 2 * r)
            cover(&to, view, r, depth);
    for (size_t i = 0; i < count; i++) {
        if (!position_view(camera, packed[i], view) || view[2] < -r)
            continue; /* not a number, or behind the eye */
        if (view[2] > 2 * r && is_hidden(&to, view, r, depth))
            continue;
        memmove(packed[kept++], packed[i], sizeof packed[i]);
    }
    return kept;
}
