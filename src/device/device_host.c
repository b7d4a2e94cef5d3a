/* The host as a device, which runs kernels at once or, in graphs, again and again: so what is made for GPUs
 * is tested where there is none. */
#include "device/device.h"

#include "base/machine.h"
#include "base/memory.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* A launch or a copy that is queued. */
struct command {
    const struct kernel *kernel; /* NULL: a copy, or without `from` a clear */
    size_t size;                 /* threads, or bytes */
    void *to;
    const void *from;
    _Alignas(16) unsigned char args[KERNEL_ARGS];
};

struct device_graph {
    struct command *command;
    size_t count, room;
};

struct device {
    struct device_graph *recording; /* or NULL */
    bool lost;                      /* memory for a recording */
    bool refused;                   /* the recording has what cannot be in one */
};

/* All that is queued is done at once, so an event has happened when it is signalled. */
struct device_event {
    char nothing;
};

struct device_buffer {
    struct device_gl gl;
};

static void run(const struct command *c)
{
    if (c->kernel)
        c->kernel->run(c->size, c->args, NULL);
    else if (c->from)
        memcpy(c->to, c->from, c->size);
    else
        memset(c->to, 0, c->size);
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

static void host_launch(struct device *d, const struct kernel *kernel, size_t threads,
                        const void *args)
{
    struct command c = {.kernel = kernel, .size = threads};
    memcpy(c.args, args, kernel->args_size);
    queue(d, &c);
}

static void host_copy(struct device *d, void *to, const void *from, size_t bytes)
{
    queue(d, &(struct command){.to = to, .from = from, .size = bytes});
}

static void host_clear(struct device *d, void *to, size_t bytes)
{
    queue(d, &(struct command){.to = to, .size = bytes});
}

static int host_count(const char **why)
{
    *why = "";
    return 1;
}

static enum status host_exists(int index, struct error *e)
{
    return index == 0 ? STATUS_OK : error_set(e, STATUS_USAGE, "there is one host");
}

static enum status host_info(int index, struct device_info *info, struct error *e)
{
    const char *what;
    *info = (struct device_info){.name = "host"};
    info->memory = info->free = (size_t)machine_memory(&what);
    return host_exists(index, e);
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
        pairs[i] = (struct keyed){s->keys[i] & (((uint64_t)1 << s->bits) - 1), s->values[i]};
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

static bool host_record(struct device *d)
{
    d->recording = calloc(1, sizeof *d->recording);
    d->refused = false;
    return d->recording != NULL;
}

static void host_forget(struct device *d, struct device_graph *graph)
{
    (void)d;
    if (graph)
        free(graph->command);
    free(graph);
}

static struct device_graph *host_recorded(struct device *d)
{
    struct device_graph *graph = d->recording;
    d->recording = NULL;
    if (!d->refused)
        return graph;
    host_forget(d, graph);
    return NULL;
}

static void host_replay(struct device *d, struct device_graph *graph)
{
    (void)d;
    for (size_t k = 0; k < graph->count; k++)
        run(&graph->command[k]);
}

static struct device_event *host_event(struct device *d, struct error *e)
{
    (void)d;
    return memory_create("events", 1, sizeof(struct device_event), e);
}

static void host_drop(struct device *d, struct device_event *event)
{
    (void)d;
    memory_free(event);
}

static void host_follow(struct device *d, struct device_event *event)
{
    (void)event;
    d->refused = d->recording != NULL;
}

static enum status host_signal(struct device *d, struct device_event *event, struct error *e)
{
    (void)e;
    host_follow(d, event);
    return STATUS_OK;
}

static struct device_buffer *host_attach(struct device *d, const struct device_gl *gl, struct error *e)
{
    (void)d;
    if (!gl->map) {
        error_set(e, STATUS_BACKEND, "buffer %u of OpenGL cannot be written to by the host", gl->name);
        return NULL;
    }
    struct device_buffer *buffer = memory_create("buffers of OpenGL", 1, sizeof *buffer, e);
    if (buffer)
        buffer->gl = *gl;
    return buffer;
}

static void host_detach(struct device *d, struct device_buffer *buffer)
{
    (void)d;
    memory_free(buffer);
}

static void *host_map(struct device *d, struct device_buffer *buffer, struct error *e)
{
    const struct device_gl *gl = &buffer->gl;
    if (d->recording) {
        error_set(e, STATUS_RUN, "a buffer of OpenGL cannot be mapped within a recording");
        return NULL;
    }
    void *block = gl->map(gl->context, gl->name, gl->bytes);
    if (!block)
        error_set(e, STATUS_RUN, "OpenGL does not give its buffer %u of %zu bytes", gl->name, gl->bytes);
    return block;
}

static enum status host_unmap(struct device *d, struct device_buffer *buffer, struct error *e)
{
    (void)d;
    if (buffer->gl.unmap(buffer->gl.context, buffer->gl.name))
        return STATUS_OK;
    return error_set(e, STATUS_RUN, "OpenGL lost the contents of its buffer %u", buffer->gl.name);
}

/* Tests do not measure. */
static double host_peak(struct device *d)
{
    (void)d;
    return 0;
}

const struct device_row device_host = {
    .count = host_count,
    .exists = host_exists,
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
    .event = host_event,
    .drop = host_drop,
    .signal = host_signal,
    .follow = host_follow,
    .attach = host_attach,
    .detach = host_detach,
    .map = host_map,
    .unmap = host_unmap,
    .peak = host_peak,
    .bandwidth = host_peak,
};
