/* Projects lines and faces, cut at the near distance. */
#include "render/mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LINE_VERTICES = 6, CORNERS_MAX = 5 };

const int mesh_around[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

static float *vertex_add(struct mesh *m, const float vertex[4])
{
    static float nowhere[4];
    if (m->count == m->room) {
        size_t room = m->room ? 2 * m->room : 1024;
        void *larger = realloc(m->vertex, room * sizeof *m->vertex);
        if (!larger) {
            m->failed = true;
            return nowhere;
        }
        m->vertex = larger;
        m->room = room;
    }
    return memcpy(m->vertex[m->count++], vertex, sizeof *m->vertex);
}

/* The point between a (in front of the near distance) and b (behind it) at that distance; the fourth
 * number goes along. */
static void cut(const double a[4], const double b[4], double near, double out[4])
{
    double t = (a[2] - near) / (a[2] - b[2]);
    for (int k = 0; k < 4; k++)
        out[k] = a[k] + t * (b[k] - a[k]);
}

static void project(const struct camera *camera, const double at[4], float out[4])
{
    double scale = camera->orthographic ? 1 : at[2];
    out[0] = (float)(at[0] / (scale * camera_half_x(camera)));
    out[1] = (float)(at[1] / (scale * camera_half_y(camera)));
    out[2] = (float)(camera->orthographic ? at[2] : 1 / at[2]);
    out[3] = (float)at[3];
}

void mesh_line(struct mesh *m, const struct mesh_view *view, const double a[3], const double b[3],
               double half)
{
    static const int corner_end[LINE_VERTICES] = {0, 1, 0, 0, 1, 1};
    static const int corner_side[LINE_VERTICES] = {-1, -1, 1, 1, -1, 1};
    const struct camera *camera = &view->camera;
    double end[2][4] = {{0}}, p[2][4], wide = half + 0.5;
    float at[2][4];
    camera_view(camera, a, end[0]);
    camera_view(camera, b, end[1]);
    if (end[0][2] < view->near && end[1][2] < view->near)
        return;
    memcpy(p, end, sizeof p);
    for (int i = 0; i < 2; i++)
        if (end[i][2] < view->near)
            cut(end[1 - i], end[i], view->near, p[i]);
    project(camera, p[0], at[0]);
    project(camera, p[1], at[1]);
    double dx = (at[1][0] - at[0][0]) * camera->width / 2, dy = (at[1][1] - at[0][1]) * camera->height / 2;
    double length = sqrt(dx * dx + dy * dy);
    if (!(length > 0))
        return;
    for (int i = 0; i < LINE_VERTICES; i++) {
        float *v = vertex_add(m, at[corner_end[i]]);
        v[0] += (float)(corner_side[i] * wide * -dy / length * 2 / camera->width);
        v[1] += (float)(corner_side[i] * wide * dx / length * 2 / camera->height);
        v[3] = (float)(corner_side[i] * wide);
    }
}

void mesh_face(struct mesh *m, const struct mesh_view *view, const double corner[4][3], const float *cover)
{
    double at[4][4], middle[4];
    float p[CORNERS_MAX][4];
    size_t n = 0;
    for (int i = 0; i < 4; i++) {
        camera_view(&view->camera, corner[i], at[i]);
        at[i][3] = cover ? 1 - (double)cover[i] : 0;
    }
    for (int i = 0; i < 4; i++) {
        const double *a = at[i], *b = at[(i + 1) % 4];
        bool seen = a[2] >= view->near;
        if (seen)
            project(&view->camera, a, p[n++]);
        if (seen != (b[2] >= view->near)) {
            cut(seen ? a : b, seen ? b : a, view->near, middle);
            project(&view->camera, middle, p[n++]);
        }
    }
    for (size_t i = 2; i < n; i++) {
        vertex_add(m, p[0]);
        vertex_add(m, p[i - 1]);
        vertex_add(m, p[i]);
    }
}

void mesh_free(struct mesh *m)
{
    free(m->vertex);
    memset(m, 0, sizeof *m);
}
