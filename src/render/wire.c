/* Chooses what is drawn of the domain: obstacles, then layer by layer from the back. */
#include "render/wire.h"

#include "render/solids.h"
#include "render/ticks.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* What a layer is made with. */
struct drawing {
    struct wire *wire;
    const struct scene *scene;
    const struct wire_view *wished;
    struct mesh_view view;
    double half; /* of a line, drawn pixels */
    float ink;
};

static enum floor_style floor_style_of(const struct scene *scene)
{
    enum floor_style style = scene->render.floor;
    return style != FLOOR_AUTO ? style : scene->render.box ? FLOOR_PLAIN : FLOOR_NONE;
}

bool wire_wanted(const struct scene *scene)
{
    return scene->render.box || floor_style_of(scene) != FLOOR_NONE || solids_wanted(scene);
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

/* Whether a face is on the far side: what is seen of it is inside the domain. */
static bool face_is_back(const struct drawing *d, int axis, bool at_max)
{
    const struct camera *camera = &d->view.camera;
    double p[3];
    camera_corner(d->scene, at_max << axis, 0, p);
    double toward = camera->orthographic ? -camera->forward[axis] : camera->eye[axis] - p[axis];
    return at_max ? toward < 0 : toward > 0;
}

/* Room for another layer; false when memory is short. */
static bool layer_room(struct wire *w)
{
    if (w->count < w->room)
        return true;
    size_t room = w->room ? 2 * w->room : 16;
    void *larger = realloc(w->layers, room * sizeof *w->layers);
    w->mesh.failed = w->mesh.failed || !larger;
    if (!larger)
        return false;
    w->layers = larger;
    w->room = room;
    return true;
}

void wire_layer_end(struct wire *w, struct wire_layer layer)
{
    layer.first = w->count ? w->layers[w->count - 1].first + w->layers[w->count - 1].count : 0;
    layer.count = w->mesh.count - layer.first;
    if (layer_room(w))
        w->layers[w->count++] = layer;
}

/* The same in ink. */
static void layer_end(const struct drawing *d, float half_width, float alpha, bool back)
{
    wire_layer_end(d->wire, (struct wire_layer){.half_width = half_width, .back = back,
                                                .color = {d->ink, d->ink, d->ink, alpha}});
}

/* The rectangle of a face between two places along each of the axes after its own; cover as of mesh_face. */
static void patch_make(const struct drawing *d, int axis, bool at_max, const double low[2],
                       const double high[2], const float *cover)
{
    double corner[4][3];
    for (int i = 0; i < 4; i++) {
        camera_corner(d->scene, at_max << axis, 0, corner[i]);
        for (int k = 0; k < 2; k++)
            corner[i][(axis + 1 + k) % 3] = mesh_around[i][k] ? high[k] : low[k];
    }
    mesh_face(&d->wire->mesh, &d->view, (const double (*)[3])corner, cover);
}

static void face_make(const struct drawing *d, int axis, bool at_max)
{
    const double *min = d->scene->domain.min, *max = d->scene->domain.max, low[2] = {0, 0};
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    patch_make(d, axis, at_max, low, (const double[2]){max[u] - min[u], max[v] - min[v]}, NULL);
}

/* Squares of a floor: multiples of `step` m along the axes after its own. */
struct squares {
    int axis;
    bool at_max;
    double step, origin[2], side[2]; /* domain.min along the axes; and the floor's sides, m */
};

enum { SQUARES_MAX = 12 }; /* ten or so along the longer side */

static struct squares squares_make(const struct scene *scene, int axis, bool at_max)
{
    struct squares s = {.axis = axis, .at_max = at_max};
    for (int k = 0; k < 2; k++) {
        int a = (axis + 1 + k) % 3;
        s.origin[k] = scene->domain.min[a];
        s.side[k] = scene->domain.max[a] - scene->domain.min[a];
    }
    s.step = ticks_round(fmax(s.side[0], s.side[1]) / SQUARES_MAX * 2);
    return s;
}

/* Lines across axis k of the floor; none on its edges. */
static void grid_lines(const struct drawing *d, const struct squares *s, int k)
{
    int u = (s->axis + 1 + k) % 3, v = (s->axis + 2 - k) % 3;
    double first = floor(s->origin[k] / s->step);
    for (int i = 0;; i++) {
        double at = (first + i) * s->step - s->origin[k], a[3], b[3];
        if (at > s->side[k] - 1e-6 * s->step)
            return;
        if (at < 1e-6 * s->step)
            continue;
        camera_corner(d->scene, s->at_max << s->axis, 0, a);
        memcpy(b, a, sizeof b);
        a[u] = b[u] = at;
        a[v] = 0;
        b[v] = s->side[1 - k];
        mesh_line(&d->wire->mesh, &d->view, a, b, 0.7 * d->half);
    }
}

/* Where square i of an axis is, cut to the floor; false beyond it. */
static bool square_cut(const struct squares *s, int k, int i, double *low, double *high)
{
    double start = (floor(s->origin[k] / s->step) + i) * s->step - s->origin[k];
    *low = fmax(start, 0);
    *high = fmin(start + s->step, s->side[k]);
    return start < s->side[k];
}

static void checker_make(const struct drawing *d, const struct squares *s)
{
    double low[2], high[2];
    for (int i = 0; square_cut(s, 0, i, &low[0], &high[0]); i++)
        for (int j = 0; square_cut(s, 1, j, &low[1], &high[1]); j++)
            if ((i + j) % 2 == 0 && high[0] > low[0] && high[1] > low[1])
                patch_make(d, s->axis, s->at_max, low, high, NULL);
}

/* Cells of the grid that anything shades. */
static void shadow_draw(const struct drawing *d, struct shadow_floor floor)
{
    struct shadow *s = &d->wire->shadow;
    shadow_make(s, d->scene, d->wished->camera, floor, d->wished->frame, d->wished->threads);
    for (int i = 0; i < s->cells[0]; i++)
        for (int j = 0; j < s->cells[1]; j++) {
            double low[2] = {i * s->cell[0], j * s->cell[1]};
            double high[2] = {(i + 1) * s->cell[0], (j + 1) * s->cell[1]};
            float taken[4], most = 0;
            for (int k = 0; k < 4; k++) {
                taken[k] = shadow_taken(s, i + mesh_around[k][0], j + mesh_around[k][1]);
                most = fmaxf(most, taken[k]);
            }
            if (most > 1e-3F)
                patch_make(d, floor.axis, floor.at_max, low, high, taken);
        }
}

static void floor_make(const struct drawing *d, int axis, bool at_max)
{
    const struct squares squares = squares_make(d->scene, axis, at_max);
    enum floor_style style = floor_style_of(d->scene);
    face_make(d, axis, at_max);
    layer_end(d, 0, 0.07F, true);
    if (style == FLOOR_CHECKER) {
        checker_make(d, &squares);
        layer_end(d, 0, 0.16F, true);
    } else if (style == FLOOR_GRID) {
        grid_lines(d, &squares, 0);
        grid_lines(d, &squares, 1);
        layer_end(d, (float)(0.7 * d->half), 0.35F, true);
    }
    if (d->scene->render.shadow > 0) {
        shadow_draw(d, (struct shadow_floor){axis, at_max});
        wire_layer_end(d->wire, (struct wire_layer){.color = {0, 0, 0, (float)d->scene->render.shadow}});
    }
}

/* Far faces but the floor, the darker the more the camera sees of them from aside. */
static void faces_make(const struct drawing *d, int floor_axis, bool floor_at_max)
{
    for (int axis = 0; axis < 3; axis++) {
        for (int at_max = 0; at_max < 2; at_max++)
            if (face_is_back(d, axis, at_max) && (axis != floor_axis || at_max != floor_at_max))
                face_make(d, axis, at_max);
        layer_end(d, 0, 0.04F + 0.05F * (float)fabs(d->view.camera.right[axis]), true);
    }
}

/* Edges that have a far face (back), or none. */
static void edges_make(const struct drawing *d, bool back)
{
    for (int axis = 0; axis < 3; axis++)
        for (int i = 0; i < 8; i++) {
            int u = (axis + 1) % 3, v = (axis + 2) % 3;
            double a[3], b[3];
            if (i >> axis & 1 ||
                (face_is_back(d, u, i >> u & 1) || face_is_back(d, v, i >> v & 1)) != back)
                continue;
            camera_corner(d->scene, i, 0, a);
            camera_corner(d->scene, i | 1 << axis, 0, b);
            mesh_line(&d->wire->mesh, &d->view, a, b, d->half);
        }
    layer_end(d, (float)d->half, 0.55F, back);
}

/* The last layer again, faintly, where something is in front. */
static void layer_repeat(const struct drawing *d, float alpha)
{
    struct wire *w = d->wire;
    if (!w->count || !layer_room(w))
        return;
    struct wire_layer layer = w->layers[w->count - 1];
    layer.color[3] = alpha;
    layer.behind = true;
    layer.back = false;
    w->layers[w->count++] = layer;
}

enum status wire_make(struct wire *w, const struct wire_view *view, struct error *e)
{
    const struct scene *scene = view->scene;
    const struct camera *camera = view->camera;
    const double *back = scene->render.background;
    int axis;
    bool at_max;
    /* Lines have 1.4 pixels at 720 lines, and are never thinner than one. */
    struct drawing d = {.wire = w, .scene = scene, .wished = view, .view = {*camera, view->far * 1e-4},
                        .half = fmax(0.5, 0.7 * camera->height / 720) * view->samples,
                        .ink = back[0] * 0.30 + back[1] * 0.59 + back[2] * 0.11 > 0.5 ? 0.0F : 1.0F};
    d.view.camera.width *= view->samples;
    d.view.camera.height *= view->samples;
    w->mesh.count = w->count = 0;
    w->parallel = camera->orthographic;
    solids_make(w, scene, &d.view);
    floor_find(scene, &axis, &at_max);
    bool floored = floor_style_of(scene) != FLOOR_NONE;
    if (floored && face_is_back(&d, axis, at_max))
        floor_make(&d, axis, at_max);
    if (scene->render.box == BOX_FACES)
        faces_make(&d, floored ? axis : -1, at_max);
    if (scene->render.box) {
        edges_make(&d, true);
        layer_repeat(&d, 0.10F);
        edges_make(&d, false);
        layer_repeat(&d, 0.10F);
    }
    return w->mesh.failed ? error_set(e, STATUS_RUN, "out of memory for the domain's picture") : STATUS_OK;
}

void wire_free(struct wire *w)
{
    mesh_free(&w->mesh);
    free(w->layers);
    w->layers = NULL;
    w->count = w->room = 0;
}
