/* CUDA devices, by the runtime API, which finds the driver when it is first used. */
#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_scan.cuh>
#include <cuda_runtime.h>
#if HAVE_EGL
#include <GL/gl.h> /* which the next wants before it on Arm; nothing of OpenGL is linked */
#include <cuda_gl_interop.h>
#endif

#include <stdlib.h>
#include <string.h>

extern "C" {
#include "device/device.h"
}
#include "device/launch.h"

struct device {
    int index;
    cudaStream_t stream;
    void *scratch;       /* of sorting and scanning */
    size_t scratch_bytes;
    const char *last;    /* kernel that was launched last */
    cudaError_t failure; /* the first that was not reported yet */
    const char *failed;  /* what failed */
    cudaError_t before;  /* the failure before a recording began */
};

struct device_graph {
    cudaGraphExec_t exec;
};

struct device_event {
    cudaEvent_t event;
};

struct device_buffer {
    cudaGraphicsResource_t resource;
    size_t bytes;
};

/* The device of a thread's calls is the thread's own: frames may be drawn by another than steps. */
static cudaStream_t stream_of(struct device *d)
{
    int index = -1;
    if (cudaGetDevice(&index) != cudaSuccess || index != d->index)
        cudaSetDevice(d->index);
    return d->stream;
}

/* Keeps the first failure for the next call that can report it. */
static bool keep(struct device *d, cudaError_t result, const char *what)
{
    if (result != cudaSuccess && d->failure == cudaSuccess) {
        d->failure = result;
        d->failed = what;
    }
    return result == cudaSuccess;
}

static enum status report(struct device *d, struct error *e)
{
    if (d->failure == cudaSuccess)
        return STATUS_OK;
    return error_set(e, STATUS_RUN, "the GPU failed in or before %s: %s (%s); frames up to now are "
                     "kept; use --backend cpu, or set CUDA_LAUNCH_BLOCKING=1 to find the pass",
                     d->failed ? d->failed : "a copy", cudaGetErrorString(d->failure),
                     cudaGetErrorName(d->failure));
}

static int cuda_count(const char **why)
{
    int count = 0;
    cudaError_t result = cudaGetDeviceCount(&count);
    *why = result == cudaSuccess ? "" : cudaGetErrorString(result);
    cudaGetLastError();
    return result == cudaSuccess ? count : 0;
}

static enum status cuda_info(int index, struct device_info *info, struct error *e)
{
    struct cudaDeviceProp p;
    const char *why;
    int count = cuda_count(&why);
    memset(info, 0, sizeof *info);
    if (count == 0)
        return error_set(e, STATUS_BACKEND, "there is no GPU that CUDA can use%s%s; use --backend cpu and "
                         "--renderer cpu", *why ? ": " : "", why);
    if (index < 0 || index >= count)
        return error_set(e, STATUS_BACKEND, "cuda:%d: %s; see sph-render list devices", index,
                         count == 1 ? "there is one device, number 0" : "there are not so many devices");
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
    cudaStream_t stream = stream_of(d);
    cudaError_t result = cudaMalloc(&block, bytes);
    if (result == cudaSuccess) {
        keep(d, cudaMemsetAsync(block, 0, bytes, stream), label);
        return block;
    }
    cudaGetLastError();
    if (result != cudaErrorMemoryAllocation) {
        keep(d, result, label);
        report(d, e);
        return NULL;
    }
    cudaMemGetInfo(&available, &all);
    error_set(e, STATUS_RUN, "%s take %.4g GB of the GPU's memory, of which %.4g GB are free (%s): use a "
              "larger particles.spacing or --backend cpu", label, 1e-9 * (double)bytes,
              1e-9 * (double)available, cudaGetErrorString(result));
    return NULL;
}

static void cuda_destroy(struct device *d, void *block)
{
    stream_of(d);
    cudaFree(block);
}

static void *cuda_pin(struct device *d, size_t bytes, struct error *e)
{
    void *block = NULL;
    stream_of(d);
    cudaError_t result = cudaMallocHost(&block, bytes ? bytes : 1);
    if (result == cudaSuccess) {
        memset(block, 0, bytes);
        return block;
    }
    cudaGetLastError();
    error_set(e, STATUS_RUN, "%.4g GB of memory that the GPU can copy to cannot be had: %s",
              1e-9 * (double)bytes, cudaGetErrorString(result));
    return NULL;
}

static void cuda_unpin(struct device *d, void *block)
{
    stream_of(d);
    cudaFreeHost(block);
}

static void cuda_upload(struct device *d, void *to, const void *host, size_t bytes)
{
    if (bytes > 0)
        keep(d, cudaMemcpyAsync(to, host, bytes, cudaMemcpyHostToDevice, stream_of(d)), d->last);
}

static void cuda_copy(struct device *d, void *to, const void *from, size_t bytes)
{
    if (bytes > 0)
        keep(d, cudaMemcpyAsync(to, from, bytes, cudaMemcpyDeviceToDevice, stream_of(d)), d->last);
}

static void cuda_clear(struct device *d, void *to, size_t bytes)
{
    if (bytes > 0)
        keep(d, cudaMemsetAsync(to, 0, bytes, stream_of(d)), d->last);
}

static enum status cuda_wait(struct device *d, struct error *e)
{
    keep(d, cudaStreamSynchronize(stream_of(d)), d->last);
    return report(d, e);
}

static enum status cuda_read(struct device *d, void *host, const void *from, size_t bytes,
                             struct error *e)
{
    if (bytes > 0)
        keep(d, cudaMemcpyAsync(host, from, bytes, cudaMemcpyDeviceToHost, stream_of(d)), d->last);
    return cuda_wait(d, e);
}

static void cuda_launch(struct device *d, const struct kernel *kernel, size_t threads,
                        const void *args)
{
    if (threads == 0)
        return;
    d->last = kernel->name;
    kernel->run(threads, args, stream_of(d));
    keep(d, cudaGetLastError(), kernel->name);
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
                                           s->sorted_values, s->count, 0, s->bits, stream);
}

static enum status cuda_sort(struct device *d, const struct device_sort *s, struct error *e)
{
    size_t bytes = 0;
    keep(d, sort_pairs(NULL, &bytes, s, stream_of(d)), "sort");
    if (!reserve(d, bytes, e))
        return e->status;
    d->last = "sort";
    keep(d, sort_pairs(d->scratch, &bytes, s, stream_of(d)), "sort");
    return report(d, e);
}

/* In place: the sum of `count` values arrives behind them. */
static enum status cuda_scan(struct device *d, uint32_t *values, size_t count, struct error *e)
{
    size_t bytes = 0, all = count + 1;
    keep(d, cub::DeviceScan::ExclusiveSum(NULL, bytes, values, values, all, stream_of(d)), "scan");
    if (!reserve(d, bytes, e))
        return e->status;
    d->last = "scan";
    keep(d, cub::DeviceScan::ExclusiveSum(d->scratch, bytes, values, values, all, stream_of(d)), "scan");
    return report(d, e);
}

static bool cuda_record(struct device *d)
{
    d->before = d->failure;
    bool ok = cudaStreamBeginCapture(stream_of(d), cudaStreamCaptureModeRelaxed) == cudaSuccess;
    cudaGetLastError();
    return ok;
}

/* What fails within a recording has not been run, and will be without it. */
static struct device_graph *cuda_recorded(struct device *d)
{
    struct device_graph *g = (struct device_graph *)calloc(1, sizeof *g);
    cudaGraph_t graph = NULL;
    bool ok = cudaStreamEndCapture(stream_of(d), &graph) == cudaSuccess && g &&
              d->failure == d->before && cudaGraphInstantiate(&g->exec, graph, 0) == cudaSuccess;
    if (graph)
        cudaGraphDestroy(graph);
    if (ok)
        return g;
    cudaGetLastError();
    d->failure = d->before;
    free(g);
    return NULL;
}

static void cuda_replay(struct device *d, struct device_graph *graph)
{
    keep(d, cudaGraphLaunch(graph->exec, stream_of(d)), "a graph");
    d->last = "a graph of passes";
}

static void cuda_forget(struct device *d, struct device_graph *graph)
{
    cudaStreamSynchronize(stream_of(d));
    cudaGraphExecDestroy(graph->exec);
    free(graph);
}

static struct device_event *cuda_event(struct device *d, struct error *e)
{
    struct device_event *event = (struct device_event *)calloc(1, sizeof *event);
    stream_of(d);
    cudaError_t result = event ? cudaEventCreateWithFlags(&event->event, cudaEventDisableTiming)
                               : cudaErrorMemoryAllocation;
    if (result == cudaSuccess)
        return event;
    cudaGetLastError();
    free(event);
    error_set(e, STATUS_RUN, "the GPU has no event to wait for: %s", cudaGetErrorString(result));
    return NULL;
}

static void cuda_drop(struct device *d, struct device_event *event)
{
    if (!event)
        return;
    stream_of(d);
    cudaEventDestroy(event->event);
    free(event);
}

/* What is recorded waits for nothing outside its graph, and nothing outside waits for it. */
static cudaError_t not_recording(cudaStream_t stream)
{
    cudaStreamCaptureStatus capture = cudaStreamCaptureStatusNone;
    cudaError_t result = cudaStreamIsCapturing(stream, &capture);
    return capture == cudaStreamCaptureStatusNone ? result : cudaErrorStreamCaptureUnsupported;
}

static void cuda_signal(struct device *d, struct device_event *event)
{
    cudaStream_t stream = stream_of(d);
    cudaError_t result = not_recording(stream);
    keep(d, result == cudaSuccess ? cudaEventRecord(event->event, stream) : result, "an event");
}

static void cuda_follow(struct device *d, struct device_event *event)
{
    cudaStream_t stream = stream_of(d);
    cudaError_t result = not_recording(stream);
    keep(d, result == cudaSuccess ? cudaStreamWaitEvent(stream, event->event, 0) : result, "an event");
}

#if HAVE_EGL

/* Some drivers register what they cannot map. */
static cudaError_t try_map(struct device *d, cudaGraphicsResource_t *resource)
{
    cudaError_t result = cudaGraphicsMapResources(1, resource, stream_of(d));
    if (result == cudaSuccess)
        result = cudaGraphicsUnmapResources(1, resource, stream_of(d));
    if (result != cudaSuccess)
        cudaGraphicsUnregisterResource(*resource);
    return result;
}

static struct device_buffer *cuda_attach(struct device *d, const struct device_gl *gl, struct error *e)
{
    struct device_buffer *buffer = (struct device_buffer *)calloc(1, sizeof *buffer);
    if (!buffer) {
        error_set(e, STATUS_RUN, "out of memory");
        return NULL;
    }
    buffer->bytes = gl->bytes;
    stream_of(d);
    cudaError_t result = cudaGraphicsGLRegisterBuffer(&buffer->resource, gl->name,
                                                      cudaGraphicsRegisterFlagsWriteDiscard);
    if (result == cudaSuccess)
        result = try_map(d, &buffer->resource);
    if (result == cudaSuccess)
        return buffer;
    cudaGetLastError();
    free(buffer);
    error_set(e, STATUS_BACKEND, "cuda:%d cannot write to OpenGL's buffer %u: %s (%s)", d->index, gl->name,
              cudaGetErrorString(result), cudaGetErrorName(result));
    return NULL;
}

#else

static struct device_buffer *cuda_attach(struct device *d, const struct device_gl *gl, struct error *e)
{
    error_set(e, STATUS_BACKEND, "cuda:%d cannot write to OpenGL's buffer %u: not in this build; build with "
              "make EGL=1", d->index, gl->name);
    return NULL;
}

#endif

static void cuda_detach(struct device *d, struct device_buffer *buffer)
{
    if (!buffer)
        return;
    stream_of(d);
    keep(d, cudaGraphicsUnregisterResource(buffer->resource), "giving OpenGL's buffer back");
    free(buffer);
}

static enum status cuda_unmap(struct device *d, struct device_buffer *buffer, struct error *e)
{
    keep(d, cudaGraphicsUnmapResources(1, &buffer->resource, stream_of(d)), "giving OpenGL's buffer back");
    return report(d, e);
}

static void *cuda_map(struct device *d, struct device_buffer *buffer, struct error *e)
{
    static const char what[] = "taking OpenGL's buffer";
    void *block = NULL;
    size_t bytes = 0;
    struct error ignored;
    if (!keep(d, cudaGraphicsMapResources(1, &buffer->resource, stream_of(d)), what)) {
        report(d, e);
        return NULL;
    }
    if (keep(d, cudaGraphicsResourceGetMappedPointer(&block, &bytes, buffer->resource), what) &&
        bytes < buffer->bytes)
        error_set(e, STATUS_RUN, "OpenGL's buffer has %zu bytes for CUDA, not %zu", bytes, buffer->bytes);
    else if (report(d, e) == STATUS_OK)
        return block;
    cuda_unmap(d, buffer, &ignored);
    return NULL;
}

enum { PEAK_ROUNDS = 4096, PEAK_CHAINS = 8, PEAK_THREADS = 256 };

__global__ void multiply_adds(float *out, float a, float b)
{
    float c[PEAK_CHAINS];
    for (int k = 0; k < PEAK_CHAINS; k++)
        c[k] = (float)(threadIdx.x + k);
    for (int r = 0; r < PEAK_ROUNDS; r++)
        for (int k = 0; k < PEAK_CHAINS; k++)
            c[k] = fmaf(c[k], a, b);
    float sum = 0;
    for (int k = 0; k < PEAK_CHAINS; k++)
        sum += c[k];
    if (sum == 12345.0f)
        *out = sum;
}

/* The shortest of some runs, s; `run` queues one. */
static double shortest(struct device *d, void (*run)(struct device *d, void *context), void *context)
{
    float ms = 0, best = 0;
    cudaEvent_t first, last;
    cudaEventCreate(&first);
    cudaEventCreate(&last);
    for (int trial = 0; trial < 6; trial++) { /* the first warms up */
        cudaEventRecord(first, stream_of(d));
        run(d, context);
        cudaEventRecord(last, stream_of(d));
        cudaEventSynchronize(last);
        cudaEventElapsedTime(&ms, first, last);
        best = trial < 2 || ms < best ? ms : best;
    }
    cudaEventDestroy(first);
    cudaEventDestroy(last);
    return cudaGetLastError() == cudaSuccess && best > 0 ? 1e-3 * (double)best : 0;
}

static int peak_blocks(void)
{
    int index = 0, processors = 1;
    cudaGetDevice(&index);
    cudaDeviceGetAttribute(&processors, cudaDevAttrMultiProcessorCount, index);
    return 32 * processors;
}

static void run_multiply_adds(struct device *d, void *out)
{
    launch(multiply_adds, (unsigned)peak_blocks(), PEAK_THREADS, stream_of(d), (float *)out, 0.999f, 1e-3f);
}

static double cuda_peak(struct device *d)
{
    const double flops = 2.0 * (double)PEAK_ROUNDS * (double)PEAK_CHAINS * (double)PEAK_THREADS;
    void *out = NULL;
    stream_of(d);
    if (cudaMalloc(&out, sizeof(float)) != cudaSuccess) {
        cudaGetLastError();
        return 0;
    }
    double seconds = shortest(d, run_multiply_adds, out);
    cudaFree(out);
    return seconds > 0 ? flops * peak_blocks() / seconds : 0;
}

static const size_t COPY_BYTES = (size_t)256 << 20;

static void run_copy(struct device *d, void *block)
{
    cudaMemcpyAsync((char *)block + COPY_BYTES, block, COPY_BYTES, cudaMemcpyDeviceToDevice, stream_of(d));
}

static double cuda_bandwidth(struct device *d)
{
    void *block = NULL;
    stream_of(d);
    if (cudaMalloc(&block, 2 * COPY_BYTES) != cudaSuccess) {
        cudaGetLastError();
        return 0;
    }
    double seconds = shortest(d, run_copy, block);
    cudaFree(block);
    return seconds > 0 ? 2.0 * (double)COPY_BYTES / seconds : 0;
}

extern "C" const struct device_row device_cuda = {
    .count = cuda_count,
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
