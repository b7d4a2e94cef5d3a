/* Checks bodies: size, place, none inside another. */
#include "scene/load.h"

#include <math.h>
#include <stdlib.h>

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
    const char *key = body->shape.kind == SHAPE_BOX ? "bodies[].min" : "bodies[].center";
    return load_fail(load, load_element_place(load, ARRAY_BODIES, second, key), "bodies.%zu (%s) "
                     "overlaps bodies.%zu (%s); bodies may touch but not share space", second,
                     shape_words[body->shape.kind], first,
                     shape_words[load->scene->bodies[first].shape.kind]);
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
        shape_bounds(&s->bodies[i].shape, min, max);
        edges[i] = (struct left_edge){min[0], max[0], i};
    }
    qsort(edges, s->body_count, sizeof *edges, by_left_edge);
    for (size_t i = 0; i < s->body_count && !status; i++)
        for (size_t j = i + 1; j < s->body_count && edges[j].min < edges[i].max && !status; j++)
            if (shape_overlap(&s->bodies[edges[i].body].shape, &s->bodies[edges[j].body].shape, slack))
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
        struct scene_body *body = &load->scene->bodies[i];
        body->place = load_position(load, load->arrays[ARRAY_BODIES].elements[i]);
        status = check_shape(load, ARRAY_BODIES, i, &body->shape);
        if (!status)
            status = check_start(load, i);
    }
    return status ? status : check_overlaps(load);
}
