/* Builds neighbour rows block by block, each thread into its own arena. */
#include "backend/cpu/rows.h"

#include "base/memory.h"

#include <omp.h>
#include <string.h>

enum { CHUNK_ENTRIES = 1 << 20, CHUNKS_MAX = 4096 };

struct rows_arena {
    uint32_t *chunk[CHUNKS_MAX];
    size_t chunk_entries[CHUNKS_MAX];
    int chunks, current;
    size_t used; /* of the current chunk */
    struct row_scratch scratch;
    double entries;
    struct error error;
};

enum status rows_create(struct rows *rows, size_t points, int threads, bool weighted,
                        struct error *e)
{
    size_t blocks = points / PARTICLE_BLOCK + 1;
    *rows = (struct rows){.arena_count = threads, .weighted = weighted};
    rows->block = memory_create("neighbour rows", blocks, sizeof *rows->block, e);
    rows->count = memory_create("neighbour rows", blocks * PARTICLE_BLOCK, sizeof *rows->count, e);
    rows->arena = memory_create("neighbour rows", (size_t)threads, sizeof *rows->arena, e);
    if (!rows->block || !rows->count || !rows->arena) {
        rows_free(rows);
        return e->status;
    }
    return STATUS_OK;
}

/* Room for `entries` that stays where it is; NULL when memory is short. */
static uint32_t *arena_take(struct rows_arena *arena, size_t entries)
{
    while (arena->current < arena->chunks &&
           arena->used + entries > arena->chunk_entries[arena->current]) {
        arena->current++;
        arena->used = 0;
    }
    if (arena->current == arena->chunks) {
        size_t room = entries > CHUNK_ENTRIES ? entries : CHUNK_ENTRIES;
        if (arena->chunks == CHUNKS_MAX)
            return NULL;
        arena->chunk[arena->chunks] =
            memory_create("neighbour rows", room, sizeof(uint32_t), &arena->error);
        if (!arena->chunk[arena->chunks])
            return NULL;
        arena->chunk_entries[arena->chunks++] = room;
        arena->used = 0;
    }
    uint32_t *taken = arena->chunk[arena->current] + arena->used;
    arena->used += entries;
    return taken;
}

static enum status scratch_reserve(struct rows_arena *arena, size_t needed)
{
    struct row_scratch *scratch = &arena->scratch;
    memory_free(scratch->list);
    scratch->room = (needed + needed / 2 + 2 * PARTICLE_BLOCK) & ~(size_t)3;
    scratch->list = memory_create("neighbour rows", PARTICLE_BLOCK * scratch->room,
                                  sizeof(uint32_t), &arena->error);
    if (!scratch->list)
        scratch->room = 0;
    return scratch->list ? STATUS_OK : arena->error.status;
}

static enum status build_block(struct rows *rows, struct rows_arena *arena,
                               const struct row_build *work, const struct isa_row *isa,
                               bool pad_self, size_t block)
{
    struct row_scratch *scratch = &arena->scratch;
    uint32_t length = 0;
    for (size_t needed; (needed = isa->build(work, block, scratch)) > 0;)
        if (scratch_reserve(arena, needed))
            return arena->error.status;
    for (int l = 0; l < PARTICLE_BLOCK; l++)
        length = scratch->count[l] > length ? scratch->count[l] : length;
    for (size_t l = 0; l < PARTICLE_BLOCK; l++) {
        uint32_t self = pad_self ? 2 * (uint32_t)(block * PARTICLE_BLOCK + l) : 0;
        uint32_t *list = scratch->list + l * scratch->room;
        for (uint32_t k = scratch->count[l]; k < length; k++)
            list[k] = self;
        arena->entries += scratch->count[l];
    }
    size_t whole = (length + 3) & ~3u; /* interleave works on four entries at a time */
    size_t room = whole * PARTICLE_BLOCK;
    uint32_t *taken = arena_take(arena, rows->weighted ? 2 * room : room);
    if (!taken)
        return error_set(&arena->error, STATUS_RUN, "out of memory for neighbour rows");
    isa->interleave(scratch, length, taken);
    rows->block[block] = (struct row_block){taken, rows->weighted ? (float *)(taken + room) : NULL, length};
    memcpy(rows->count + block * PARTICLE_BLOCK, scratch->count, sizeof scratch->count);
    return STATUS_OK;
}

enum status rows_build(struct rows *rows, const struct row_build *work, const struct isa_row *isa,
                       bool pad_self, struct error *e)
{
    size_t blocks = (work->point_count + PARTICLE_BLOCK - 1) / PARTICLE_BLOCK;
    for (int t = 0; t < rows->arena_count; t++) {
        struct rows_arena *arena = &rows->arena[t];
        arena->current = 0;
        arena->used = 0;
        arena->entries = 0;
        arena->scratch.coincident = false;
        arena->error.status = STATUS_OK;
    }
#pragma omp parallel for schedule(dynamic, 16) num_threads(rows->arena_count)
    for (size_t b = 0; b < blocks; b++) {
        struct rows_arena *arena = &rows->arena[omp_get_thread_num()];
        if (!arena->error.status)
            build_block(rows, arena, work, isa, pad_self, b);
    }
    rows->entries = 0;
    rows->coincident = false;
    for (int t = 0; t < rows->arena_count; t++) {
        rows->entries += rows->arena[t].entries;
        rows->coincident |= rows->arena[t].scratch.coincident;
        if (rows->arena[t].error.status) {
            *e = rows->arena[t].error;
            return e->status;
        }
    }
    return STATUS_OK;
}

void rows_free(struct rows *rows)
{
    for (int t = 0; rows->arena && t < rows->arena_count; t++) {
        for (int c = 0; c < rows->arena[t].chunks; c++)
            memory_free(rows->arena[t].chunk[c]);
        memory_free(rows->arena[t].scratch.list);
    }
    memory_free(rows->block);
    memory_free(rows->count);
    memory_free(rows->arena);
    *rows = (struct rows){0};
}
