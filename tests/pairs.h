/* Clouds of particles with rows of neighbours, and plain double-precision sums over all of them,
 * for tests of the pair passes. */
#ifndef TESTS_PAIRS_H
#define TESTS_PAIRS_H

#include "backend/cpu/rows.h"
#include "base/memory.h"
#include "random.h"
#include "solver/explicit.h"
#include "solver/kernel.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { CLOUD_FIELDS = (1 << FIELD_COUNT) - 1, CLOUD_FLUIDS = 2 };

#define CLOUD_REACH 2.1 /* of the rows: beyond the support */

/* Lengths in units of the smoothing length: h = 1 m. */
struct cloud {
    size_t count, wall_count;
    struct space space;
    struct cells cells, wall_cells;
    struct particles particles, wall;
    uint32_t *axis[3], *wall_axis[3];
    float *number; /* w sums */
    float *rest;   /* rest density of each particle */
    struct rows rows, wall_rows;
    struct pair_constants constants;
    struct explicit_constants each; /* of diffusion */
    float rest_density[CLOUD_FLUIDS];
    double spacing; /* d */
};

enum cloud_kind { CLOUD_FLOW, CLOUD_CROWD, CLOUD_COINCIDENT, CLOUD_SPARSE, CLOUD_AT_EDGE };

static inline void cloud_place(struct cloud *c, enum cloud_kind kind, struct particles *p,
                               uint64_t *seed)
{
    double length = c->space.length[0];
    for (size_t i = 0; i < p->count; i++)
        for (int a = 0; a < 3; a++) {
            double x = random_between(seed, 0, length);
            if (kind == CLOUD_CROWD) /* all within one support */
                x = length / 2 + random_between(seed, -0.5, 0.5);
            if (kind == CLOUD_COINCIDENT) /* few places, many particles in each */
                x = (random_bits(seed) % 3 + 0.5) * length / 3;
            if (kind == CLOUD_AT_EDGE) /* multiples of h: many pairs exactly at q = 1 and 2 */
                x = floor(x);
            particles_position(p)[i].count[a] = (uint32_t)(int64_t)(x / c->space.unit[a]);
            particles_position(p)[i].volume = (float)random_between(seed, 0.5, 1.5);
        }
}

/* Velocities, pressures, densities; except in a flow every eighth particle has extreme or
 * zero values. */
static inline void cloud_fill(struct cloud *c, enum cloud_kind kind, uint64_t *seed)
{
    static const float extreme[] = {0, -0.0f, 1e-30f, 3e9f, -2e9f, 1e-41f};
    struct particles *p = &c->particles;
    for (size_t i = 0; i < c->count; i++) {
        struct motion *m = &particles_motion(p)[i];
        for (int a = 0; a < 3; a++)
            m->velocity[a] = (float)random_between(seed, -5, 5);
        m->pressure = (float)random_between(seed, -1000, 9000);
        if (kind != CLOUD_FLOW && i % 8 == 3) {
            m->pressure = extreme[random_bits(seed) % 6];
            m->velocity[i % 3] = extreme[random_bits(seed) % 3];
        }
        particles_density(p)[i] = (float)random_between(seed, 700, 1300);
        ((float *)p->now[FIELD_VISCOSITY])[i] = (float)random_between(seed, 0, 2);
        ((uint8_t *)p->now[FIELD_FLUID])[i] = random_bits(seed) % CLOUD_FLUIDS;
    }
}

/* Sorts p, whose other fields are not set yet, and copies coordinates by axis. */
static inline void cloud_sort(struct cloud *c, struct particles *p, struct cells *cells,
                              uint32_t *axis[3])
{
    struct error e = {0};
    size_t n = p->count;
    struct position *sorted = calloc(n + 1, sizeof *sorted);
    uint32_t *order = calloc(n + 1, 4), *scratch = calloc(n + 1, 4);
    for (size_t i = 0; i < n; i++)
        particles_id(p)[i] = (uint32_t)i;
    cells_resize(cells, &c->space, CLOUD_REACH, n);
    assert_int_equal(
        cells_sort(cells, particles_position(p), particles_id(p), n, order, scratch, &e), 0);
    for (size_t i = 0; i < n; i++)
        sorted[i] = particles_position(p)[order[i]];
    memcpy(particles_position(p), sorted, n * sizeof *sorted);
    for (int a = 0; a < 3; a++) {
        axis[a] = calloc(n + 2 * PARTICLE_BLOCK, 4);
        for (size_t i = 0; i < n; i++)
            axis[a][i] = sorted[i].count[a];
    }
    free(sorted), free(order), free(scratch);
}

static inline void cloud_constants(struct cloud *c)
{
    double d = c->spacing;
    for (int a = 0; a < 3; a++) {
        c->constants.scale[a] = (float)c->space.unit[a];
        c->constants.gravity[a] = c->constants.head[a] = (float)(a - 1) * 4.5f;
    }
    c->constants.self = 1;
    c->constants.viscosity = 2 * 0.7f;
    c->constants.inverse_h = 1;
    c->constants.central = 4;
    c->constants.artificial = 300;
    c->constants.diffusion = 0.02f;
    c->constants.gradient = c->constants.density = (float)(0.4 * d * d * d);
    c->rest_density[0] = 1000;
    c->rest_density[1] = 800;
    for (int f = 0; f < CLOUD_FLUIDS; f++) {
        c->each.rest_density[f] = c->rest_density[f];
        c->each.bulk[f] = 1e5f;
    }
}

/* The rows of all particles, as `isa` builds them. */
static inline void cloud_rows(const struct cloud *c, const struct isa_row *isa, struct rows *rows,
                              bool wall)
{
    struct error e = {0};
    struct row_build work = {.cells = wall ? &c->wall_cells : &c->cells,
                             .search = &search_index_sort,
                             .points = particles_position(&c->particles),
                             .point_count = c->count,
                             .candidate_count = wall ? c->wall_count : c->count,
                             .same = !wall,
                             .limit = (float)(CLOUD_REACH * CLOUD_REACH)};
    for (int a = 0; a < 3; a++) {
        work.axis[a] = wall ? c->wall_axis[a] : c->axis[a];
        work.scale[a] = c->constants.scale[a];
    }
    assert_int_equal(rows_create(rows, c->count, 1, false, &e), 0);
    assert_int_equal(rows_build(rows, &work, isa, !wall, &e), 0);
}

static inline void cloud_make(struct cloud *c, enum cloud_kind kind, size_t count, bool periodic,
                              uint64_t seed)
{
    struct error e;
    memset(c, 0, sizeof *c);
    c->count = count;
    c->wall_count = count / 2 + 1;
    c->spacing = 0.8;
    double length = kind == CLOUD_SPARSE ? 200 : 5 + c->spacing * cbrt((double)count);
    length = kind == CLOUD_AT_EDGE ? ceil(length) : length;
    for (int a = 0; a < 3; a++) {
        c->space.length[a] = length;
        c->space.periodic[a] = periodic;
        c->space.unit[a] = length * (periodic ? 0x1p-32 : 0x1p-31);
    }
    assert_int_equal(particles_create(&c->particles, count, CLOUD_FIELDS, &e), 0);
    assert_int_equal(particles_create(&c->wall, c->wall_count,
                                      FIELD_BIT(FIELD_POSITION) | FIELD_BIT(FIELD_ID), &e), 0);
    c->number = calloc(count + 2 * PARTICLE_BLOCK, sizeof *c->number);
    c->rest = calloc(count + 2 * PARTICLE_BLOCK, sizeof *c->number);
    cloud_constants(c);
    cloud_place(c, kind, &c->particles, &seed);
    cloud_place(c, kind, &c->wall, &seed);
    cloud_sort(c, &c->particles, &c->cells, c->axis);
    cloud_sort(c, &c->wall, &c->wall_cells, c->wall_axis);
    cloud_fill(c, kind, &seed);
    cloud_rows(c, &isa_scalar, &c->rows, false);
    cloud_rows(c, &isa_scalar, &c->wall_rows, true);
}

static inline void cloud_free(struct cloud *c)
{
    particles_free(&c->particles);
    particles_free(&c->wall);
    cells_free(&c->cells);
    cells_free(&c->wall_cells);
    rows_free(&c->rows);
    rows_free(&c->wall_rows);
    for (int a = 0; a < 3; a++)
        free(c->axis[a]), free(c->wall_axis[a]);
    free(c->number);
    free(c->rest);
}

/* The function of a pass, with or without wall particles; NULL when there is none. */
static inline pair_function *cloud_find(const struct isa_row *isa, enum pair_pass pass,
                                        unsigned flags, bool walls)
{
    static const struct position wall;
    const struct work work = {.wall = walls ? &wall : NULL};
    return isa_pair(isa, pass, &work, flags);
}

/* Runs a pass over the whole cloud; results are in `number` or in the field rate. */
static inline void cloud_run(struct cloud *c, pair_function *pass)
{
    struct particles *p = &c->particles;
    for (size_t i = 0; i < c->count; i++)
        c->rest[i] = c->rest_density[particles_fluid(p, i)];
    static struct solver_choice choice;
    choice.each = c->each;
    struct work work = {.constants = c->constants,
                        .choice = &choice,
                        .gradient = p->now[FIELD_GRADIENT],
                        .rest = c->rest,
                        .position = particles_position(p),
                        .motion = particles_motion(p),
                        .viscosity = p->now[FIELD_VISCOSITY],
                        .density = particles_density(p),
                        .fluid = p->now[FIELD_FLUID],
                        .rate = particles_rate(p),
                        .number = c->number,
                        .rows = c->rows.block,
                        .row_count = c->rows.count,
                        .wall = particles_position(&c->wall),
                        .wall_rows = c->wall_rows.block,
                        .wall_row_count = c->wall_rows.count,
                        .count = c->count};
    size_t blocks = (c->count + PARTICLE_BLOCK - 1) / PARTICLE_BLOCK;
    pass(&work, 0, blocks / 2);
    pass(&work, blocks / 2, blocks);
}

#endif
