/* Checks bodies: size, inside the domain, none inside another. */
#include "scene/load.h"

#include <math.h>
#include <stdlib.h>

static const char *const shape_words[] = {"box", "sphere", "cylinder"};

double body_volume(const struct scene_body *b)
{
    const double pi = 3.14159265358979323846;
    switch (b->shape) {
    case BODY_BOX:
        return (b->max[0] - b->min[0]) * (b->max[1] - b->min[1]) * (b->max[2] - b->min[2]);
    case BODY_SPHERE:
        return 4 * pi / 3 * b->radius * b->radius * b->radius;
    case BODY_CYLINDER:
        return pi * b->radius * b->radius * b->height;
    }
    return 0;
}

void body_bounds(const struct scene_body *b, double min[3], double max[3])
{
    for (int a = 0; a < 3; a++) {
        double half = b->shape == BODY_CYLINDER && a == b->axis ? b->height / 2 : b->radius;
        min[a] = b->shape == BODY_BOX ? b->min[a] : b->center[a] - half;
        max[a] = b->shape == BODY_BOX ? b->max[a] : b->center[a] + half;
    }
}

/* Moves p from outside the disc or ball of radius r about c to its rim; `skip` is an axis left
 * alone, or -1. */
static void project_round(double p[3], const double c[3], double r, int skip)
{
    double square = 0;
    for (int a = 0; a < 3; a++)
        square += a == skip ? 0 : (p[a] - c[a]) * (p[a] - c[a]);
    double part = square > r * r ? r / sqrt(square) : 1;
    for (int a = 0; a < 3; a++)
        if (a != skip)
            p[a] = c[a] + (p[a] - c[a]) * part;
}

/* The point of the body, made smaller by `slack` all around, that is nearest to p. */
static void body_project(const struct scene_body *b, double slack, double p[3])
{
    double min[3], max[3];
    body_bounds(b, min, max);
    if (b->shape != BODY_BOX)
        project_round(p, b->center, fmax(b->radius - slack, 0),
                      b->shape == BODY_CYLINDER ? b->axis : -1);
    for (int a = 0; a < 3; a++) {
        bool flat = b->shape == BODY_BOX || (b->shape == BODY_CYLINDER && a == b->axis);
        if (flat)
            p[a] = fmin(fmax(p[a], min[a] + slack), max[a] - slack);
    }
}

/* Alternating projections between convex bodies tend to a nearest pair of points (Cheney and
 * Goldstein 1959). The distance found only shrinks and is never too small, so bodies that touch
 * pass. */
bool body_overlap(const struct scene_body *a, const struct scene_body *b, double slack)
{
    double p[3], q[3], amin[3], amax[3], bmin[3], bmax[3];
    body_bounds(a, amin, amax);
    body_bounds(b, bmin, bmax);
    for (int k = 0; k < 3; k++) {
        if (amin[k] + slack >= bmax[k] || bmin[k] + slack >= amax[k])
            return false;
        p[k] = (fmax(amin[k], bmin[k]) + fmin(amax[k], bmax[k])) / 2;
    }
    double before = INFINITY;
    for (int i = 0; i < 1000; i++) {
        double square = 0;
        body_project(a, slack / 2, p);
        for (int k = 0; k < 3; k++)
            q[k] = p[k];
        body_project(b, slack / 2, q);
        for (int k = 0; k < 3; k++) {
            square += (p[k] - q[k]) * (p[k] - q[k]);
            p[k] = q[k];
        }
        if (square < slack * slack / 100)
            return true;
        if (square > before * (1 - 1e-6)) /* settled apart */
            return false;
        before = square;
    }
    return false;
}

/* The key to blame for a body's extent. */
static const char *extent_key(const struct scene_body *b, bool along_axis)
{
    return b->shape == BODY_BOX ? "bodies[].max" : along_axis ? "bodies[].height"
                                                              : "bodies[].radius";
}

static enum status check_size(struct load *load, size_t i)
{
    const struct scene_body *b = &load->scene->bodies[i];
    double min[3], max[3], d = load->scene->particles.spacing;
    body_bounds(b, min, max);
    for (int a = 0; a < 3; a++) {
        const char *key = extent_key(b, b->shape == BODY_CYLINDER && a == b->axis);
        struct place place = load_element_place(load, ARRAY_BODIES, i, key);
        if (!(max[a] > min[a]))
            return load_fail(load, place, "bodies.%zu.max is not above bodies.%zu.min along %c: %g "
                             "and %g", i, i, "xyz"[a], max[a], min[a]);
        if (max[a] - min[a] < d * (1 - 1e-9))
            return load_fail(load, place, "bodies.%zu: this %s is %g m along %c, less than "
                             "particles.spacing %g m, and would have no particle; make it larger "
                             "or the spacing smaller", i, shape_words[b->shape], max[a] - min[a],
                             "xyz"[a], d);
    }
    return STATUS_OK;
}

static enum status check_inside(struct load *load, size_t i)
{
    const struct scene *s = load->scene;
    const struct scene_body *b = &s->bodies[i];
    double min[3], max[3], slack = 1e-6 * s->particles.spacing;
    body_bounds(b, min, max);
    for (int a = 0; a < 3; a++) {
        bool low = min[a] < s->domain.min[a] - slack, high = max[a] > s->domain.max[a] + slack;
        if (!low && !high)
            continue;
        const char *key = b->shape != BODY_BOX ? "bodies[].center" : low ? "bodies[].min"
                                                                         : "bodies[].max";
        return load_fail(load, load_element_place(load, ARRAY_BODIES, i, key), "bodies.%zu: this "
                         "%s reaches %c = %g m, outside the domain, which %s at %g m; move it in "
                         "or enlarge the domain", i, shape_words[b->shape], "xyz"[a],
                         low ? min[a] : max[a], low ? "begins" : "ends",
                         low ? s->domain.min[a] : s->domain.max[a]);
    }
    return STATUS_OK;
}

struct left_edge { /* for sweeping the bodies along x */
    double min, max;
    size_t body;
};

static int by_left_edge(const void *a, const void *b)
{
    const struct left_edge *l = a, *r = b;
    if (l->min != r->min)
        return l->min < r->min ? -1 : 1;
    return l->body < r->body ? -1 : l->body > r->body;
}

static enum status report_overlap(struct load *load, size_t a, size_t b)
{
    size_t first = a < b ? a : b, second = a < b ? b : a;
    const struct scene_body *body = &load->scene->bodies[second];
    const char *key = body->shape == BODY_BOX ? "bodies[].min" : "bodies[].center";
    return load_fail(load, load_element_place(load, ARRAY_BODIES, second, key), "bodies.%zu (%s) "
                     "overlaps bodies.%zu (%s); bodies may touch but not share space", second,
                     shape_words[body->shape], first,
                     shape_words[load->scene->bodies[first].shape]);
}

static enum status check_overlaps(struct load *load)
{
    const struct scene *s = load->scene;
    struct left_edge *edges = calloc(s->body_count + 1, sizeof *edges);
    double slack = 0.01 * s->particles.spacing;
    enum status status = STATUS_OK;
    if (!edges)
        return error_set(load->e, STATUS_RUN, "memory is short");
    for (size_t i = 0; i < s->body_count; i++) {
        double min[3], max[3];
        body_bounds(&s->bodies[i], min, max);
        edges[i] = (struct left_edge){min[0], max[0], i};
    }
    qsort(edges, s->body_count, sizeof *edges, by_left_edge);
    for (size_t i = 0; i < s->body_count && !status; i++)
        for (size_t j = i + 1; j < s->body_count && edges[j].min < edges[i].max && !status; j++)
            if (body_overlap(&s->bodies[edges[i].body], &s->bodies[edges[j].body], slack))
                status = report_overlap(load, edges[i].body, edges[j].body);
    free(edges);
    return status;
}

/* Nothing carries the weight where gravity acts along a periodic axis. */
static enum status check_start(struct load *load, size_t i)
{
    const struct scene *s = load->scene;
    for (int a = 0; a < 3; a++)
        if (s->bodies[i].start == START_HYDROSTATIC && s->gravity[a] != 0 &&
            s->domain.walls[2 * a] == WALL_PERIODIC)
            return load_fail(load, load_element_place(load, ARRAY_BODIES, i, "bodies[].start"),
                             "bodies.%zu.start is hydrostatic, but gravity acts along %c, where "
                             "the domain is periodic and no floor carries the fluid; use \"rest\" "
                             "or walls at %c", i, "xyz"[a], "xyz"[a]);
    return STATUS_OK;
}

enum status check_bodies(struct load *load)
{
    enum status status = STATUS_OK;
    for (size_t i = 0; i < load->scene->body_count && !status; i++) {
        status = check_size(load, i);
        if (!status)
            status = check_inside(load, i);
        if (!status)
            status = check_start(load, i);
    }
    return status ? status : check_overlaps(load);
}
