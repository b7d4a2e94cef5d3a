/* The cpu back end: OpenMP threads over blocks of particles, SIMD lanes within them. */
#include "backend/cpu/cpu.h"

#include "base/log.h"
#include "base/memory.h"
#include "solver/part.h"

#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static enum status choose_isa(struct backend *b, const char *name, struct error *e)
{
    const struct isa_row *row = (const struct isa_row *)variant_find(&isa_table, name);
    if (row && !row->supported())
        return error_set(e, STATUS_USAGE, "--isa %s: this processor does not have it; use auto",
                         name);
    for (size_t i = 0; !row && i < isa_table.count; i++)
        if (((const struct isa_row *)isa_table.rows[i])->supported())
            row = (const struct isa_row *)isa_table.rows[i];
    b->isa = row;
    return STATUS_OK;
}

static enum status allocate(struct backend *b, struct error *e)
{
    size_t n = b->particles.count, w = b->wall.count, most = n > w ? n : w;
    size_t padded = n + 2 * PARTICLE_BLOCK, wall_padded = w + 2 * PARTICLE_BLOCK;
    b->order = memory_create("sort", most + 1, sizeof(uint32_t), e);
    b->scratch = memory_create("sort", most + 1, sizeof(uint32_t), e);
    b->spare = memory_create("sort", most + 1, sizeof(struct position), e);
    bool ok = b->order && b->scratch && b->spare;
    for (int a = 0; a < 3; a++) {
        b->axis[a] = memory_create("coordinates", padded, sizeof(uint32_t), e);
        ok = ok && b->axis[a];
        if (w)
            b->wall_axis[a] = memory_create("coordinates", wall_padded, sizeof(uint32_t), e);
        ok = ok && (!w || b->wall_axis[a]);
    }
    if (b->choice.is_implicit) {
        b->arrays.residual = memory_create("residuals", 2 * (n / PARTICLE_BLOCK + 1),
                                    sizeof(int64_t), e);
        ok = ok && b->arrays.residual;
        if (b->particles.now[FIELD_FLUID]) {
            b->arrays.inverse_density = memory_create("kernel sums", padded, sizeof(float), e);
            ok = ok && b->arrays.inverse_density;
        }
    } else if (!b->choice.continuity) {
        b->arrays.number = memory_create("kernel sums", padded, sizeof(float), e);
        ok = ok && b->arrays.number;
    }
    if (b->choice.flags & PAIR_MIXED) {
        b->arrays.rest = memory_create("rest densities", padded, sizeof(float), e);
        ok = ok && b->arrays.rest;
    }
    if (b->choice.tension.any && b->particles.now[FIELD_FLUID]) {
        b->arrays.fluid = memory_create("fluids of neighbours", padded, sizeof(float), e);
        ok = ok && b->arrays.fluid;
    }
    if (!ok || rows_create(&b->rows, n, b->threads, b->choice.projects, e) ||
        (w && rows_create(&b->wall_rows, n, b->threads, false, e)))
        return e->status;
    return STATUS_OK;
}

struct row_build cpu_row_build(const struct backend *b, double radius)
{
    double reach = radius / b->choice.smoothing_length;
    struct row_build work = {
        .search = b->search,
        .cells = &b->cells,
        .points = particles_position(&b->particles),
        .point_count = b->particles.count,
        .axis = {b->axis[0], b->axis[1], b->axis[2]},
        .candidate_count = b->particles.count,
        .same = true,
        .limit = (float)(reach * reach),
    };
    memcpy(work.scale, b->choice.pair.scale, sizeof work.scale);
    return work;
}

/* Volumes of the wall particles, from rows among themselves. */
static enum status weigh_walls(struct backend *b, struct error *e)
{
    double reach = b->choice.support * (1 + SKIN_MAX);
    struct rows rows = {0};
    struct row_build work = cpu_row_build(b, b->choice.support);
    struct position *wall;
    float *number = memory_create("kernel sums", b->wall.count + PARTICLE_BLOCK, sizeof *number, e);
    if (!number || cpu_sort(b, &b->wall, &b->wall_cells, b->wall_axis, reach, e) ||
        rows_create(&rows, b->wall.count, b->threads, false, e))
        goto done;
    wall = particles_position(&b->wall);
    work.cells = &b->wall_cells;
    work.points = wall;
    work.point_count = work.candidate_count = b->wall.count;
    for (int a = 0; a < 3; a++)
        work.axis[a] = b->wall_axis[a];
    if (rows_build(&rows, &work, b->isa, true, e))
        goto done;
    struct work pairs = {.constants = b->choice.pair, .position = wall, .number = number,
                         .rows = rows.block, .row_count = rows.count, .count = b->wall.count};
    isa_pair(b->isa, PAIR_PASS_DENSITY, &pairs, b->choice.flags)(
        &pairs, 0, (b->wall.count + PARTICLE_BLOCK - 1) / PARTICLE_BLOCK);
    pairs.choice = &b->choice;
    pairs.scalars = &b->scalars;
    pairs.state.position = wall;
    cpu_stage(&pairs, STAGE_wall_volumes);
done:
    memory_free(number);
    rows_free(&rows);
    return e->status;
}

static void cpu_close(struct backend *b)
{
    if (!b)
        return;
    particles_free(&b->particles);
    particles_free(&b->wall);
    cells_free(&b->cells);
    cells_free(&b->wall_cells);
    rows_free(&b->rows);
    rows_free(&b->wall_rows);
    for (int a = 0; a < 3; a++) {
        memory_free(b->axis[a]);
        memory_free(b->wall_axis[a]);
    }
    memory_free(b->order);
    memory_free(b->scratch);
    memory_free(b->spare);
    memory_free(b->arrays.number);
    memory_free(b->arrays.residual);
    memory_free(b->arrays.inverse_density);
    memory_free(b->arrays.fluid);
    memory_free(b->arrays.rest);
    free(b);
}

/* All processors, but no more than the particles keep busy: each loop's end costs a few microseconds,
 * and on a busy machine milliseconds. */
static int usual_threads(size_t particles)
{
    enum { LEAST_PARTICLES = 1000 }; /* of a thread */
    size_t most = 1 + particles / LEAST_PARTICLES;
    int processors = omp_get_num_procs();
    return most < (size_t)processors ? (int)most : processors;
}

static enum status cpu_open(struct backend **out, const struct backend_setup *setup,
                            struct particles *particles, struct particles *walls, struct error *e)
{
    struct backend *b = calloc(1, sizeof *b);
    *out = NULL;
    e->status = STATUS_OK;
    if (!b)
        return error_set(e, STATUS_RUN, "out of memory");
    b->choice = *setup->choice;
    b->scalars.extremes.bad = UINT32_MAX;
    b->space = *setup->space;
    b->search = setup->search;
    b->threads = setup->threads > 0 ? setup->threads : usual_threads(particles->count);
    omp_set_num_threads(b->threads);
    b->particles = *particles;
    b->wall = *walls;
    *particles = *walls = (struct particles){0};
    if (choose_isa(b, setup->isa, e))
        goto failed;
    struct work none = {0};
    if (pair_find(PAIR_PASS_FORCE, &none, b->choice.flags) == BODY_COUNT && !b->choice.is_implicit) {
        error_set(e, STATUS_RUN, "no pair pass for flags %u", b->choice.flags);
        goto failed;
    }
    if (allocate(b, e) || (b->wall.count && weigh_walls(b, e)))
        goto failed;
    if (b->choice.is_implicit) {
        struct work work = cpu_work(b, PASS_SORT, 0);
        cpu_stage(&work, STAGE_rest_volumes);
    }
    snprintf(b->text, sizeof b->text, "cpu (%s, %d thread%s)", b->isa->variant.name, b->threads,
             b->threads == 1 ? "" : "s");
    *out = b;
    return STATUS_OK;
failed:
    cpu_close(b);
    return e->status;
}

/* Moves particles apart that share a place, by their rows. */
static void part(struct backend *b)
{
    struct work work = cpu_work(b, PASS_NEIGHBOURS, 0);
    work.parted = b->spare;
    cpu_stage(&work, STAGE_part);
    cpu_stage(&work, STAGE_parted);
    log_detail("%lld particles shared a place and were moved apart",
               (long long)b->scalars.sums.fixed[0]);
    b->scalars.sums.fixed[0] = 0;
}

static enum status build_neighbours(struct backend *b, double radius, struct error *e)
{
    struct row_build work = cpu_row_build(b, radius);
    work.coincident = part_near2(b->choice.spacing, b->choice.smoothing_length);
    if (rows_build(&b->rows, &work, b->isa, true, e))
        return e->status;
    if (b->rows.coincident) {
        part(b);
        if (cpu_sort(b, &b->particles, &b->cells, b->axis, radius, e))
            return e->status;
        work.points = particles_position(&b->particles);
        if (rows_build(&b->rows, &work, b->isa, true, e))
            return e->status;
    }
    work.coincident = 0;
    if (b->wall.count) {
        work.cells = &b->wall_cells;
        work.candidate_count = b->wall.count;
        work.same = false;
        for (int a = 0; a < 3; a++)
            work.axis[a] = b->wall_axis[a];
        if (rows_build(&b->wall_rows, &work, b->isa, false, e))
            return e->status;
    }
    if (b->arrays.rest) {
        struct work pass = cpu_work(b, PASS_NEIGHBOURS, 0);
        cpu_stage(&pass, STAGE_rest_densities);
    }
    b->counts.row_entries = b->rows.entries + b->wall_rows.entries;
    return STATUS_OK;
}

struct work cpu_work(struct backend *b, enum pass_id pass, enum solve solve)
{
    struct work_rows rows = {b->rows.block, b->wall_rows.block, b->rows.count, b->wall_rows.count};
    return work_make(pass, solve, false, &b->choice, &b->choice, &b->scalars, &b->particles,
                     b->wall.count ? particles_position(&b->wall) : NULL, &b->arrays, &rows);
}

/* Sums what the blocks left; of integers, it does not depend on their order. */
static void gather_residual(struct backend *b, size_t blocks)
{
    int64_t error = 0, signed_error = 0;
#pragma omp parallel for schedule(static) reduction(+ : error, signed_error)
    for (size_t k = 0; k < blocks; k++) {
        error += b->arrays.residual[2 * k];
        signed_error += b->arrays.residual[2 * k + 1];
    }
    b->scalars.sums.fixed[0] = error;
    b->scalars.sums.fixed[1] = signed_error;
}

void cpu_pair(struct backend *b, const struct work *work, enum pair_pass pass)
{
    size_t blocks = (work->count + PARTICLE_BLOCK - 1) / PARTICLE_BLOCK;
    pair_function *function = isa_pair(b->isa, pass, work, b->choice.flags);
#pragma omp parallel for schedule(dynamic, 16)
    for (size_t block = 0; block < blocks; block++)
        function(work, block, block + 1);
    b->counts.pairs += b->rows.entries + b->wall_rows.entries;
    if (pass == PAIR_PASS_SWEEP)
        gather_residual(b, blocks);
}

static void run_stages(struct backend *b, enum pass_id pass, enum solve solve)
{
    size_t count;
    const struct stage *stage = stages_of(pass, &count);
    struct work work = cpu_work(b, pass, solve);
    for (size_t k = 0; k < count; k++) {
        if (!stage_wanted(&stage[k], &b->choice, &work))
            continue;
        if (stage[k].is_pair)
            cpu_pair(b, &work, stage[k].pair);
        else
            cpu_stage(&work, stage[k].id);
    }
}

static enum status cpu_run(struct backend *b, enum pass_id pass, struct step *step,
                           struct error *e)
{
    double start = clock_seconds();
    e->status = STATUS_OK;
    scalars_set(&b->scalars, step);
    switch (pass) {
    case PASS_SORT:
        cpu_sort(b, &b->particles, &b->cells, b->axis, step->list_radius, e);
        break;
    case PASS_NEIGHBOURS: build_neighbours(b, step->list_radius, e); break;
    case PASS_CURL: cpu_curl(b, step->list_radius, e); break;
    default: run_stages(b, pass, step->solve); break;
    }
    scalars_get(&b->scalars, step);
    b->counts.seconds[pass] += clock_seconds() - start;
    b->counts.runs[pass]++;
    return e->status;
}

static void cpu_swap(struct backend *b)
{
    particles_swap(&b->particles);
}

static const struct particles *cpu_state(struct backend *b, unsigned fields, struct error *e)
{
    (void)fields;
    (void)e;
    return &b->particles;
}

static enum status cpu_show(struct backend *b, const struct shown *how, struct device_event *filled,
                            struct error *e)
{
    struct shown s = *how;
    (void)filled;
    (void)e;
    shown_from(&s, &b->particles, &b->wall);
#pragma omp parallel for schedule(static) num_threads(b->threads)
    for (size_t i = 0; i < s.count + s.wall_count; i++)
        shown_particle(&s, i);
    return STATUS_OK;
}

static enum status cpu_hash(struct backend *b, uint64_t *hash, struct error *e)
{
    (void)e;
    *hash = particles_hash(&b->particles);
    return STATUS_OK;
}

static const struct backend_counts *cpu_counts(struct backend *b)
{
    return &b->counts;
}

static const char *cpu_describe(struct backend *b)
{
    return b->text;
}

static double cpu_peak(struct backend *b)
{
    double best = 0;
    for (int trial = 0; trial < 5; trial++) {
        double flops = 0, start = clock_seconds();
        float sink = 0;
#pragma omp parallel reduction(+ : flops, sink)
        {
            float own;
            flops += b->isa->peak(2000000, &own);
            sink += own;
        }
        double rate = flops / (clock_seconds() - start);
        best = rate > best && sink == sink ? rate : best;
    }
    return best;
}

const struct backend_row backend_cpu = {
    .variant = {.name = "cpu", .doc = "OpenMP threads and SIMD lanes"},
    .open = cpu_open,
    .run = cpu_run,
    .begin = cpu_swap,
    .reject = cpu_swap,
    .state = cpu_state,
    .show = cpu_show,
    .hash = cpu_hash,
    .counts = cpu_counts,
    .describe = cpu_describe,
    .peak = cpu_peak,
    .close = cpu_close,
};
