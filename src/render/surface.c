/* Memory and measures of the fluid's surface in the picture. */
#include "render/surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool surface_open(struct surface *f, int width, int height, bool opaque)
{
    memset(f, 0, sizeof *f);
    f->width = width;
    f->height = height;
    f->pitch = (size_t)width + 2 * SURFACE_PAD + CHUNK;
    size_t room = f->pitch * ((size_t)height + 2 * SURFACE_PAD);
    f->depth = malloc(room * sizeof *f->depth);
    f->other = malloc(room * sizeof *f->other);
    f->thickness = calloc(room, sizeof *f->thickness);
    f->ball = malloc(room * sizeof *f->ball);
    f->opaque = opaque;
    f->behind = opaque ? NULL : calloc(room, sizeof *f->behind);
    if (!f->depth || !f->other || !f->thickness || !f->ball || !(opaque || f->behind))
        return false;
    for (size_t i = 0; i < room; i++) {
        f->depth[i] = f->other[i] = INFINITY;
        f->ball[i] = UINT32_MAX;
    }
    /* (1 - (k/(reach + 1))^2)^2: about a Gaussian, without a call of exp. */
    for (int reach = 1; reach <= SURFACE_PAD; reach++)
        for (int k = 0; k <= reach; k++) {
            double u = (double)k / (reach + 1), v = 1 - u * u;
            f->weight[reach][k] = (float)(v * v);
        }
    return true;
}

void surface_close(struct surface *f)
{
    free(f->depth);
    free(f->other);
    free(f->thickness);
    free(f->ball);
    free(f->behind);
    memset(f, 0, sizeof *f);
}

void surface_view(struct surface *f, const struct camera *camera, const struct scene *scene)
{
    for (int a = 0; a < 3; a++) {
        f->axis[0][a] = (float)camera->right[a];
        f->axis[1][a] = (float)camera->up[a];
        f->axis[2][a] = (float)camera->forward[a];
        f->eye[a] = (float)camera->eye[a];
        f->side[a] = (float)(scene->domain.max[a] - scene->domain.min[a]);
    }
    f->half[0] = (float)(f->width / 2.0 / camera_half_x(camera));
    f->half[1] = (float)(-f->height / 2.0 / camera_half_y(camera));
}

void surface_scale(struct surface *f, double radius, double spacing, double samples)
{
    const double pi = 3.14159265358979323846;
    f->far = (float)(4 * radius);
    f->step = (float)radius;
    f->reach = (float)(3.5 * radius * samples);
    f->volume = (float)(spacing * spacing * spacing / (4 * pi / 3 * radius * radius * radius));
}
