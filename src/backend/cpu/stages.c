/* Runs stages over the particles: loops over threads around the bodies of bodies/each_*.h. */
#include "backend/bodies/each.h"
#include "backend/cpu/cpu.h"

/* Raises `a` to what `b` has more. */
static void extremes_merge(struct extremes *a, const struct extremes *b)
{
    a->speed2 = b->speed2 > a->speed2 ? b->speed2 : a->speed2;
    a->acceleration2 = b->acceleration2 > a->acceleration2 ? b->acceleration2 : a->acceleration2;
    a->move2 = b->move2 > a->move2 ? b->move2 : a->move2;
    a->bad = b->bad < a->bad ? b->bad : a->bad;
}

static void sums_merge(struct scalar_sums *all, const struct scalar_sums *own, int terms)
{
    for (int t = 0; t < terms; t++)
        exact_merge(&all->exact[t], &own->exact[t]);
    all->fixed[0] += own->fixed[0];
}

static void terms_add(struct scalar_sums *own, const double term[SCALAR_SUMS], int terms)
{
    for (int t = 0; t < terms; t++)
        exact_add(&own->exact[t], term[t]);
}

static size_t block_count(const struct work *w)
{
    return (w->count + PARTICLE_BLOCK - 1) / PARTICLE_BLOCK;
}

/* A thread's copy of the work and its scalars is no store's to change, so that it stays in registers. */
#define HERE(w)                                                                                    \
    struct scalars numbers = *(w)->scalars;                                                        \
    struct work here = *(w);                                                                       \
    here.scalars = &numbers

/* A loop over threads; each collects in `own`, which is merged at its end. */
#define RUN(name) static void run_##name(const struct work *w)
#define THREADS(own, last) _Pragma("omp parallel") { own; HERE(w); \
    _Pragma("omp for schedule(static)") \
    for (size_t i = 0; i < (last); i++) {
#define MERGE(merge) } _Pragma("omp critical") merge; }

#define EACH(name, terms)                                                                          \
    RUN(name)                                                                                      \
    {                                                                                              \
        _Pragma("omp parallel")                                                                    \
        {                                                                                          \
            HERE(w);                                                                               \
            _Pragma("omp for schedule(static)") for (size_t i = 0; i < w->count; i++)              \
                each_##name(&here, i);                                                             \
        }                                                                                          \
    }
#define EXTREMES(name, terms)                                                                      \
    RUN(name)                                                                                      \
    {                                                                                              \
        THREADS(struct extremes own = {.bad = UINT32_MAX}, w->count)                               \
        each_##name(&here, i, &own);                                                               \
        MERGE(extremes_merge(&w->scalars->extremes, &own))                                         \
    }
#define SUMS(name, terms)                                                                          \
    RUN(name)                                                                                      \
    {                                                                                              \
        THREADS(struct scalar_sums own = {.fixed = {0}}, w->count)                                 \
        double term[SCALAR_SUMS];                                                                  \
        each_##name(&here, i, term);                                                               \
        terms_add(&own, term, terms);                                                              \
        MERGE(sums_merge(&w->scalars->sums, &own, terms))                                          \
    }
#define BLOCKS(name, terms)                                                                        \
    RUN(name)                                                                                      \
    {                                                                                              \
        THREADS(struct scalar_sums own = {.fixed = {0}}, block_count(w))                           \
        const size_t first = i * PARTICLE_BLOCK, left = w->count - first;                          \
        double sum[SCALAR_SUMS] = {0}, term[SCALAR_SUMS];                                          \
        for (size_t l = 0; l < PARTICLE_BLOCK && l < left; l++) {                                  \
            each_##name(&here, first + l, term);                                                   \
            _Pragma("GCC unroll 4") for (int t = 0; t < (terms); t++)                              \
                sum[t] += term[t];                                                                 \
        }                                                                                          \
        terms_add(&own, sum, terms);                                                               \
        MERGE(sums_merge(&w->scalars->sums, &own, terms))                                          \
    }
#define FIXED(name, terms)                                                                         \
    RUN(name)                                                                                      \
    {                                                                                              \
        THREADS(struct scalar_sums own = {.fixed = {0}}, w->count)                                 \
        own.fixed[0] += each_##name(&here, i);                                                     \
        MERGE(sums_merge(&w->scalars->sums, &own, 0))                                              \
    }
#define SCALAR(name, terms)                                                                        \
    RUN(name)                                                                                      \
    {                                                                                              \
        scalar_##name(w);                                                                          \
    }

#define STAGE(kind, name, terms) kind(name, terms)
#include "backend/bodies/stage_list.h"
#undef STAGE

void cpu_stage(const struct work *work, enum stage_id stage)
{
    static void (*const table[STAGE_COUNT])(const struct work *) = {
#define STAGE(kind, name, terms) [STAGE_##name] = run_##name,
#include "backend/bodies/stage_list.h"
#undef STAGE
    };
    table[stage](work);
}
