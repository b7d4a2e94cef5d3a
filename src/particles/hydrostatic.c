/* Finds bodies that are settled tanks, and their hydrostatic pressure. */
#include "particles/hydrostatic.h"

#include "base/memory.h"
#include "particles/flows.h"

#include <math.h>

/* Nearer than half a spacing is touching: a lattice knows no better. */
static bool touch(const struct hydrostatic *h, double a, double b)
{
    return fabs(a - b) < 0.5 * h->scene->particles.spacing;
}

/* Area that two boxes share when looked at along `axis`, m^2. */
static double shared_area(double min[2][3], double max[2][3], int axis)
{
    double area = 1;
    for (int k = 1; k <= 2; k++) {
        int a = (axis + k) % 3;
        area *= fmax(0, fmin(max[0][a], max[1][a]) - fmax(min[0][a], min[1][a]));
    }
    return area;
}

/* Area of a body's face that hydrostatic bodies cover whose opposite face lies at `at`, m^2. Bodies
 * share no space, so their areas add up. Levels of tilted bodies differ: there only the body itself
 * counts, through a periodic face. */
static double covered_area(const struct hydrostatic *h, size_t body, int face, double at)
{
    double area = 0, min[2][3], max[2][3];
    shape_bounds(&h->scene->bodies[body].shape, min[0], max[0]);
    for (size_t b = 0; b < h->scene->body_count; b++) {
        const struct scene_body *other = &h->scene->bodies[b];
        if (!h->body[b] || other->shape.kind != SHAPE_BOX || (h->axis < 0 && b != body))
            continue;
        shape_bounds(&other->shape, min[1], max[1]);
        if (touch(h, face & 1 ? min[1][face / 2] : max[1][face / 2], at))
            area += shared_area(min, max, face / 2);
    }
    return area;
}

/* Whether something stands behind the whole face of a box; gaps below half a spacing do not count. */
static bool face_held(const struct hydrostatic *h, size_t body, int face)
{
    const struct scene_body *box = &h->scene->bodies[body];
    int a = face / 2, b = (a + 1) % 3, c = (a + 2) % 3;
    const double *low = h->scene->domain.min, *high = h->scene->domain.max;
    double at = face & 1 ? box->shape.max[a] : box->shape.min[a];
    double wide = box->shape.max[b] - box->shape.min[b], deep = box->shape.max[c] - box->shape.min[c];
    if (touch(h, at, face & 1 ? high[a] : low[a])) {
        if (h->scene->domain.walls[face] != WALL_PERIODIC)
            return true;
        at = face & 1 ? low[a] : high[a];
    }
    double open = wide * deep - covered_area(h, body, face, at);
    return open <= fmin(0.5 * h->scene->particles.spacing * (wide + deep), 0.5 * wide * deep);
}

static bool held(const struct hydrostatic *h, size_t body)
{
    for (int face = 0; face < FACE_COUNT; face++) {
        bool top = (face & 1 ? 1 : -1) * h->up[face / 2] > 1 - 1e-9;
        if (!top && !face_held(h, body, face))
            return false;
    }
    return true;
}

static bool falls_for_ever(const struct hydrostatic *h)
{
    for (int a = 0; a < 3; a++)
        if (h->up[a] != 0 && h->scene->domain.walls[2 * a] == WALL_PERIODIC)
            return true;
    return false;
}

static void find_up(struct hydrostatic *h)
{
    const double *g = h->scene->gravity;
    h->gravity = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    h->axis = -1;
    for (int a = 0; a < 3; a++) {
        h->up[a] = h->gravity > 0 ? -g[a] / h->gravity : 0;
        if (fabs(h->up[a]) > 1 - 1e-9)
            h->axis = a;
    }
}

/* Takes away bodies that are not held, until those that remain hold one another. */
static void let_go(struct hydrostatic *h)
{
    bool changed = true;
    while (changed) {
        changed = false;
        for (size_t b = 0; b < h->scene->body_count; b++)
            if (h->body[b] && h->scene->bodies[b].start == START_AUTO && !held(h, b)) {
                h->body[b] = false;
                changed = true;
            }
    }
}

enum status hydrostatic_create(struct hydrostatic *h, const struct scene *scene, struct error *e)
{
    *h = (struct hydrostatic){.scene = scene};
    h->body = memory_create("start pressure", scene->body_count + 1, sizeof *h->body, e);
    if (!h->body)
        return e->status;
    find_up(h);
    bool can_rest = h->gravity > 0 && !falls_for_ever(h);
    for (size_t b = 0; b < scene->body_count; b++) {
        const struct scene_body *body = &scene->bodies[b];
        bool tank = can_rest && body->shape.kind == SHAPE_BOX && flow_still(body);
        h->body[b] = body->start == START_HYDROSTATIC || (body->start == START_AUTO && tank);
    }
    let_go(h);
    return STATUS_OK;
}

void hydrostatic_free(struct hydrostatic *h)
{
    memory_free(h->body);
    *h = (struct hydrostatic){0};
}

/* How far the bounds reach along `up` (highest), or against it (lowest), from the origin, m. */
static double level(const struct hydrostatic *h, const double min[3], const double max[3],
                    bool highest)
{
    double sum = 0;
    for (int a = 0; a < 3; a++)
        sum += h->up[a] * ((h->up[a] > 0) == highest ? max[a] : min[a]);
    return sum;
}

/* The hydrostatic body that stands at `top` above x, or -1. */
static int body_above(const struct hydrostatic *h, const double x[3], double top)
{
    for (size_t b = 0; b < h->scene->body_count; b++) {
        double min[3], max[3];
        bool above = h->body[b];
        if (!above)
            continue;
        shape_bounds(&h->scene->bodies[b].shape, min, max);
        for (int a = 0; a < 3; a++)
            above = above && (a == h->axis || (x[a] >= min[a] && x[a] <= max[a]));
        if (above && touch(h, level(h, min, max, false), top))
            return (int)b;
    }
    return -1;
}

double hydrostatic_pressure(const struct hydrostatic *h, size_t body, const double x[3])
{
    const struct scene *scene = h->scene;
    double min[3], max[3], inside[3], at = 0, pressure = 0;
    if (!h->body[body])
        return 0;
    shape_bounds(&scene->bodies[body].shape, min, max);
    for (int a = 0; a < 3; a++) { /* a displaced particle may lie just outside */
        inside[a] = fmin(fmax(x[a], min[a]), max[a]);
        at += h->up[a] * inside[a];
    }
    int b = (int)body;
    for (size_t layers = 0; b >= 0 && layers <= scene->body_count; layers++) {
        shape_bounds(&scene->bodies[b].shape, min, max);
        double top = level(h, min, max, true);
        double depth = fmax(0, top - at);
        pressure += scene->fluids[scene->bodies[b].fluid].density * h->gravity * depth;
        at = top;
        b = h->axis >= 0 ? body_above(h, inside, top) : -1;
    }
    return pressure;
}
