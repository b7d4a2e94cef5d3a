/* The launch layer: memory, kernels and graphs of a device that runs passes. One implementation is CUDA,
 * the other runs the same kernels on the host, for tests where there is no GPU.
 *
 * Everything is queued in one order; only read, scan_total and wait wait for it. Failures are kept and
 * reported by the next call that returns a status, with the name of the kernel. */
#ifndef BACKEND_CUDA_DEVICE_H
#define BACKEND_CUDA_DEVICE_H

#include "backend/cuda/order_work.h"
#include "backend/stages.h"
#include "base/error.h"

/* Kernels in one numbering: stages, pair bodies, and what sorts and builds rows. */
enum kernel {
#define STAGE(kind, name, terms) KERNEL_stage_##name,
#include "backend/bodies/stage_list.h"
#undef STAGE
#define PAIR(name, call) KERNEL_pair_##name,
#include "backend/bodies/pair_list.h"
#undef PAIR
#define FORCE(flags) KERNEL_pair_force_##flags, KERNEL_pair_force_walls_##flags,
#include "backend/bodies/force_list.h"
#undef FORCE
#define ORDER(name) KERNEL_order_##name,
#include "backend/cuda/order_list.h"
#undef ORDER
    KERNEL_COUNT,
    KERNEL_ORDERS = STAGE_COUNT + BODY_COUNT /* the first that takes struct order_work */
};

/* Name of a kernel, for messages. */
const char *kernel_name(enum kernel kernel);

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
    size_t count;
    int bits;
};

struct device;       /* an open device */
struct device_graph; /* launches that are repeated as one */

struct device_row {
    /* Devices there are; 0 without a driver or GPU, with the reason in *why. */
    int (*count)(const char **why);
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
    /* Runs a kernel for threads 0 .. threads - 1 on `work`: struct work, or struct order_work from
     * KERNEL_ORDERS on. */
    void (*launch)(struct device *device, enum kernel kernel, size_t threads, const void *work);
    /* Sorts keys, of which the lowest `bits` count, and the values with them. */
    enum status (*sort)(struct device *device, const struct device_sort *sort, struct error *e);
    /* values[k] becomes the sum of those before it, of `count`, values[count] of all. */
    enum status (*scan)(struct device *device, uint32_t *values, size_t count, struct error *e);
    enum status (*wait)(struct device *device, struct error *e);
    /* Between the two, launches and copies are kept instead of run; NULL when they cannot be. */
    void (*record)(struct device *device);
    struct device_graph *(*recorded)(struct device *device);
    void (*replay)(struct device *device, struct device_graph *graph);
    void (*forget)(struct device *device, struct device_graph *graph);
    /* Measured multiply-adds, FLOP/s. */
    double (*peak)(struct device *device);
};

extern const struct device_row device_host; /* on the host: for tests */
extern const struct device_row device_cuda; /* only with CUDA=1 */

#endif
