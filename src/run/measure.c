/* Makes rows of measured numbers, and what quantities have in common. */
#include "run/measure.h"

#include "base/memory.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { COLUMN_SIZE = KEY_TEXT_SIZE + 64 };

struct sample measure_sample(const struct measured *m, size_t id)
{
    size_t i = m->place[id];
    const struct position *position = &particles_position(m->particles)[i];
    const struct motion *motion = &particles_motion(m->particles)[i];
    int fluid = particles_fluid(m->particles, i);
    double d = m->choice->spacing;
    struct sample s = {
        .pressure = motion->pressure,
        .density = particles_density(m->particles)[i],
        .rest_density = m->choice->each.rest_density[fluid],
        .mass = m->choice->each.mass[fluid] * (d * d * d),
    };
    for (int a = 0; a < 3; a++) {
        s.x[a] = space_metres(m->space, a, position->count[a]);
        s.v[a] = motion->velocity[a];
    }
    return s;
}

void measure_offset(const struct measured *m, const double at[3], const double x[3], double out[3])
{
    for (int a = 0; a < 3; a++) {
        out[a] = x[a] - at[a];
        if (m->space->periodic[a])
            out[a] -= m->space->length[a] * rint(out[a] / m->space->length[a]);
    }
}

double measure_weight(const struct measured *m, const struct sample *s, double distance,
                      double radius)
{
    double q = 2 * distance / radius;
    return q < 2 ? s->mass / s->density * m->choice->kernel->value(q) : 0;
}

double measure_radius(const struct measured *m, const struct scene_measure *asked)
{
    return isnan(asked->radius) ? m->choice->support : asked->radius;
}

int measure_up_axis(const struct measured *m, int *sign)
{
    int axis = 1;
    for (int a = 0; a < 3; a++)
        if (fabs(m->up[a]) > fabs(m->up[axis]))
            axis = a;
    *sign = m->up[axis] > 0 ? 1 : -1;
    return axis;
}

enum { HALF = 1 << 16 };

/* Among coordinates whose upper half is `upper` (or all, when it is HALF), the half word in which
 * the particle of rank *rank falls; *rank becomes its rank within. */
static uint32_t select_half(const struct measured *m, int axis, uint32_t upper, size_t *rank)
{
    static uint32_t histogram[HALF]; /* the run measures in one thread */
    memset(histogram, 0, sizeof histogram);
    for (size_t i = 0; i < m->count; i++) {
        uint32_t x = particles_position(m->particles)[i].count[axis];
        if (upper == HALF)
            histogram[x >> 16]++;
        else if (x >> 16 == upper)
            histogram[x & (HALF - 1)]++;
    }
    uint32_t half = 0;
    while (half < HALF - 1 && *rank > histogram[half])
        *rank -= histogram[half++];
    return half;
}

double measure_quantile(const struct measured *m, int axis, int side, double part)
{
    size_t rank = (size_t)ceil(part * (double)m->count);
    if (m->count == 0)
        return NAN;
    rank = rank < 1 ? 1 : rank > m->count ? m->count : rank;
    rank = side > 0 ? rank : m->count + 1 - rank;
    uint32_t upper = select_half(m, axis, HALF, &rank);
    return space_metres(m->space, axis, upper << 16 | select_half(m, axis, upper, &rank));
}

static size_t points_of(const struct measure_row *row, const struct scene_measure *asked)
{
    return row->per_point ? (size_t)asked->points : 1;
}

static void name_columns(struct measures *measures, const struct measure *item)
{
    size_t c = item->first;
    for (size_t k = 0; k < points_of(item->row, item->asked); k++)
        for (const struct measure_column *column = item->row->columns; column->name; column++) {
            char point[24] = "", *text = measures->text + c * COLUMN_SIZE;
            if (item->row->per_point)
                snprintf(point, sizeof point, ".%zu", k);
            snprintf(text, COLUMN_SIZE, "%s%s%s%s (%s)", item->asked->name, point,
                     column->name[0] ? "." : "", column->name, column->unit);
            measures->columns[c++] = text;
        }
}

/* Chooses what is measured, and its places in a row; the time is the first number. */
static void list_items(struct measures *measures, const struct scene *scene)
{
    const struct scene_measure *asked = scene->measure_count ? scene->measures : measure_usual;
    measures->column_count = 1;
    for (size_t i = 0; i < measures->count; i++) {
        struct measure *item = &measures->items[i];
        item->asked = &asked[i];
        item->row = (const struct measure_row *)variant_find(&measure_table, asked[i].quantity);
        item->first = measures->column_count;
        for (const struct measure_column *column = item->row->columns; column->name; column++)
            item->columns += points_of(item->row, item->asked);
        measures->column_count += item->columns;
        measures->reads |= item->row->reads;
    }
}

enum status measures_create(struct measures *measures, const struct scene *scene, size_t particles,
                            struct error *e)
{
    static const char label[] = "measures";
    *measures = (struct measures){.interval = scene->time.measure};
    if (isnan(measures->interval))
        measures->interval = scene->movie.speed / scene->movie.fps;
    measures->count = scene->measure_count ? scene->measure_count : measure_usual_count;
    measures->items = memory_create(label, measures->count, sizeof *measures->items, e);
    if (!measures->items)
        return e->status;
    list_items(measures, scene);
    measures->columns = memory_create(label, measures->column_count, sizeof(char *), e);
    measures->text = memory_create(label, measures->column_count, COLUMN_SIZE, e);
    measures->numbers = memory_create(label, measures->column_count, sizeof(double), e);
    measures->place = memory_create(label, particles + 1, sizeof *measures->place, e);
    if (!measures->columns || !measures->text || !measures->numbers || !measures->place) {
        measures_free(measures);
        return e->status;
    }
    measures->columns[0] = "time (s)";
    for (size_t i = 0; i < measures->count; i++)
        name_columns(measures, &measures->items[i]);
    return STATUS_OK;
}

void measures_free(struct measures *measures)
{
    memory_free(measures->items);
    memory_free(measures->columns);
    memory_free(measures->text);
    memory_free(measures->numbers);
    memory_free(measures->place);
    *measures = (struct measures){0};
}

static void find_up(struct measured *m)
{
    const double *g = m->scene->gravity;
    double length = sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    for (int a = 0; a < 3; a++)
        m->up[a] = length > 0 ? -g[a] / length : a == 1;
}

const double *measures_take(struct measures *measures, const struct scene *scene,
                            const struct space *space, const struct solver_choice *choice,
                            const struct particles *particles, double time)
{
    struct measured m = {.scene = scene, .space = space, .choice = choice, .particles = particles,
                         .place = measures->place, .count = particles->count, .time = time};
    find_up(&m);
    for (size_t i = 0; i < m.count; i++)
        measures->place[particles_id(particles)[i]] = (uint32_t)i;
    measures->numbers[0] = time;
    for (size_t i = 0; i < measures->count; i++) {
        const struct measure *item = &measures->items[i];
        item->row->value(&m, item->asked, measures->numbers + item->first);
    }
    return measures->numbers;
}
