/* Checks measured quantities: names of their columns, points inside the domain, number of rows. */
#include "scene/load.h"

#include <math.h>
#include <string.h>

static const double row_limit = 1e8;

/* Names go into the first line of a csv file as they are. */
static enum status check_name(struct load *load, size_t i)
{
    const struct scene *s = load->scene;
    struct scene_measure *m = &s->measures[i];
    struct place place = load_element_place(load, ARRAY_MEASURE, i, "measure[].name");
    if (!m->name[0])
        memcpy(m->name, m->quantity, sizeof m->name);
    for (const char *c = m->name; *c; c++)
        if (strchr(",;\"", *c) || (unsigned char)*c < ' ')
            return load_fail(load, place, "measure.%zu.name: \"%s\" has a comma, semicolon, quote "
                             "or control character, which would break the csv file", i, m->name);
    for (size_t j = 0; j < i; j++)
        if (strcmp(s->measures[j].name, m->name) == 0)
            return load_fail(load, place, "measure.%zu.name: measure.%zu is \"%s\" already; give "
                             "each its own \"name\"", i, j, m->name);
    return STATUS_OK;
}

static enum status check_points(struct load *load, size_t i)
{
    const struct scene *s = load->scene;
    const struct scene_measure *m = &s->measures[i];
    for (size_t row = 0; row < load->keys.count; row++) {
        const struct key *key = load->keys.items[row].key;
        if (strncmp(key->path, "measure[].", 10) != 0 || !(key->flags & KEY_INSIDE) ||
            !key_list_active(&load->keys, row, m))
            continue;
        const double *x = (const double *)((const char *)m + key->offset);
        for (int a = 0; a < 3; a++)
            if (x[a] < s->domain.min[a] || x[a] > s->domain.max[a])
                return load_fail(load, load_element_place(load, ARRAY_MEASURE, i, key->path),
                                 "measure.%zu.%s: %c = %g m is outside the domain, which is from "
                                 "%g to %g m", i, key->path + 10, "xyz"[a], x[a], s->domain.min[a],
                                 s->domain.max[a]);
    }
    return STATUS_OK;
}

/* Only a quantity on a face reads min and max; of the others they are 0. */
static enum status check_face(struct load *load, size_t i)
{
    const struct scene_measure *m = &load->scene->measures[i];
    size_t row = key_list_find_active(&load->keys, "measure[].face", m);
    if (row == load->keys.count)
        return STATUS_OK;
    if (load->scene->domain.walls[m->face] == WALL_PERIODIC)
        return load_fail(load, load_element_place(load, ARRAY_MEASURE, i, "measure[].face"),
                         "measure.%zu.face: %s is periodic, no wall; choose another face", i,
                         scene_face_names[m->face]);
    for (int a = 0; a < 3; a++)
        if (a != m->face / 2 && m->min[a] >= m->max[a])
            return load_fail(load, load_element_place(load, ARRAY_MEASURE, i, "measure[].max"),
                             "measure.%zu.max is not above measure.%zu.min along %c: %g and %g", i,
                             i, "xyz"[a], m->max[a], m->min[a]);
    return STATUS_OK;
}

enum status check_measures(struct load *load)
{
    const struct scene *s = load->scene;
    double rows = s->time.end / s->time.measure;
    enum status status = STATUS_OK;
    if (rows > row_limit)
        return load_fail(load, load_place(load, "time.measure"), "time.measure %g s would make "
                         "%.3g rows; raise it or lower time.end", s->time.measure, rows);
    for (size_t i = 0; i < s->measure_count && !status; i++) {
        status = check_name(load, i);
        if (!status)
            status = check_points(load, i);
        if (!status)
            status = check_face(load, i);
    }
    return status;
}
