/* Sorts particles and builds neighbour rows on a device. */
#include "backend/cuda/cuda.h"

#include "base/log.h"
#include "solver/part.h"

#include <math.h>
#include <string.h>

void *cuda_array(struct backend *b, const char *label, size_t count, size_t size, struct error *e)
{
    size_t padded = (count / PARTICLE_BLOCK + 2) * PARTICLE_BLOCK;
    return b->row->create(b->device, label, padded * size, e);
}

/* Bits that count up to `most`. */
static int bits_of(size_t most)
{
    int bits = 1;
    while (bits < 63 && most >> bits)
        bits++;
    return bits;
}

static enum status reserve_cells(struct backend *b, struct cells *cells, struct error *e)
{
    if (cells->count + 2 <= cells->capacity)
        return STATUS_OK;
    b->row->destroy(b->device, cells->start);
    cells->capacity = cells->count + cells->count / 4 + 2;
    cells->start = b->row->create(b->device, "cells", cells->capacity * sizeof *cells->start, e);
    if (!cells->start)
        cells->capacity = 0;
    return cells->start ? STATUS_OK : e->status;
}

/* Every field comes into the new order; the sorted copy becomes the present state. */
static void permute_fields(struct backend *b, struct particles *p)
{
    struct order_work w = {.order = b->sorting.order};
    for (int f = 0; f < FIELD_COUNT; f++) {
        void **other = p->before[f] ? &p->before[f] : &b->sorting.spare;
        if (!p->now[f] || field_table[f].copies == 0)
            continue;
        w.size = field_table[f].size;
        w.from = p->now[f];
        w.to = *other;
        cuda_launch(b, KERNEL_order_permute, p->count, &w);
        if (p->before[f]) {
            void *swap = p->now[f];
            p->now[f] = *other;
            *other = swap;
        } else {
            b->row->copy(b->device, p->now[f], w.to, p->count * w.size);
        }
    }
}

enum status cuda_sort(struct backend *b, struct particles *p, struct cells *cells, double radius,
                      struct error *e)
{
    const struct device_sorting *s = &b->sorting;
    cells_resize(cells, &b->space, radius, p->count);
    if (reserve_cells(b, cells, e))
        return e->status;
    struct order_work w = {.cells = *cells,
                           .points = p->now[FIELD_POSITION],
                           .id = p->now[FIELD_ID],
                           .point_count = p->count,
                           .keys = s->keys,
                           .order = s->values,
                           .id_bits = bits_of(p->count)};
    struct device_sort sort = {s->keys,  s->sorted_keys, s->values,
                               s->order, p->count,       w.id_bits + bits_of(cells->count)};
    if (p->count > 0) {
        cuda_launch(b, KERNEL_order_keys, p->count, &w);
        if (b->row->sort(b->device, &sort, e))
            return e->status;
    }
    w.keys = s->sorted_keys;
    cuda_launch(b, KERNEL_order_starts, cells->count + 1, &w);
    if (p->count > 0)
        permute_fields(b, p);
    return STATUS_OK;
}

/* A range is three cells, which are as wide as the support and some more. */
uint32_t cuda_hit_words(const struct solver_choice *choice)
{
    enum { RANGES = 9, WORD = 32 };
    double range = 3 * pow(1.1 * choice->support / choice->spacing, 3);
    return RANGES * (1 + (uint32_t)(range / WORD));
}

enum status cuda_rows_create(struct backend *b, struct device_rows *rows, size_t points,
                             bool weighted, struct error *e)
{
    size_t blocks = points / PARTICLE_BLOCK + 2;
    *rows = (struct device_rows){.weighted = weighted};
    rows->block = b->row->create(b->device, "neighbour rows", blocks * sizeof *rows->block, e);
    rows->length = b->row->create(b->device, "neighbour rows", blocks * sizeof *rows->length, e);
    rows->count = cuda_array(b, "neighbour rows", points, sizeof *rows->count, e);
    rows->facts = b->row->create(b->device, "neighbour rows", sizeof *rows->facts, e);
    return rows->block && rows->length && rows->count && rows->facts ? STATUS_OK : e->status;
}

void cuda_rows_free(struct backend *b, struct device_rows *rows)
{
    void *const arrays[] = {rows->block, rows->length, rows->count,
                            rows->facts, rows->index,  rows->weight};
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++)
        b->row->destroy(b->device, arrays[k]);
    *rows = (struct device_rows){0};
}

/* Room for `blocks` times 16 entries, and some more. */
static enum status reserve_rows(struct backend *b, struct device_rows *rows, size_t blocks,
                                bool *moved, struct error *e)
{
    if (blocks <= rows->room && rows->index)
        return STATUS_OK;
    size_t room = blocks + blocks / 8 + 64, bytes = room * PARTICLE_BLOCK * sizeof(uint32_t);
    *moved = true;
    b->row->destroy(b->device, rows->index);
    b->row->destroy(b->device, rows->weight);
    rows->weight = NULL;
    rows->room = 0;
    rows->index = b->row->create(b->device, "neighbour rows", bytes, e);
    if (rows->weighted)
        rows->weight = b->row->create(b->device, "neighbour rows", bytes, e);
    if (!rows->index || (rows->weighted && !rows->weight))
        return e->status;
    rows->room = room;
    return STATUS_OK;
}

enum status cuda_rows_build(struct backend *b, struct device_rows *rows,
                            const struct particles *points, const struct particles *candidates,
                            const struct cells *cells, bool same, double radius, bool *moved,
                            struct error *e)
{
    const struct device_row *d = b->row;
    double reach = radius / b->choice.smoothing_length;
    size_t blocks = (points->count + PARTICLE_BLOCK - 1) / PARTICLE_BLOCK;
    struct row_facts facts;
    struct order_work w = {.cells = *cells,
                           .points = points->now[FIELD_POSITION],
                           .point_count = points->count,
                           .candidates = candidates->now[FIELD_POSITION],
                           .candidate_count = candidates->count,
                           .same = same,
                           .all = b->all,
                           .limit = (float)(reach * reach),
                           .coincident =
                               same ? part_near2(b->choice.spacing, b->choice.smoothing_length) : 0,
                           .count = rows->count,
                           .hits = b->sorting.hits,
                           .hit_words = b->sorting.hit_words,
                           .length = rows->length,
                           .block = rows->block,
                           .facts = rows->facts};
    memcpy(w.scale, b->choice.pair.scale, sizeof w.scale);
    rows->entries = 0;
    rows->coincident = false;
    if (blocks == 0)
        return STATUS_OK;
    d->clear(b->device, rows->facts, sizeof facts);
    cuda_launch(b, KERNEL_order_row_counts, points->count, &w);
    cuda_launch(b, KERNEL_order_row_lengths, blocks, &w);
    if (d->scan(b->device, rows->length, blocks, e))
        return e->status;
    d->copy(b->device, &rows->facts->total, rows->length + blocks, sizeof facts.total);
    if (d->read(b->device, &facts, rows->facts, sizeof facts, e) ||
        reserve_rows(b, rows, facts.total, moved, e))
        return e->status;
    w.index = rows->index;
    w.weight = rows->weight;
    cuda_launch(b, KERNEL_order_rows, points->count, &w);
    rows->entries = (double)facts.entries;
    rows->coincident = facts.coincident > 0;
    return STATUS_OK;
}

/* Moves particles apart that share a place, by their rows. */
static enum status part(struct backend *b, struct error *e)
{
    struct work work = cuda_work(b, PASS_NEIGHBOURS, SOLVE_VELOCITY, false);
    int64_t *fixed = b->scalars->sums.fixed, moved;
    work.parted = b->sorting.spare;
    cuda_launch(b, KERNEL_stage_part, work.count, &work);
    cuda_launch(b, KERNEL_stage_parted, work.count, &work);
    if (b->row->read(b->device, &moved, fixed, sizeof moved, e))
        return e->status;
    b->row->clear(b->device, fixed, sizeof moved);
    log_detail("%lld particles shared a place and were moved apart", (long long)moved);
    return STATUS_OK;
}

enum status cuda_neighbours(struct backend *b, double radius, struct error *e)
{
    struct particles *p = &b->particles;
    bool moved = false;
    if (cuda_rows_build(b, &b->rows, p, p, &b->cells, true, radius, &moved, e))
        return e->status;
    if (b->rows.coincident &&
        (part(b, e) || cuda_sort(b, p, &b->cells, radius, e) ||
         cuda_rows_build(b, &b->rows, p, p, &b->cells, true, radius, &moved, e)))
        return e->status;
    if (b->wall.count &&
        cuda_rows_build(b, &b->wall_rows, p, &b->wall, &b->wall_cells, false, radius, &moved, e))
        return e->status;
    if (moved)
        cuda_forget(b);
    struct work work = cuda_work(b, PASS_NEIGHBOURS, SOLVE_VELOCITY, false);
    if (b->arrays.rest && p->count)
        cuda_launch(b, KERNEL_stage_rest_densities, p->count, &work);
    b->counts.row_entries = b->rows.entries + b->wall_rows.entries;
    return STATUS_OK;
}

enum status cuda_weigh_walls(struct backend *b, struct error *e)
{
    struct particles *wall = &b->wall;
    struct device_rows rows = {0};
    struct work work = {.count = wall->count,
                        .constants = b->choice.pair,
                        .choice = b->there,
                        .scalars = b->scalars};
    bool moved;
    work.number = cuda_array(b, "kernel sums", wall->count, sizeof(float), e);
    if (!work.number || cuda_sort(b, wall, &b->wall_cells, b->choice.support * (1 + SKIN_MAX), e) ||
        cuda_rows_create(b, &rows, wall->count, false, e) ||
        cuda_rows_build(b, &rows, wall, wall, &b->wall_cells, true, b->choice.support, &moved, e))
        goto done;
    work.position = work.state.position = wall->now[FIELD_POSITION];
    work.rows = rows.block;
    work.row_count = rows.count;
    cuda_launch(b,
                KERNEL_pair_density_wendland + pair_find(PAIR_PASS_DENSITY, &work, b->choice.flags),
                wall->count, &work);
    cuda_launch(b, KERNEL_stage_wall_volumes, wall->count, &work);
    b->row->wait(b->device, e);
done:
    b->row->destroy(b->device, work.number);
    cuda_rows_free(b, &rows);
    return e->status;
}
