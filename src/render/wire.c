/* The domain's floor and edges as triangles in the picture. */
#include "render/wire.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/* The point between a (in front of the near distance) and b (behind it) at that distance. */
static void cut(const double a[3], const double b[3], double near, double out[3])
{
    double t = (a[2] - near) / (a[2] - b[2]);
    for (int k = 0; k < 3; k++)
        out[k] = a[k] + t * (b[k] - a[k]);
}

static void project(const struct camera *camera, const double view[3], float out[4])
{
    double scale = camera->orthographic ? 1 : view[2];
    out[0] = (float)(view[0] / (scale * camera_half_x(camera)));
    out[1] = (float)(view[1] / (scale * camera_half_y(camera)));
    out[2] = (float)(camera->orthographic ? view[2] : 1 / view[2]);
    out[3] = 0;
}

/* A line as two triangles, `half` pixels to either side; returns vertices written. */
static size_t line_make(const struct camera *camera, double near, double half, const double a[3],
                        const double b[3], float (*out)[4])
{
    static const int corner_end[LINE_VERTICES] = {0, 1, 0, 0, 1, 1};
    static const int corner_side[LINE_VERTICES] = {-1, -1, 1, 1, -1, 1};
    double end[2][3], dx, dy, length;
    float p[2][4];
    if (a[2] < near && b[2] < near)
        return 0;
    memcpy(end[0], a, sizeof end[0]);
    memcpy(end[1], b, sizeof end[1]);
    if (a[2] < near)
        cut(b, a, near, end[0]);
    if (b[2] < near)
        cut(a, b, near, end[1]);
    project(camera, end[0], p[0]);
    project(camera, end[1], p[1]);
    dx = (p[1][0] - p[0][0]) * camera->width / 2;
    dy = (p[1][1] - p[0][1]) * camera->height / 2;
    length = sqrt(dx * dx + dy * dy);
    if (!(length > 0))
        return 0;
    for (int i = 0; i < LINE_VERTICES; i++) {
        memcpy(out[i], p[corner_end[i]], sizeof out[i]);
        out[i][0] += (float)(corner_side[i] * half * -dy / length * 2 / camera->width);
        out[i][1] += (float)(corner_side[i] * half * dx / length * 2 / camera->height);
        out[i][3] = (float)(corner_side[i] * half);
    }
    return LINE_VERTICES;
}

/* A face as a fan, cut at the near distance; returns vertices written, up to FACE_VERTICES. */
static size_t face_make(const struct camera *camera, double near, double corner[4][3],
                        float (*out)[4])
{
    float p[6][4];
    size_t n = 0, written = 0;
    for (int i = 0; i < 4; i++) {
        const double *a = corner[i], *b = corner[(i + 1) % 4];
        double middle[3];
        if (a[2] >= near)
            project(camera, a, p[n++]);
        if ((a[2] >= near) != (b[2] >= near)) {
            if (a[2] >= near)
                cut(a, b, near, middle);
            else
                cut(b, a, near, middle);
            project(camera, middle, p[n++]);
        }
    }
    for (size_t i = 2; i < n && written + 3 <= FACE_VERTICES; i++) {
        memcpy(out[written++], p[0], sizeof p[0]);
        memcpy(out[written++], p[i - 1], sizeof p[0]);
        memcpy(out[written++], p[i], sizeof p[0]);
    }
    return written;
}

/* The floor is the face that gravity points to; without gravity, the one opposite to up. */
static void floor_find(const struct scene *scene, int *axis, bool *at_max)
{
    double down[3], most = 0;
    const double *g = scene->gravity, *up = scene->camera.up;
    bool gravity = g[0] != 0 || g[1] != 0 || g[2] != 0;
    *axis = 1;
    *at_max = false;
    for (int k = 0; k < 3; k++) {
        down[k] = gravity ? g[k] : -up[k];
        if (fabs(down[k]) > most) {
            most = fabs(down[k]);
            *axis = k;
            *at_max = down[k] > 0;
        }
    }
}

/* Corners of the floor in camera axes; false when it is seen from below. */
static bool floor_corners(const struct scene *scene, const struct camera *camera,
                          double corner[4][3])
{
    static const int around[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    int axis, u, v;
    bool at_max;
    double p[3];
    floor_find(scene, &axis, &at_max);
    u = (axis + 1) % 3;
    v = (axis + 2) % 3;
    for (int i = 0; i < 4; i++) {
        camera_corner(scene, at_max << axis | around[i][0] << u | around[i][1] << v, 0, p);
        camera_view(camera, p, corner[i]);
    }
    return at_max ? camera->eye[axis] < p[axis] : camera->eye[axis] > p[axis];
}

static size_t edges_make(const struct scene *scene, const struct camera *camera, double near,
                         double half, float (*out)[4])
{
    size_t written = 0;
    for (int axis = 0; axis < 3; axis++)
        for (int i = 0; i < 8; i++) {
            double p[3], a[3], b[3];
            if (i >> axis & 1)
                continue;
            camera_corner(scene, i, 0, p);
            camera_view(camera, p, a);
            camera_corner(scene, i | 1 << axis, 0, p);
            camera_view(camera, p, b);
            written += line_make(camera, near, half, a, b, out + written);
        }
    return written;
}

static void layer_add(struct wire *w, float (*vertex)[4], size_t count, float half_width, float ink,
                      float alpha, bool behind)
{
    w->layers[w->count++] = (struct wire_layer){
        .vertex = vertex, .count = count, .half_width = half_width, .color = {ink, ink, ink, alpha},
        .behind = behind};
}

void wire_make(struct wire *w, const struct scene *scene, const struct camera *camera, double far,
               int samples)
{
    double corner[4][3], near = far * 1e-4;
    const double *back = scene->render.background;
    float ink = back[0] * 0.30 + back[1] * 0.59 + back[2] * 0.11 > 0.5 ? 0.0F : 1.0F;
    /* 1.4 pixels at 720 lines, and never thinner than one. */
    double half = fmax(0.5, 0.7 * camera->height / 720) * samples;
    struct camera drawn = *camera; /* counts in drawn pixels */
    size_t count;
    drawn.width *= samples;
    drawn.height *= samples;
    w->count = 0;
    w->parallel = camera->orthographic;
    if (floor_corners(scene, camera, corner)) {
        count = face_make(&drawn, near, corner, w->floor);
        layer_add(w, w->floor, count, 0, ink, 0.07F, false);
    }
    count = edges_make(scene, &drawn, near, half + 0.5, w->edges);
    layer_add(w, w->edges, count, (float)half, ink, 0.55F, false);
    layer_add(w, w->edges, count, (float)half, ink, 0.10F, true);
}
