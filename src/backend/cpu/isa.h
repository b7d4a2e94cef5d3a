/* Instruction sets: one row each, all compiled from the same loops (pair_loops.h, bodies/). */
#ifndef BACKEND_CPU_ISA_H
#define BACKEND_CPU_ISA_H

#include "backend/pairs.h"
#include "base/variant.h"
#include "grid/search.h"
#include "particles/particles.h"
#include <stdbool.h>

/* What a row build reads. `points` are the particles that get rows, `axis` the candidates. */
struct row_build {
    const struct cells *cells;
    const struct search_row *search;
    const struct position *points;
    size_t point_count;
    const uint32_t *axis[3];  /* candidates' coordinates, padded by a block */
    size_t candidate_count;
    bool same;                /* candidates are the points: leave the particle itself out */
    float scale[3];           /* counts to smoothing lengths */
    float limit;              /* square of the list radius, in smoothing lengths */
    float coincident;         /* and of the distance below which two share a place; 0: none does */
};

/* Rows of one block as they are being built: 16 lists of `room` entries each. */
struct row_scratch {
    uint32_t *list;
    size_t room;
    bool coincident; /* whether any neighbour so far is so near */
    uint32_t count[PARTICLE_BLOCK];
};

/* Sums of a pair body over the rows of the blocks first .. last - 1. */
typedef void pair_function(const struct work *work, size_t first_block, size_t last_block);

struct isa_row {
    struct variant variant;
    bool (*supported)(void);
    /* Lists of the particles of `block`; returns 0, or the room that the lists need. */
    size_t (*build)(const struct row_build *work, size_t block, struct row_scratch *scratch);
    /* Turns 16 lists into rows[k][16], k up to `length` rounded up to 4. */
    void (*interleave)(const struct row_scratch *scratch, uint32_t length, uint32_t *rows);
    pair_function *const *pair; /* by enum pair_body */
    /* Seconds-free peak probe: `rounds` dependent chains of FMA in all lanes; returns the FLOPs. */
    double (*peak)(long rounds, float *sink);
};

/* The function of a pair pass; NULL when no solver asks for it with these flags. */
static inline pair_function *isa_pair(const struct isa_row *isa, enum pair_pass pass,
                                      const struct work *work, unsigned flags)
{
    enum pair_body body = pair_find(pass, work, flags);
    return body == BODY_COUNT ? NULL : isa->pair[body];
}

extern const struct variant_table isa_table; /* "isas" */
extern const struct isa_row isa_scalar, isa_avx2, isa_avx512;

#endif
