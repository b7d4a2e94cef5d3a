/* Neighbour rows of all particles, in memory that is used again from build to build. */
#ifndef BACKEND_CPU_ROWS_H
#define BACKEND_CPU_ROWS_H

#include "backend/cpu/isa.h"
#include "base/error.h"

struct rows_arena; /* one thread's memory */

struct rows {
    struct row_block *block; /* of each 16 particles */
    uint32_t *count;         /* of each particle, padded to blocks */
    struct rows_arena *arena;
    int arena_count;
    double entries;          /* sum of count */
    bool weighted;           /* room for a weight beside each entry */
    bool coincident;         /* whether two particles share a place */
};

enum status rows_create(struct rows *rows, size_t points, int threads, bool weighted,
                        struct error *e);

/* Builds all rows; `pad_self` repeats the particle itself behind a short row, otherwise 0. */
enum status rows_build(struct rows *rows, const struct row_build *work, const struct isa_row *isa,
                       bool pad_self, struct error *e);
void rows_free(struct rows *rows);

#endif
