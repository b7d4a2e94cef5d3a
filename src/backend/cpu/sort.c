/* Brings particles into canonical order. */
#include "backend/cpu/cpu.h"

#include <string.h>

/* to[i] = from[order[i]] for records of `size` bytes; constant sizes make plain moves. */
static void permute(void *to, const void *from, const uint32_t *order, size_t count, size_t size)
{
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < count; i++) {
        const char *source = (const char *)from + size * order[i];
        char *target = (char *)to + size * i;
        if (size == 16)
            memcpy(target, source, 16);
        else if (size == 4)
            memcpy(target, source, 4);
        else
            memcpy(target, source, size);
    }
}

static void copy(char *to, const char *from, size_t bytes)
{
    enum { STRETCH = 1 << 16 };
#pragma omp parallel for schedule(static)
    for (size_t at = 0; at < bytes; at += STRETCH)
        memcpy(to + at, from + at, bytes - at < STRETCH ? bytes - at : STRETCH);
}

static void permute_fields(struct backend *b, struct particles *p)
{
    for (int f = 0; f < FIELD_COUNT; f++) {
        void **other = p->before[f] ? &p->before[f] : &b->spare;
        if (!p->now[f] || field_table[f].copies == 0)
            continue;
        permute(*other, p->now[f], b->order, p->count, field_table[f].size);
        if (p->before[f]) { /* the sorted copy becomes the present state */
            void *swap = p->now[f];
            p->now[f] = *other;
            *other = swap;
        } else {
            copy(p->now[f], b->spare, p->count * field_table[f].size);
        }
    }
}

enum status cpu_sort(struct backend *b, struct particles *p, struct cells *cells,
                     uint32_t *const axis[3], double radius, struct error *e)
{
    const struct position *position = particles_position(p);
    cells_resize(cells, &b->space, radius, p->count);
    if (cells_sort(cells, position, particles_id(p), p->count, b->order, b->scratch, e))
        return e->status;
    permute_fields(b, p);
    position = particles_position(p);
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->count; i++)
        for (int a = 0; a < 3; a++)
            axis[a][i] = position[i].count[a];
    return STATUS_OK;
}
