/* What lanes of the cpu read of consecutive particles, and how they count; part of pair_loops.h. */

/* Row entries of consecutive particles. */
static const uint32_t lane_ramp[PARTICLE_BLOCK] = {0,  2,  4,  6,  8,  10, 12, 14,
                                                   16, 18, 20, 22, 24, 26, 28, 30};

static inline __attribute__((always_inline)) void records_own(const void *records, real out[4])
{
    records_load(records, lane_ramp, out);
}

/* Adds to what the particle's block leaves: a block is one thread's. */
static inline __attribute__((always_inline)) void residual_count(const struct work *w, size_t i,
                                                                 int64_t error, int64_t signed_error)
{
    int64_t *residual = &w->solve.residual[2 * (i / PARTICLE_BLOCK)];
    if (i % PARTICLE_BLOCK == 0)
        residual[0] = residual[1] = 0;
    residual[0] += error;
    residual[1] += signed_error;
}

static inline __attribute__((always_inline)) void rows_prefetch(const void *entry)
{
    __builtin_prefetch(entry);
}
