/* A device for tests that does nothing until it must: what is queued runs when somebody waits for it, or when
 * another queue waits for an event behind it. It is the host all the same. So it shows memory that is used before
 * it is there, given back too early, or changed while it is still to be read. */
#ifndef LATE_DEVICE_H
#define LATE_DEVICE_H

#include "device/device.h"

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

enum late_kind { LATE_LAUNCH, LATE_COPY, LATE_UPLOAD, LATE_CLEAR, LATE_REPLAY, LATE_SIGNAL, LATE_FOLLOW };

struct late_event {
    struct late *by;  /* that signalled last */
    long asked, done; /* signals queued, and run */
};

struct late_command {
    enum late_kind kind;
    const struct kernel *kernel;
    void *to;
    const void *from;
    size_t size;
    struct device_graph *graph;
    struct late_event *event;
    long signal; /* that is waited for */
    _Alignas(16) unsigned char args[KERNEL_ARGS];
};

struct late {
    struct device *host;
    struct late_command *list;
    size_t count, first, room;
    bool recording;
};

static pthread_mutex_t late_mutex = PTHREAD_MUTEX_INITIALIZER;
static size_t late_deepest; /* commands that waited at a time */

static inline void late_step(struct late *l);

static inline void late_run(const struct late *l, const struct late_command *c)
{
    switch (c->kind) {
    case LATE_LAUNCH: device_host.launch(l->host, c->kernel, c->size, c->args); break;
    case LATE_COPY: device_host.copy(l->host, c->to, c->from, c->size); break;
    case LATE_UPLOAD: device_host.upload(l->host, c->to, c->from, c->size); break;
    case LATE_CLEAR: device_host.clear(l->host, c->to, c->size); break;
    case LATE_REPLAY: device_host.replay(l->host, c->graph); break;
    case LATE_SIGNAL: c->event->done = c->signal; break;
    case LATE_FOLLOW:
        while (c->event->done < c->signal)
            late_step(c->event->by);
        break;
    }
}

static inline void late_step(struct late *l)
{
    struct late_command command = l->list[l->first++];
    late_run(l, &command);
}

static inline void late_finish(struct late *l)
{
    late_deepest = l->count - l->first > late_deepest ? l->count - l->first : late_deepest;
    while (l->first < l->count)
        late_step(l);
    l->first = l->count = 0;
}

static inline void late_queue(struct device *d, const struct late_command *c)
{
    struct late *l = (struct late *)d;
    pthread_mutex_lock(&late_mutex);
    if (l->recording) {
        late_run(l, c);
    } else {
        if (l->count == l->room) {
            l->room = l->room ? 2 * l->room : 64;
            l->list = realloc(l->list, l->room * sizeof *l->list);
        }
        l->list[l->count++] = *c;
    }
    pthread_mutex_unlock(&late_mutex);
}

/* The host's device, with nothing left to do. */
static inline struct device *late_ready(struct device *d)
{
    struct late *l = (struct late *)d;
    pthread_mutex_lock(&late_mutex);
    late_finish(l);
    pthread_mutex_unlock(&late_mutex);
    return l->host;
}

static enum status late_open(struct device **out, int index, struct error *e)
{
    struct late *l = calloc(1, sizeof *l);
    *out = (struct device *)l;
    return device_host.open(&l->host, index, e);
}

static void late_close(struct device *d)
{
    device_host.close(late_ready(d));
    free(((struct late *)d)->list);
    free(d);
}

static void *late_create(struct device *d, const char *label, size_t bytes, struct error *e)
{
    void *block = device_host.create(((struct late *)d)->host, label, bytes, e);
    if (block) /* zeros arrive as late as everything does */
        late_queue(d, &(struct late_command){.kind = LATE_CLEAR, .to = block, .size = bytes});
    return block ? memset(block, 0xa5, bytes) : NULL;
}

static void late_destroy(struct device *d, void *block)
{
    device_host.destroy(late_ready(d), block);
}

static void *late_pin(struct device *d, size_t bytes, struct error *e)
{
    return device_host.pin(((struct late *)d)->host, bytes, e);
}

static void late_unpin(struct device *d, void *block)
{
    device_host.unpin(late_ready(d), block);
}

static void late_upload(struct device *d, void *to, const void *host, size_t bytes)
{
    late_queue(d, &(struct late_command){.kind = LATE_UPLOAD, .to = to, .from = host, .size = bytes});
}

static void late_copy(struct device *d, void *to, const void *from, size_t bytes)
{
    late_queue(d, &(struct late_command){.kind = LATE_COPY, .to = to, .from = from, .size = bytes});
}

static void late_clear(struct device *d, void *to, size_t bytes)
{
    late_queue(d, &(struct late_command){.kind = LATE_CLEAR, .to = to, .size = bytes});
}

static enum status late_read(struct device *d, void *host, const void *from, size_t bytes, struct error *e)
{
    return device_host.read(late_ready(d), host, from, bytes, e);
}

static void late_launch(struct device *d, const struct kernel *kernel, size_t threads, const void *args)
{
    struct late_command c = {.kind = LATE_LAUNCH, .kernel = kernel, .size = threads};
    memcpy(c.args, args, kernel->args_size);
    late_queue(d, &c);
}

static enum status late_sort(struct device *d, const struct device_sort *sort, struct error *e)
{
    return device_host.sort(late_ready(d), sort, e);
}

static enum status late_scan(struct device *d, uint32_t *values, size_t count, struct error *e)
{
    return device_host.scan(late_ready(d), values, count, e);
}

static enum status late_wait(struct device *d, struct error *e)
{
    return device_host.wait(late_ready(d), e);
}

static bool late_record(struct device *d)
{
    ((struct late *)d)->recording = device_host.record(((struct late *)d)->host);
    return ((struct late *)d)->recording;
}

static struct device_graph *late_recorded(struct device *d)
{
    ((struct late *)d)->recording = false;
    return device_host.recorded(((struct late *)d)->host);
}

static void late_replay(struct device *d, struct device_graph *graph)
{
    late_queue(d, &(struct late_command){.kind = LATE_REPLAY, .graph = graph});
}

static void late_forget(struct device *d, struct device_graph *graph)
{
    device_host.forget(late_ready(d), graph);
}

static struct device_event *late_event(struct device *d, struct error *e)
{
    (void)d;
    (void)e;
    return calloc(1, sizeof(struct late_event));
}

static void late_drop(struct device *d, struct device_event *event)
{
    (void)d;
    free(event);
}

static enum status late_signal(struct device *d, struct device_event *event, struct error *e)
{
    struct late_event *l = (struct late_event *)event;
    pthread_mutex_lock(&late_mutex);
    l->by = (struct late *)d;
    long signal = ++l->asked;
    pthread_mutex_unlock(&late_mutex);
    (void)e;
    late_queue(d, &(struct late_command){.kind = LATE_SIGNAL, .event = l, .signal = signal});
    return STATUS_OK;
}

static void late_follow(struct device *d, struct device_event *event)
{
    struct late_event *l = (struct late_event *)event;
    pthread_mutex_lock(&late_mutex);
    long signal = l->asked;
    pthread_mutex_unlock(&late_mutex);
    late_queue(d, &(struct late_command){.kind = LATE_FOLLOW, .event = l, .signal = signal});
}

static void late_detach(struct device *d, struct device_buffer *buffer)
{
    device_host.detach(late_ready(d), buffer);
}

static struct device_buffer *late_attach(struct device *d, const struct device_gl *gl, struct error *e)
{
    return device_host.attach(late_ready(d), gl, e);
}

static void *late_map(struct device *d, struct device_buffer *buffer, struct error *e)
{
    return device_host.map(late_ready(d), buffer, e);
}

static enum status late_unmap(struct device *d, struct device_buffer *buffer, struct error *e)
{
    return device_host.unmap(late_ready(d), buffer, e);
}

static inline struct device_row late_device(void)
{
    struct device_row row = device_host;
    row.open = late_open, row.close = late_close;
    row.create = late_create, row.destroy = late_destroy, row.pin = late_pin, row.unpin = late_unpin;
    row.upload = late_upload, row.copy = late_copy, row.clear = late_clear, row.read = late_read;
    row.launch = late_launch, row.sort = late_sort, row.scan = late_scan, row.wait = late_wait;
    row.record = late_record, row.recorded = late_recorded, row.replay = late_replay, row.forget = late_forget;
    row.event = late_event, row.drop = late_drop, row.signal = late_signal, row.follow = late_follow;
    row.attach = late_attach, row.detach = late_detach, row.map = late_map, row.unmap = late_unmap;
    return row;
}

#endif
