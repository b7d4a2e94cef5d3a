/* CUDA devices, by the runtime API, which finds the driver when it is first used. */
#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>
#include <cuda_runtime.h>

#include <stdlib.h>
#include <string.h>

#include "device/device_cuda.h"
extern "C" {
#include "base/log.h"
}

struct device_graph {
    cudaGraphExec_t exec;
    char name[FAILED_NAME]; /* its first kernel and its last */
};

cudaStream_t cuda_stream(struct device *d)
{
    int index = -1;
    if (cudaGetDevice(&index) != cudaSuccess || index != d->index)
        cudaSetDevice(d->index);
    return d->stream;
}

bool cuda_keep(struct device *d, cudaError_t result, const char *what)
{
    if (result != cudaSuccess && d->failure == cudaSuccess) {
        d->failure = result;
        snprintf(d->failed, sizeof d->failed, "%s", what ? what : "a copy");
    }
    return result == cudaSuccess;
}

enum status cuda_report(struct device *d, struct error *e)
{
    if (d->failure == cudaSuccess)
        return STATUS_OK;
    return error_set(e, STATUS_RUN, "the GPU failed in or before %s: %s (%s); frames up to now are "
                     "kept; use --backend cpu, or set CUDA_LAUNCH_BLOCKING=1 to find the pass",
                     d->failed, cudaGetErrorString(d->failure),
                     cudaGetErrorName(d->failure));
}

/* Without a driver CUDA says that it is too old, too; this is said where there is one. */
static const char *too_old(cudaError_t result)
{
    static char text[160];
    static bool told;
    int driver = 0, runtime = 0;
    if (result != cudaErrorInsufficientDriver || cudaDriverGetVersion(&driver) != cudaSuccess || driver == 0)
        return NULL;
    cudaRuntimeGetVersion(&runtime);
    snprintf(text, sizeof text, "the GPU's driver knows CUDA up to %d.%d, and this program was built with %d.%d: use "
             "a newer driver, or build with an older toolkit (make NVCC=...)", driver / 1000, driver % 1000 / 10,
             runtime / 1000, runtime % 1000 / 10);
    if (!told)
        log_info("warning: %s", text);
    told = true;
    return text;
}

static int cuda_count(const char **why)
{
    int count = 0;
    cudaError_t result = cudaGetDeviceCount(&count);
    const char *old = too_old(result);
    *why = result == cudaSuccess ? "" : old ? old : cudaGetErrorString(result);
    cudaGetLastError();
    return result == cudaSuccess ? count : 0;
}

static enum status cuda_exists(int index, struct error *e)
{
    const char *why;
    int count = cuda_count(&why);
    if (count == 0)
        return error_set(e, STATUS_BACKEND, "there is no GPU that CUDA can use%s%s; use --backend cpu and "
                         "--renderer cpu", *why ? ": " : "", why);
    if (index < 0 || index >= count)
        return error_set(e, STATUS_BACKEND, "cuda:%d: %s; see sph-render list devices", index,
                         count == 1 ? "there is one device, number 0" : "there are not so many devices");
    return STATUS_OK;
}

static enum status cuda_info(int index, struct device_info *info, struct error *e)
{
    struct cudaDeviceProp p;
    memset(info, 0, sizeof *info);
    if (cuda_exists(index, e))
        return e->status;
    cudaError_t result = cudaSetDevice(index);
    if (result == cudaSuccess)
        result = cudaGetDeviceProperties(&p, index);
    if (result == cudaSuccess)
        result = cudaMemGetInfo(&info->free, &info->memory);
    cudaGetLastError();
    if (result != cudaSuccess)
        return error_set(e, STATUS_RUN, "cuda:%d: %s", index, cudaGetErrorString(result));
    snprintf(info->name, sizeof info->name, "%s", p.name);
    info->compute = 10 * p.major + p.minor;
    cudaDriverGetVersion(&info->driver);
    cudaRuntimeGetVersion(&info->runtime);
    return STATUS_OK;
}

static void cuda_close(struct device *d)
{
    if (!d)
        return;
    cudaSetDevice(d->index);
    cudaFree(d->scratch);
    if (d->stream)
        cudaStreamDestroy(d->stream);
    free(d);
}

static enum status cuda_open(struct device **out, int index, struct error *e)
{
    struct device *d = (struct device *)calloc(1, sizeof *d);
    *out = NULL;
    if (!d)
        return error_set(e, STATUS_RUN, "out of memory");
    d->index = index;
    cudaError_t result = cudaSetDevice(index);
    if (result == cudaSuccess)
        result = cudaStreamCreateWithFlags(&d->stream, cudaStreamNonBlocking);
    if (result != cudaSuccess) {
        cuda_close(d);
        return error_set(e, STATUS_RUN, "cuda:%d: %s", index, cudaGetErrorString(result));
    }
    *out = d;
    return STATUS_OK;
}

static void *cuda_create(struct device *d, const char *label, size_t bytes, struct error *e)
{
    void *block = NULL;
    size_t available = 0, all = 0;
    bytes = bytes ? bytes : 1;
    cudaStream_t stream = cuda_stream(d);
    cudaError_t result = cudaMalloc(&block, bytes);
    if (result == cudaSuccess) {
        cuda_keep(d, cudaMemsetAsync(block, 0, bytes, stream), label);
        return block;
    }
    cudaGetLastError();
    if (result != cudaErrorMemoryAllocation) {
        cuda_keep(d, result, label);
        cuda_report(d, e);
        return NULL;
    }
    cudaMemGetInfo(&available, &all);
    error_set(e, STATUS_RUN, "%s take %.4g GB of the GPU's memory, of which %.4g GB are free (%s): use a "
              "larger particles.spacing, a smaller --size, or --backend cpu", label, 1e-9 * (double)bytes,
              1e-9 * (double)available, cudaGetErrorString(result));
    return NULL;
}

static void cuda_destroy(struct device *d, void *block)
{
    cuda_stream(d);
    cudaFree(block);
}

static void *cuda_pin(struct device *d, size_t bytes, struct error *e)
{
    void *block = NULL;
    cuda_stream(d);
    cudaError_t result = cudaMallocHost(&block, bytes ? bytes : 1);
    if (result == cudaSuccess) {
        memset(block, 0, bytes);
        return block;
    }
    cudaGetLastError();
    if (result != cudaErrorMemoryAllocation) {
        cuda_keep(d, result, d->last);
        cuda_report(d, e);
        return NULL;
    }
    error_set(e, STATUS_RUN, "%.4g GB of memory that the GPU can copy to cannot be had: %s",
              1e-9 * (double)bytes, cudaGetErrorString(result));
    return NULL;
}

static void cuda_unpin(struct device *d, void *block)
{
    cuda_stream(d);
    cudaFreeHost(block);
}

static void cuda_upload(struct device *d, void *to, const void *host, size_t bytes)
{
    if (bytes > 0)
        cuda_keep(d, cudaMemcpyAsync(to, host, bytes, cudaMemcpyHostToDevice, cuda_stream(d)), d->last);
}

static void cuda_copy(struct device *d, void *to, const void *from, size_t bytes)
{
    if (bytes > 0)
        cuda_keep(d, cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToDevice, cuda_stream(d)), d->last);
}

static void cuda_clear(struct device *d, void *to, size_t bytes)
{
    if (bytes > 0)
        cuda_keep(d, cudaMemsetAsync(to, 0, bytes, cuda_stream(d)), d->last);
}

static enum status cuda_wait(struct device *d, struct error *e)
{
    cuda_keep(d, cudaStreamSynchronize(cuda_stream(d)), d->last);
    return cuda_report(d, e);
}

static enum status cuda_read(struct device *d, void *host, const void *from, size_t bytes,
                             struct error *e)
{
    if (bytes > 0)
        cuda_keep(d, cudaMemcpyAsync(host, from, bytes, cudaMemcpyDeviceToHost, cuda_stream(d)), d->last);
    return cuda_wait(d, e);
}

static void cuda_launch(struct device *d, const struct kernel *kernel, size_t threads,
                        const void *args)
{
    if (threads == 0)
        return;
    d->last = kernel->name;
    d->first = d->first ? d->first : kernel->name;
    kernel->run(threads, args, cuda_stream(d));
    cuda_keep(d, cudaGetLastError(), kernel->name);
}

/* Scratch memory of at least so many bytes. */
static bool reserve(struct device *d, size_t bytes, struct error *e)
{
    if (bytes <= d->scratch_bytes)
        return true;
    cudaFree(d->scratch);
    d->scratch_bytes = 0;
    d->scratch = cuda_create(d, "sorting and scanning", bytes + bytes / 4, e);
    if (d->scratch)
        d->scratch_bytes = bytes + bytes / 4;
    return d->scratch != NULL;
}

static cudaError_t sort_pairs(void *scratch, size_t *bytes, const struct device_sort *s,
                              cudaStream_t stream)
{
    return cub::DeviceRadixSort::SortPairs(scratch, *bytes, s->keys, s->sorted_keys, s->values,
                                           s->sorted_values, (uint32_t)s->count, 0, s->bits, stream);
}

static enum status cuda_sort(struct device *d, const struct device_sort *s, struct error *e)
{
    size_t bytes = 0;
    cuda_keep(d, sort_pairs(NULL, &bytes, s, cuda_stream(d)), "sort");
    if (!reserve(d, bytes, e))
        return e->status;
    d->last = "sort";
    cuda_keep(d, sort_pairs(d->scratch, &bytes, s, cuda_stream(d)), "sort");
    return cuda_report(d, e);
}

/* In place: the sum of `count` values arrives behind them. */
static enum status cuda_scan(struct device *d, uint32_t *values, size_t count, struct error *e)
{
    size_t bytes = 0;
    uint32_t all = (uint32_t)count + 1;
    cuda_keep(d, cub::DeviceScan::ExclusiveSum(NULL, bytes, values, values, all, cuda_stream(d)), "scan");
    if (!reserve(d, bytes, e))
        return e->status;
    d->last = "scan";
    cuda_keep(d, cub::DeviceScan::ExclusiveSum(d->scratch, bytes, values, values, all, cuda_stream(d)), "scan");
    return cuda_report(d, e);
}

static bool cuda_record(struct device *d)
{
    const char *waits = getenv("CUDA_LAUNCH_BLOCKING");
    d->before = d->failure;
    d->first = d->last = NULL;
    if (waits && strcmp(waits, "1") == 0) /* each kernel by itself, so that the one that fails is named */
        return false;
    bool ok = cudaStreamBeginCapture(cuda_stream(d), cudaStreamCaptureModeRelaxed) == cudaSuccess;
    cudaGetLastError();
    return ok;
}

/* What fails within a recording has not been run, and will be without it. */
static struct device_graph *cuda_recorded(struct device *d)
{
    struct device_graph *g = (struct device_graph *)calloc(1, sizeof *g);
    cudaGraph_t graph = NULL;
    bool ok = cudaStreamEndCapture(cuda_stream(d), &graph) == cudaSuccess && g &&
              d->failure == d->before && cudaGraphInstantiate(&g->exec, graph, 0) == cudaSuccess;
    if (graph)
        cudaGraphDestroy(graph);
    if (ok) {
        snprintf(g->name, sizeof g->name, "a kernel from %s to %s", d->first ? d->first : "copies", d->last ? d->last : "copies");
        return g;
    }
    cudaGetLastError();
    d->failure = d->before;
    free(g);
    return NULL;
}

static void cuda_replay(struct device *d, struct device_graph *graph)
{
    d->last = graph->name;
    cuda_keep(d, cudaGraphLaunch(graph->exec, cuda_stream(d)), graph->name);
}

static void cuda_forget(struct device *d, struct device_graph *graph)
{
    cudaStreamSynchronize(cuda_stream(d));
    d->last = d->last == graph->name ? "passes" : d->last;
    cudaGraphExecDestroy(graph->exec);
    free(graph);
}

extern "C" const struct device_row device_cuda = {
    .count = cuda_count,
    .exists = cuda_exists,
    .info = cuda_info,
    .open = cuda_open,
    .close = cuda_close,
    .create = cuda_create,
    .destroy = cuda_destroy,
    .pin = cuda_pin,
    .unpin = cuda_unpin,
    .upload = cuda_upload,
    .copy = cuda_copy,
    .clear = cuda_clear,
    .read = cuda_read,
    .launch = cuda_launch,
    .sort = cuda_sort,
    .scan = cuda_scan,
    .wait = cuda_wait,
    .record = cuda_record,
    .recorded = cuda_recorded,
    .replay = cuda_replay,
    .forget = cuda_forget,
    .event = cuda_event,
    .drop = cuda_drop,
    .signal = cuda_signal,
    .follow = cuda_follow,
    .attach = cuda_attach,
    .detach = cuda_detach,
    .map = cuda_map,
    .unmap = cuda_unmap,
    .peak = cuda_peak,
    .bandwidth = cuda_bandwidth,
};
