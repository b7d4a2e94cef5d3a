/* The launch layer on the host: the kernels of the CUDA back end one thread after the other, from the last
 * to the first, so that its pass list, graphs and buffers are tested where there is no GPU. */
#include "backend/cuda/device.h"

#include "base/machine.h"
#include "base/memory.h"

#include <stdio.h>
#include <stdlib.h>
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
#include "backend/cuda/order.h"

/* A launch or a copy that is queued. */
struct command {
    enum kernel kernel; /* KERNEL_COUNT: a copy, or without `from` a clear */
    size_t size;        /* threads, or bytes */
    void *to;
    const void *from;
    struct work work;
    struct order_work order;
};

struct device_graph {
    struct command *command;
    size_t count, room;
};

struct device {
    struct device_graph *recording; /* or NULL */
    bool lost;                      /* memory for a recording */
};

#define KERNEL(name, ...)                                                                          \
    static void name(size_t threads, const struct work *w)                                         \
    {                                                                                              \
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

static void run_order(enum kernel kernel, size_t threads, const struct order_work *w)
{
    switch (kernel) {
#define ORDER(name)                                                                                \
    case KERNEL_order_##name:                                                                      \
        BACKWARDS order_##name(w, i);                                                              \
        break;
#include "backend/cuda/order_list.h"
#undef ORDER
    default: break;
    }
}

static void run(const struct command *c)
{
    static void (*const table[KERNEL_ORDERS])(size_t, const struct work *) = {
#define STAGE(kind, name, terms) run_##name,
#include "backend/bodies/stage_list.h"
#undef STAGE
#define PAIR(name, call) run_pair_##name,
#include "backend/bodies/pair_list.h"
#undef PAIR
#define FORCE(flags) run_pair_force_##flags, run_pair_force_walls_##flags,
#include "backend/bodies/force_list.h"
#undef FORCE
    };
    if (c->kernel == KERNEL_COUNT && c->from)
        memcpy(c->to, c->from, c->size);
    else if (c->kernel == KERNEL_COUNT)
        memset(c->to, 0, c->size);
    else if (c->kernel >= KERNEL_ORDERS)
        run_order(c->kernel, c->size, &c->order);
    else
        table[c->kernel](c->size, &c->work);
}

/* Runs a command, or keeps it. */
static void queue(struct device *d, const struct command *c)
{
    struct device_graph *g = d->recording;
    if (!g) {
        run(c);
        return;
    }
    if (g->count == g->room) {
        size_t room = g->room ? 2 * g->room : 16;
        struct command *more = realloc(g->command, room * sizeof *more);
        d->lost = d->lost || !more;
        if (!more)
            return;
        g->command = more;
        g->room = room;
    }
    g->command[g->count++] = *c;
}

static void host_launch(struct device *d, enum kernel kernel, size_t threads, const void *work)
{
    struct command c = {.kernel = kernel, .size = threads};
    if (kernel >= KERNEL_ORDERS)
        c.order = *(const struct order_work *)work;
    else
        c.work = *(const struct work *)work;
    queue(d, &c);
}

static void host_copy(struct device *d, void *to, const void *from, size_t bytes)
{
    queue(d, &(struct command){.kernel = KERNEL_COUNT, .to = to, .from = from, .size = bytes});
}

static void host_clear(struct device *d, void *to, size_t bytes)
{
    queue(d, &(struct command){.kernel = KERNEL_COUNT, .to = to, .size = bytes});
}

static int host_count(const char **why)
{
    *why = "";
    return 1;
}

static enum status host_info(int index, struct device_info *info, struct error *e)
{
    const char *what;
    *info = (struct device_info){.name = "host"};
    info->memory = info->free = (size_t)machine_memory(&what);
    return index == 0 ? STATUS_OK : error_set(e, STATUS_USAGE, "there is one host");
}

static enum status host_open(struct device **d, int index, struct error *e)
{
    (void)index;
    *d = calloc(1, sizeof **d);
    return *d ? STATUS_OK : error_set(e, STATUS_RUN, "out of memory");
}

static void host_close(struct device *d)
{
    free(d);
}

static void *host_create(struct device *d, const char *label, size_t bytes, struct error *e)
{
    (void)d;
    return memory_create(label, bytes ? bytes : 1, 1, e);
}

static void host_destroy(struct device *d, void *block)
{
    (void)d;
    memory_free(block);
}

static void *host_pin(struct device *d, size_t bytes, struct error *e)
{
    return host_create(d, "copies", bytes, e);
}

static enum status host_read(struct device *d, void *host, const void *from, size_t bytes,
                             struct error *e)
{
    (void)d;
    (void)e;
    memcpy(host, from, bytes);
    return STATUS_OK;
}

struct keyed {
    uint64_t key;
    uint32_t value;
};

static int keyed_compare(const void *a, const void *b)
{
    uint64_t x = ((const struct keyed *)a)->key, y = ((const struct keyed *)b)->key;
    return x < y ? -1 : x > y;
}

static enum status host_sort(struct device *d, const struct device_sort *s, struct error *e)
{
    (void)d;
    struct keyed *pairs = malloc((s->count + 1) * sizeof *pairs);
    if (!pairs)
        return error_set(e, STATUS_RUN, "out of memory");
    for (size_t i = 0; i < s->count; i++)
        pairs[i] = (struct keyed){s->keys[i], s->values[i]};
    qsort(pairs, s->count, sizeof *pairs, keyed_compare);
    for (size_t i = 0; i < s->count; i++) {
        s->sorted_keys[i] = pairs[i].key;
        s->sorted_values[i] = pairs[i].value;
    }
    free(pairs);
    return STATUS_OK;
}

static enum status host_scan(struct device *d, uint32_t *values, size_t count, struct error *e)
{
    uint32_t sum = 0;
    (void)d;
    (void)e;
    for (size_t k = 0; k <= count; k++) {
        uint32_t value = k < count ? values[k] : 0;
        values[k] = sum;
        sum += value;
    }
    return STATUS_OK;
}

static enum status host_wait(struct device *d, struct error *e)
{
    return d->lost ? error_set(e, STATUS_RUN, "out of memory for a recording") : STATUS_OK;
}

static void host_record(struct device *d)
{
    d->recording = calloc(1, sizeof *d->recording);
    d->lost = d->lost || !d->recording;
}

static struct device_graph *host_recorded(struct device *d)
{
    struct device_graph *graph = d->recording;
    d->recording = NULL;
    return graph;
}

static void host_replay(struct device *d, struct device_graph *graph)
{
    (void)d;
    for (size_t k = 0; k < graph->count; k++)
        run(&graph->command[k]);
}

static void host_forget(struct device *d, struct device_graph *graph)
{
    (void)d;
    if (graph)
        free(graph->command);
    free(graph);
}

static double host_peak(struct device *d)
{
    (void)d;
    return 0;
}

const struct device_row device_host = {
    .count = host_count,
    .info = host_info,
    .open = host_open,
    .close = host_close,
    .create = host_create,
    .destroy = host_destroy,
    .pin = host_pin,
    .unpin = host_destroy,
    .upload = host_copy,
    .copy = host_copy,
    .clear = host_clear,
    .read = host_read,
    .launch = host_launch,
    .sort = host_sort,
    .scan = host_scan,
    .wait = host_wait,
    .record = host_record,
    .recorded = host_recorded,
    .replay = host_replay,
    .forget = host_forget,
    .peak = host_peak,
};
