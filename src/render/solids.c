/* Makes flat facets of obstacles, and shades them as spheres are shaded but without shine. */
#include "render/solids.h"

#include "base/portable_math.h"
#include "render/look.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { AROUND = 48, UPWARDS = 24, SHADES = 128 }; /* facets of a circle, a half circle; steps of light */

struct facet {
    double corner[4][3];
    size_t obstacle;
    int shade;    /* 0..SHADES */
    size_t order; /* of making */
};

struct facets {
    const struct scene *scene;
    const struct mesh_view *view;
    struct look look;
    size_t obstacle;
    struct facet *facet;
    size_t count, room;
    bool failed;
};

bool solids_wanted(const struct scene *scene)
{
    for (size_t k = 0; k < scene->obstacle_count; k++)
        if (scene->obstacles[k].visible)
            return true;
    return false;
}

/* How much light comes from a facet whose unit normal, in camera axes, has the cosine `facing` to the viewer
 * (render/look.h). */
static int shade_of(const struct look *look, const double n[3], double facing)
{
    double key = n[0] * (double)look->key[0] + n[1] * (double)look->key[1] - n[2] * (double)look->key[2];
    double light = (double)look->base + (double)look->sky * (0.5 + 0.5 * n[1]) + (double)look->diffuse * fmax(key, 0);
    light *= 1 - (double)look->facing + (double)look->facing * facing;
    return (int)(fmin(light, 1) * SHADES + 0.5);
}

/* The cosine of a facet's unit normal to the viewer, and the normal in camera axes. */
static double facing_of(const struct camera *camera, const double corner[4][3], const double normal[3], double n[3])
{
    double middle[3], tip[3], at[3], along = 0, square = 0;
    for (int a = 0; a < 3; a++) {
        middle[a] = (corner[0][a] + corner[2][a]) / 2;
        tip[a] = middle[a] + normal[a];
    }
    camera_view(camera, middle, at);
    camera_view(camera, tip, n);
    for (int k = 0; k < 3; k++) {
        double ray = !camera->orthographic ? at[k] : k == 2 ? 1 : 0;
        n[k] -= at[k];
        along -= ray * n[k];
        square += ray * ray;
    }
    return along / sqrt(square);
}

/* Keeps the facet if it faces the camera. */
static void facet_add(struct facets *f, const double corner[4][3], const double normal[3])
{
    double n[3], facing = facing_of(&f->view->camera, corner, normal, n);
    if (!(facing > 0))
        return;
    if (f->count == f->room) {
        size_t room = f->room ? 2 * f->room : 1024;
        void *larger = realloc(f->facet, room * sizeof *f->facet);
        f->failed = f->failed || !larger;
        if (!larger)
            return;
        f->facet = larger;
        f->room = room;
    }
    struct facet *facet = &f->facet[f->count];
    *facet = (struct facet){.obstacle = f->obstacle, .order = f->count++,
                            .shade = shade_of(&f->look, n, facing)};
    memcpy(facet->corner, corner, sizeof facet->corner);
}

static void box_make(struct facets *f, const double min[3], const double max[3])
{
    for (int face = 0; face < FACE_COUNT; face++) {
        int a = face / 2, u = (a + 1) % 3, v = (a + 2) % 3;
        double corner[4][3], normal[3] = {0};
        normal[a] = face & 1 ? 1 : -1;
        for (int i = 0; i < 4; i++) {
            corner[i][a] = face & 1 ? max[a] : min[a];
            corner[i][u] = mesh_around[i][0] ? max[u] : min[u];
            corner[i][v] = mesh_around[i][1] ? max[v] : min[v];
        }
        facet_add(f, (const double (*)[3])corner, normal);
    }
}

/* A point of a body of revolution: `along` its axis and `out` from it, from the middle, at step i of AROUND. */
static void round_point(const double middle[3], int axis, double along, double out, int i, double p[3])
{
    const double turn = 2 * 3.14159265358979323846 / AROUND * (i % AROUND);
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    p[axis] = middle[axis] + along;
    p[u] = middle[u] + out * portable_cos(turn);
    p[v] = middle[v] + out * portable_sin(turn);
}

/* A band of facets between two circles about the axis. Normals are those of the surface in the middle of each:
 * `slope` along the axis for 1 outwards. */
static void band_make(struct facets *f, const double middle[3], int axis, const double along[2], const double out[2],
                      double slope)
{
    static const double none[3];
    for (int i = 0; i < AROUND; i++) {
        double corner[4][3], a[3], b[3], normal[3];
        for (int k = 0; k < 4; k++)
            round_point(middle, axis, along[k / 2], out[k / 2], i + (k == 1 || k == 2), corner[k]);
        round_point(none, axis, slope, 1, i, a);
        round_point(none, axis, slope, 1, i + 1, b);
        double square = 0;
        for (int k = 0; k < 3; k++) {
            normal[k] = a[k] + b[k];
            square += normal[k] * normal[k];
        }
        for (int k = 0; k < 3; k++)
            normal[k] /= sqrt(square);
        facet_add(f, (const double (*)[3])corner, normal);
    }
}

static void cap_make(struct facets *f, const double middle[3], int axis, double along, double radius)
{
    double normal[3] = {0}, corner[4][3];
    normal[axis] = along < 0 ? -1 : 1;
    for (int i = 0; i < AROUND; i += 2) {
        round_point(middle, axis, along, 0, 0, corner[0]);
        for (int k = 0; k < 3; k++)
            round_point(middle, axis, along, radius, i + k, corner[1 + k]);
        facet_add(f, (const double (*)[3])corner, normal);
    }
}

static void cylinder_make(struct facets *f, const struct shape *s, const double middle[3])
{
    const double along[2] = {-s->height / 2, s->height / 2}, out[2] = {s->radius, s->radius};
    band_make(f, middle, s->axis, along, out, 0);
    cap_make(f, middle, s->axis, along[0], s->radius);
    cap_make(f, middle, s->axis, along[1], s->radius);
}

static void sphere_make(struct facets *f, const struct shape *s, const double middle[3])
{
    const double step = 3.14159265358979323846 / UPWARDS;
    for (int j = 0; j < UPWARDS; j++) {
        double along[2], out[2], mean = (j + 0.5) * step;
        for (int k = 0; k < 2; k++) {
            along[k] = -s->radius * portable_cos((j + k) * step);
            out[k] = j + k == 0 || j + k == UPWARDS ? 0 : s->radius * portable_sin((j + k) * step);
        }
        band_make(f, middle, 1, along, out, -portable_cos(mean) / portable_sin(mean));
    }
}

/* Facets of one obstacle, relative to domain.min. */
static void obstacle_make(struct facets *f, const struct shape *s)
{
    double min[3], max[3], middle[3];
    shape_bounds(s, min, max);
    for (int a = 0; a < 3; a++) {
        min[a] -= f->scene->domain.min[a];
        max[a] -= f->scene->domain.min[a];
        middle[a] = (min[a] + max[a]) / 2;
    }
    switch (s->kind) {
    case SHAPE_BOX:
        box_make(f, min, max);
        break;
    case SHAPE_SPHERE:
        sphere_make(f, s, middle);
        break;
    case SHAPE_CYLINDER:
        cylinder_make(f, s, middle);
        break;
    }
}

static int by_shade(const void *a, const void *b)
{
    const struct facet *l = a, *r = b;
    if (l->obstacle != r->obstacle)
        return l->obstacle < r->obstacle ? -1 : 1;
    if (l->shade != r->shade)
        return l->shade < r->shade ? -1 : 1;
    return l->order < r->order ? -1 : l->order > r->order;
}

/* Facets of one obstacle and shade, from `first` on; returns where they end. */
static size_t shade_draw(struct wire *wire, const struct facets *f, size_t first)
{
    const struct facet *facet = &f->facet[first];
    const double *color = f->scene->obstacles[facet->obstacle].color;
    const double light = (double)facet->shade / SHADES;
    size_t i = first;
    for (; i < f->count && f->facet[i].obstacle == facet->obstacle && f->facet[i].shade == facet->shade; i++)
        mesh_face(&wire->mesh, f->view, (const double (*)[3])f->facet[i].corner, NULL);
    wire_layer_end(wire, (struct wire_layer){.color = {(float)(color[0] * light), (float)(color[1] * light),
                                                       (float)(color[2] * light), 1},
                                             .solid = true, .back = true});
    return i;
}

void solids_make(struct wire *wire, const struct scene *scene, const struct mesh_view *view)
{
    struct facets f = {.scene = scene, .view = view, .look = look_make(0)};
    for (f.obstacle = 0; f.obstacle < scene->obstacle_count; f.obstacle++)
        if (scene->obstacles[f.obstacle].visible)
            obstacle_make(&f, &scene->obstacles[f.obstacle].shape);
    if (f.count)
        qsort(f.facet, f.count, sizeof *f.facet, by_shade);
    for (size_t i = 0; i < f.count;)
        i = shade_draw(wire, &f, i);
    wire->mesh.failed = wire->mesh.failed || f.failed;
    free(f.facet);
}
