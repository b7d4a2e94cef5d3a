/* The kernels on the host: one thread after the other, from the last to the first, as any order must do. */
#include "backend/cuda/kernels.h"

#include <string.h>

#include "backend/cpu/lanes_scalar.h"

static inline void order_add(uint32_t *sum, uint32_t x)
{
    *sum += x;
}
static inline void order_add64(uint64_t *sum, uint64_t x)
{
    *sum += x;
}
static inline uint32_t order_bits(uint32_t word)
{
    return (uint32_t)__builtin_popcount(word);
}
static inline uint32_t order_lowest(uint32_t word)
{
    return (uint32_t)__builtin_ctz(word);
}
static inline void order_move(void *to, const void *from)
{
    memcpy(to, from, 16);
}
static inline void records_own(const void *records, real out[4])
{
    memcpy(out, records, 4 * sizeof *out);
}
static inline void rows_prefetch(const void *entry)
{
    (void)entry;
}
static inline void residual_count(const struct work *w, size_t i, int64_t error, int64_t signed_error)
{
    (void)i;
    w->scalars->sums.fixed[0] += error;
    w->scalars->sums.fixed[1] += signed_error;
}

#include "backend/bodies/each.h"
#include "backend/bodies/pair_bodies.h"
#include "backend/cuda/frame.h"
#include "backend/cuda/order.h"

#define KERNEL(name, ...)                                                                          \
    static void name(size_t threads, const void *args, void *stream)                               \
    {                                                                                              \
        const struct work *w = args;                                                               \
        (void)stream;                                                                              \
        if (work_ended(w))                                                                         \
            return;                                                                                \
        __VA_ARGS__;                                                                               \
    }
#define BACKWARDS for (size_t i = threads; i-- > 0;)
#define EACH(name, terms) KERNEL(run_##name, BACKWARDS each_##name(w, i))
#define EXTREMES(name, terms)                                                                      \
    KERNEL(run_##name, BACKWARDS each_##name(w, i, &w->scalars->extremes))
#define FIXED(name, terms)                                                                         \
    KERNEL(run_##name, BACKWARDS w->scalars->sums.fixed[0] += each_##name(w, i))
#define SCALAR(name, terms) KERNEL(run_##name, (void)threads; scalar_##name(w))
#define SUMS(name, terms)                                                                          \
    KERNEL(run_##name, BACKWARDS {                                                               \
        double term[SCALAR_SUMS];                                                                  \
        each_##name(w, i, term);                                                                   \
        for (int t = 0; t < (terms); t++)                                                          \
            exact_add(&w->scalars->sums.exact[t], term[t]);                                        \
    })
#define BLOCKS(name, terms)                                                                        \
    KERNEL(run_##name, BACKWARDS {                                                               \
        double sum[SCALAR_SUMS] = {0}, term[SCALAR_SUMS];                                          \
        if (i % PARTICLE_BLOCK != 0)                                                               \
            continue;                                                                              \
        for (size_t k = i; k < threads && k < i + PARTICLE_BLOCK; k++) {                           \
            each_##name(w, k, term);                                                               \
            for (int t = 0; t < (terms); t++)                                                      \
                sum[t] += term[t];                                                                 \
        }                                                                                          \
        for (int t = 0; t < (terms); t++)                                                          \
            exact_add(&w->scalars->sums.exact[t], sum[t]);                                         \
    })
#define STAGE(kind, name, terms) kind(name, terms)
#include "backend/bodies/stage_list.h"
#undef STAGE
#define PAIR(name, call) KERNEL(run_pair_##name, BACKWARDS call)
#include "backend/bodies/pair_list.h"
#define FORCE(flags)                                                                               \
    PAIR(force_##flags, force_sum(w, i, flags, false))                                             \
    PAIR(force_walls_##flags, force_sum(w, i, flags, true))
#include "backend/bodies/force_list.h"
#undef FORCE
#undef PAIR

#define ORDER(name)                                                                                \
    static void run_order_##name(size_t threads, const void *args, void *stream)                   \
    {                                                                                              \
        const struct order_work *w = args;                                                         \
        (void)stream;                                                                              \
        BACKWARDS order_##name(w, i);                                                              \
    }
#include "backend/cuda/order_list.h"
#undef ORDER

#define FRAME(name, type)                                                                          \
    static void run_frame_##name(size_t threads, const void *args, void *stream)                   \
    {                                                                                              \
        const type *w = args;                                                                      \
        (void)stream;                                                                              \
        BACKWARDS frame_##name(w, i);                                                              \
    }
#include "backend/cuda/frame_list.h"
#undef FRAME

const struct kernel kernels_host[KERNEL_COUNT] = {
#include "backend/cuda/kernel_rows.h"
};
