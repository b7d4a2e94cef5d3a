/* The cuda back end: particles live on a device, passes are kernels there. */
#include "backend/cuda/cuda.h"

#include "base/log.h"
#include "base/memory.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum status cuda_upload(struct backend *b, void *to, const void *from, size_t bytes, struct error *e)
{
    b->row->upload(b->device, to, from, bytes);
    return b->row->wait(b->device, e);
}

/* The same fields on the device, with what they hold. */
static enum status upload_particles(struct backend *b, const struct particles *host,
                                    struct particles *p, struct error *e)
{
    *p = (struct particles){.count = host->count, .fields = host->fields};
    for (int f = 0; f < FIELD_COUNT; f++) {
        const struct field_row *row = &field_table[f];
        if (!host->now[f])
            continue;
        p->now[f] = cuda_array(b, row->name, p->count, row->size, e);
        if (p->now[f] && host->before[f])
            p->before[f] = cuda_array(b, row->name, p->count, row->size, e);
        if (!p->now[f] || (host->before[f] && !p->before[f]) ||
            cuda_upload(b, p->now[f], host->now[f], p->count * row->size, e))
            return e->status;
    }
    return STATUS_OK;
}

static void destroy_particles(struct backend *b, struct particles *p)
{
    for (int f = 0; f < FIELD_COUNT; f++) {
        b->row->destroy(b->device, p->now[f]);
        b->row->destroy(b->device, p->before[f]);
    }
    *p = (struct particles){0};
}

void cuda_close(struct backend *b)
{
    if (!b)
        return;
    if (b->device) {
        void *const arrays[] = {b->there,
                                b->scalars,
                                b->cells.start,
                                b->wall_cells.start,
                                b->curl_cells.start,
                                b->sorting.keys,
                                b->sorting.sorted_keys,
                                b->sorting.values,
                                b->sorting.order,
                                b->sorting.spare,
                                b->sorting.hits,
                                b->arrays.number,
                                b->arrays.inverse_density,
                                b->arrays.fluid,
                                b->arrays.rest,
                                b->fixed,
                                b->hash};
        cuda_forget(b);
        for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++)
            b->row->destroy(b->device, arrays[k]);
        b->row->unpin(b->device, b->in);
        b->row->unpin(b->device, b->out);
        b->row->unpin(b->device, b->hash_read);
        destroy_particles(b, &b->particles);
        destroy_particles(b, &b->wall);
        destroy_particles(b, &b->curl);
        cuda_rows_free(b, &b->rows);
        cuda_rows_free(b, &b->wall_rows);
        cuda_rows_free(b, &b->curl_rows);
        for (int f = 0; f < FIELD_COUNT; f++)
            b->row->unpin(b->device, b->seen.now[f]);
        b->row->close(b->device);
    }
    free(b);
}

/* Device bytes that a run takes at the least: fields, sorting, rows as on the lattice. */
static double bytes_needed(const struct backend *b, const struct particles *p,
                           const struct particles *wall)
{
    const struct solver_choice *c = &b->choice;
    /* keys, values, a spare field, and as much again for the sort itself */
    double sorting = 2 * (2 * sizeof(uint64_t) + 2 * sizeof(uint32_t)) + sizeof(struct position);
    double hits = sizeof(uint32_t) * cuda_hit_words(c);
    double cells = 8 * sizeof(uint32_t), fields = 0, wall_fields = 0;
    double row = 1.125 * solver_row_bytes(c) * kernel_lattice_neighbours(c->support / c->spacing);
    for (int f = 0; f < FIELD_COUNT; f++) {
        double size = (double)field_table[f].size;
        fields += (p->now[f] ? size : 0) + (p->before[f] ? size : 0);
        wall_fields += (wall->now[f] ? size : 0) + (wall->before[f] ? size : 0);
    }
    return (fields + sorting + hits + cells + row) * (double)p->count +
           (wall_fields + sorting + cells) * (double)wall->count;
}

static enum status check_memory(const struct backend *b, const struct device_info *info,
                                const struct particles *p, const struct particles *wall,
                                struct error *e)
{
    /* Kernels, when they are first run, rows that grow and pictures take some more. */
    double needed = bytes_needed(b, p, wall), have = (double)info->free - 0.03 * (double)info->memory;
    if (needed <= have || info->memory == 0)
        return STATUS_OK;
    return error_set(e, STATUS_RUN,
                     "%zu particles and %zu in walls take %.4g GB on %s, of which "
                     "%.4g GB can be had: use a larger particles.spacing, another device (--backend "
                     "cuda:N), or --backend cpu",
                     p->count, wall->count, 1e-9 * needed, info->name, 1e-9 * have);
}

static enum status allocate_sorting(struct backend *b, struct error *e)
{
    struct device_sorting *s = &b->sorting;
    size_t n = b->particles.count, w = b->wall.count, most = n > w ? n : w;
    s->keys = cuda_array(b, "sort", most, sizeof *s->keys, e);
    s->sorted_keys = cuda_array(b, "sort", most, sizeof *s->keys, e);
    s->values = cuda_array(b, "sort", most, sizeof *s->values, e);
    s->order = cuda_array(b, "sort", most, sizeof *s->order, e);
    s->spare = cuda_array(b, "sort", most, sizeof(struct position), e);
    s->hit_words = cuda_hit_words(&b->choice);
    s->hits = cuda_array(b, "neighbour rows", most, s->hit_words * sizeof *s->hits, e);
    return s->keys && s->sorted_keys && s->values && s->order && s->spare && s->hits ? STATUS_OK
                                                                                     : e->status;
}

static enum status allocate_arrays(struct backend *b, struct error *e)
{
    const struct {
        float **array;
        const char *label;
        bool wanted;
    } arrays[] = {
        {&b->arrays.inverse_density, "kernel sums",
         b->choice.is_implicit && b->particles.now[FIELD_FLUID]},
        {&b->arrays.number, "kernel sums", !b->choice.is_implicit && !b->choice.continuity},
        {&b->arrays.rest, "rest densities", b->choice.flags & PAIR_MIXED},
        {&b->arrays.fluid, "fluids of neighbours",
         b->choice.tension.any && b->particles.now[FIELD_FLUID]},
    };
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++)
        if (arrays[k].wanted && !(*arrays[k].array = cuda_array(
                                      b, arrays[k].label, b->particles.count, sizeof(float), e)))
            return e->status;
    b->there = b->row->create(b->device, "constants", sizeof *b->there, e);
    b->scalars = b->row->create(b->device, "constants", sizeof *b->scalars, e);
    b->in = b->row->pin(b->device, (1 + SOLVE_COUNT) * sizeof *b->in, e);
    b->out = b->row->pin(b->device, sizeof *b->out, e);
    b->hash = b->row->create(b->device, "constants", sizeof *b->hash, e);
    b->hash_read = b->row->pin(b->device, sizeof *b->hash_read, e);
    if (!b->there || !b->scalars || !b->in || !b->out || !b->hash || !b->hash_read ||
        cuda_rows_create(b, &b->rows, b->particles.count, b->choice.projects, e) ||
        (b->wall.count && cuda_rows_create(b, &b->wall_rows, b->particles.count, false, e)))
        return e->status;
    return STATUS_OK;
}

/* Constants and numbers as they are before the first step. */
static enum status upload_constants(struct backend *b, struct error *e)
{
    struct scalars first = {.extremes = {.bad = UINT32_MAX}};
    if (cuda_upload(b, b->there, &b->choice, sizeof b->choice, e) ||
        cuda_upload(b, b->scalars, &first, sizeof first, e))
        return e->status;
    return STATUS_OK;
}

static enum status start(struct backend *b, struct error *e)
{
    if (b->wall.count && cuda_weigh_walls(b, e))
        return e->status;
    if (b->choice.is_implicit && b->particles.count) {
        struct work work = cuda_work(b, PASS_SORT, SOLVE_VELOCITY, false);
        cuda_launch(b, KERNEL_stage_rest_volumes, work.count, &work);
    }
    return b->row->wait(b->device, e);
}

enum status cuda_open_on(const struct device_row *row, const struct kernel *kernels,
                         struct backend **out, const struct backend_setup *setup,
                         struct particles *particles, struct particles *walls, struct error *e)
{
    struct backend *b = calloc(1, sizeof *b);
    struct device_info info;
    *out = NULL;
    e->status = STATUS_OK;
    if (!b)
        return error_set(e, STATUS_RUN, "out of memory");
    b->row = row;
    b->kernels = kernels;
    b->choice = *setup->choice;
    b->space = *setup->space;
    b->all = setup->search == &search_all_pairs;
    b->timed = setup->timed;
    b->block = setup->block;
    if (row->info(setup->device, &info, e) || check_memory(b, &info, particles, walls, e) ||
        row->open(&b->device, setup->device, e) ||
        upload_particles(b, particles, &b->particles, e) ||
        upload_particles(b, walls, &b->wall, e) || allocate_sorting(b, e) ||
        allocate_arrays(b, e) || upload_constants(b, e) || start(b, e)) {
        cuda_close(b);
        return e->status;
    }
    particles_free(particles);
    particles_free(walls);
    char block[32] = "";
    if (b->block)
        snprintf(block, sizeof block, ", %u threads a block", b->block);
    snprintf(b->text, sizeof b->text, "cuda (%s%s)", info.name, block);
    *out = b;
    return STATUS_OK;
}

enum status cuda_run(struct backend *b, enum pass_id pass, struct step *step, struct error *e)
{
    double start = clock_seconds();
    e->status = STATUS_OK;
    if (pass != PASS_SORT && pass != PASS_NEIGHBOURS && pass != PASS_CURL)
        return cuda_queue(b, pass, step, e);
    cuda_flush(b);
    if (pass == PASS_SORT)
        cuda_sort(b, &b->particles, &b->cells, step->list_radius, e);
    else if (pass == PASS_NEIGHBOURS)
        cuda_neighbours(b, step->list_radius, e);
    else
        cuda_curl(b, step->list_radius, e);
    if (!e->status && b->timed)
        b->row->wait(b->device, e);
    b->counts.seconds[pass] += clock_seconds() - start;
    b->counts.runs[pass]++;
    return e->status;
}

void cuda_swap(struct backend *b)
{
    particles_swap(&b->particles);
}

const struct particles *cuda_state(struct backend *b, unsigned fields, struct error *e)
{
    const struct particles *p = &b->particles;
    e->status = STATUS_OK;
    cuda_flush(b);
    b->seen.count = p->count;
    b->seen.fields = p->fields;
    for (int f = 0; f < FIELD_COUNT; f++) {
        size_t bytes = p->count * field_table[f].size;
        if (!(fields & FIELD_BIT(f)) || !p->now[f])
            continue;
        if (!b->seen.now[f])
            b->seen.now[f] = b->row->pin(b->device, bytes, e);
        if (!b->seen.now[f] || b->row->read(b->device, b->seen.now[f], p->now[f], bytes, e))
            return NULL;
    }
    return &b->seen;
}

const struct backend_counts *cuda_counts(struct backend *b)
{
    return &b->counts;
}

const char *cuda_describe(struct backend *b)
{
    return b->text;
}

double cuda_bandwidth(struct backend *b)
{
    return b->row->bandwidth(b->device);
}

double cuda_peak(struct backend *b)
{
    return b->row->peak(b->device);
}
