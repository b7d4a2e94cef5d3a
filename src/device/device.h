/* Devices: memory, queued kernels and copies, and graphs of them. One implementation is CUDA,
 * the other the host itself, for tests where there is no GPU.
 *
 * Everything is queued in one order; only read and wait wait for it. Failures are kept and
 * reported by the next call that returns a status, with the name of the kernel. */
#ifndef DEVICE_DEVICE_H
#define DEVICE_DEVICE_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What threads 0 .. threads - 1 do with the record `args` of args_size bytes; `stream` is the device's own
 * queue. A room keeps a table of its kernels for each kind of device. */
struct kernel {
    const char *name;
    size_t args_size; /* at most KERNEL_ARGS */
    void (*run)(size_t threads, const void *args, void *stream);
};

enum { KERNEL_ARGS = 2048 };

enum { DEVICE_NAME = 128 };

struct device_info {
    char name[DEVICE_NAME]; /* "NVIDIA H100 80GB HBM3" */
    int compute;            /* compute capability, 90 for 9.0 */
    int driver, runtime;    /* CUDA versions, 12080 for 12.8 */
    size_t memory, free;    /* bytes */
};

/* Keys and values before and after, `count` of each. */
struct device_sort {
    const uint64_t *keys;
    uint64_t *sorted_keys;
    const uint32_t *values;
    uint32_t *sorted_values;
    size_t count; /* below 2^32 */
    int bits;
};

struct device;        /* an open device: a queue of its own on a GPU; several may share one GPU's memory */
struct device_graph;  /* launches that are repeated as one */
struct device_event;  /* a place in a device's queue, for which other queues can wait */
struct device_buffer; /* a buffer of OpenGL that the device writes to */

/* A buffer of OpenGL, of the context that is current in the calling thread. map and unmap are how the host
 * itself gets at it, for the device that is the host: map is NULL when it cannot. */
struct device_gl {
    unsigned name; /* of glGenBuffers */
    size_t bytes;
    void *(*map)(void *context, unsigned name, size_t bytes);
    bool (*unmap)(void *context, unsigned name);
    void *context;
};

struct device_row {
    /* Devices there are; 0 without a driver or GPU, with the reason in *why. */
    int (*count)(const char **why);
    /* STATUS_BACKEND when there is no such device; leaves it alone. */
    enum status (*exists)(int index, struct error *e);
    /* The same, and what it is. */
    enum status (*info)(int index, struct device_info *info, struct error *e);
    enum status (*open)(struct device **device, int index, struct error *e);
    void (*close)(struct device *device);
    /* Zeroed memory; NULL with STATUS_RUN when there is none. */
    void *(*create)(struct device *device, const char *label, size_t bytes, struct error *e);
    void (*destroy)(struct device *device, void *block);
    /* Host memory that copies may go to and from while the host goes on. */
    void *(*pin)(struct device *device, size_t bytes, struct error *e);
    void (*unpin)(struct device *device, void *block);
    /* Queued copies; `host` must be pinned and stay as it is until the device has read it. */
    void (*upload)(struct device *device, void *to, const void *host, size_t bytes);
    void (*copy)(struct device *device, void *to, const void *from, size_t bytes);
    void (*clear)(struct device *device, void *to, size_t bytes);
    /* Copies back, and waits for it. */
    enum status (*read)(struct device *device, void *host, const void *from, size_t bytes,
                        struct error *e);
    void (*launch)(struct device *device, const struct kernel *kernel, size_t threads,
                   const void *args);
    /* Sorts keys, of which the lowest `bits` count, and the values with them. */
    enum status (*sort)(struct device *device, const struct device_sort *sort, struct error *e);
    /* values[k] becomes the sum of those before it, of `count`, values[count] of all. */
    enum status (*scan)(struct device *device, uint32_t *values, size_t count, struct error *e);
    enum status (*wait)(struct device *device, struct error *e);
    /* Between the two, launches and copies are kept instead of run; false when they cannot be, and NULL when
     * they could not: then nothing has run. */
    bool (*record)(struct device *device);
    struct device_graph *(*recorded)(struct device *device);
    void (*replay)(struct device *device, struct device_graph *graph);
    void (*forget)(struct device *device, struct device_graph *graph);
    /* An event, and its end; NULL with STATUS_RUN when there is none to be had. */
    struct device_event *(*event)(struct device *device, struct error *e);
    void (*drop)(struct device *device, struct device_event *event);
    /* Queued: the event happens once all that is queued so far is done; what is queued from now on waits for
     * the event's latest signal, of any device on the same GPU. It never was: there is nothing to wait for.
     * Neither can be recorded: then `recorded` is NULL. signal says what has failed by then, and does not wait. */
    enum status (*signal)(struct device *device, struct device_event *event, struct error *e);
    void (*follow)(struct device *device, struct device_event *event);
    /* Makes a buffer of OpenGL one that kernels can write to, once; STATUS_BACKEND says why it cannot be. From
     * map to unmap it is the device's, and the address may differ each time; else it is OpenGL's. What it had
     * before is lost. Both are ordered with the device's queue, and cannot be recorded. The context must be
     * current in all four. */
    struct device_buffer *(*attach)(struct device *device, const struct device_gl *gl, struct error *e);
    void (*detach)(struct device *device, struct device_buffer *buffer);
    void *(*map)(struct device *device, struct device_buffer *buffer, struct error *e);
    enum status (*unmap)(struct device *device, struct device_buffer *buffer, struct error *e);
    /* Measured multiply-adds, FLOP/s, and bytes that a copy reads and writes, 1/s. */
    double (*peak)(struct device *device);
    double (*bandwidth)(struct device *device);
};

extern const struct device_row device_host; /* on the host: for tests */
extern const struct device_row device_cuda; /* only with CUDA=1 */

#endif
