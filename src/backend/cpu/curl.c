/* Vorticity of the present state, for a frame: a sorted copy of the particles with neighbour rows of its
 * own, so that the order and the rows of the steps, hence their bits, stay as they are. */
#include "backend/cpu/cpu.h"

#include <string.h>

enum { SEEN = FIELD_BIT(FIELD_POSITION) | FIELD_BIT(FIELD_MOTION) | FIELD_BIT(FIELD_ID) };

static void copy_state(const struct particles *from, struct particles *to)
{
    for (int f = 0; f < FIELD_COUNT; f++)
        if (SEEN & FIELD_BIT(f))
            memcpy(to->now[f], from->now[f], from->count * field_table[f].size);
}

/* To where the particles are in memory, by id; the sort's scratch is free. */
static void hand_back(struct backend *b, const struct particles *seen)
{
    uint32_t *place = b->scratch;
    for (size_t i = 0; i < b->particles.count; i++)
        place[particles_id(&b->particles)[i]] = (uint32_t)i;
    for (size_t i = 0; i < seen->count; i++)
        particles_vorticity(&b->particles)[place[particles_id(seen)[i]]] = particles_vorticity(seen)[i];
}

static enum status sum_curls(struct backend *b, struct particles *seen, struct cells *cells,
                             struct rows *rows, double radius, struct error *e)
{
    if (cpu_sort(b, seen, cells, b->axis, radius, e))
        return e->status;
    struct row_build build = cpu_row_build(b, radius);
    build.cells = cells;
    build.points = particles_position(seen);
    if (rows_build(rows, &build, b->isa, true, e))
        return e->status;
    struct work work = {.constants = b->choice.pair, .position = particles_position(seen),
                             .motion = particles_motion(seen), .rows = rows->block,
                             .row_count = rows->count, .count = seen->count,
                             .vorticity = particles_vorticity(seen)};
    work.constants.inverse_h = 1 / b->choice.each.h; /* some solvers keep a factor of theirs in it */
    pair_function *pass = b->isa->pair[BODY_curl];
    size_t blocks = (seen->count + PARTICLE_BLOCK - 1) / PARTICLE_BLOCK;
#pragma omp parallel for schedule(dynamic, 16)
    for (size_t block = 0; block < blocks; block++)
        pass(&work, block, block + 1);
    return STATUS_OK;
}

enum status cpu_curl(struct backend *b, double radius, struct error *e)
{
    struct particles seen;
    struct cells cells = {0};
    struct rows rows = {0};
    size_t count = b->particles.count;
    if (particles_create(&seen, count, SEEN | FIELD_BIT(FIELD_VORTICITY), e))
        return e->status;
    if (!rows_create(&rows, count, b->threads, false, e)) {
        copy_state(&b->particles, &seen);
        if (!sum_curls(b, &seen, &cells, &rows, radius, e))
            hand_back(b, &seen);
    }
    particles_free(&seen);
    cells_free(&cells);
    rows_free(&rows);
    return e->status;
}
