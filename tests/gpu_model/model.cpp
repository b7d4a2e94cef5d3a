/* The model of a GPU: fibers that meet, and streams that wait (see cuda_runtime.h). */
#include "cuda_gl_interop.h"
#include "cuda_runtime.h"
#include "gpu_model.h"

#include <deque>
#include <dlfcn.h>
#include <map>
#include <memory>
#include <mutex>
#include <setjmp.h>
#include <ucontext.h>
#include <vector>

dim3 threadIdx, blockIdx, blockDim, gridDim;

static std::recursive_mutex model; /* the whole GPU's: one thread of the host uses it at a time */
static enum gpu_model_order order_wanted = GPU_MODEL_FORWARD;
static struct gpu_model_counts counts;
static bool in_graph;
#define LOCK std::lock_guard<std::recursive_mutex> lock(model)

[[noreturn]] static void model_fail(const char *what)
{
    fprintf(stderr, "# model of a GPU: block %u, thread %u: %s\n", blockIdx.x, threadIdx.x, what);
    abort();
}

/* Fibers */

enum { STACK = 128 << 10, LANES = 32 };
enum fiber_state { READY, AT_WARP, AT_BLOCK, ENDED };

/* Made once, and used for thread after thread; jumps need no call of the kernel, as ucontext's switches do. */
struct fiber {
    ucontext_t context; /* of its first time */
    std::unique_ptr<char[]> stack;
    jmp_buf place;      /* where it left */
    fiber_state state;
    unsigned meetings;  /* of its warp */
    uint64_t value[2];  /* that it brought to the last two */
};

static fiber fibers[1024];
static size_t fiber_count;
static jmp_buf scheduler;
static const std::function<void()> *body;

static void fiber_leave(fiber_state state)
{
    const dim3 own = threadIdx;
    fibers[own.x].state = state;
    if (_setjmp(fibers[own.x].place) == 0)
        _longjmp(scheduler, 1);
    threadIdx = own;
}

static void fiber_main()
{
    for (;;) {
        (*body)();
        fiber_leave(ENDED);
    }
}

static void fiber_enter(fiber *f)
{
    if (_setjmp(scheduler) != 0)
        return;
    if (f->stack)
        _longjmp(f->place, 1);
    f->stack.reset(new char[STACK]);
    getcontext(&f->context);
    f->context.uc_stack.ss_sp = f->stack.get();
    f->context.uc_stack.ss_size = STACK;
    f->context.uc_link = NULL;
    makecontext(&f->context, fiber_main, 0);
    setcontext(&f->context);
}

void model_block_meet()
{
    counts.blocks++;
    fiber_leave(AT_BLOCK);
}

void model_warp_exchange(unsigned mask, const void *own, size_t bytes, uint64_t all[LANES])
{
    const size_t first = threadIdx.x / LANES * LANES;
    fiber *f = &fibers[threadIdx.x];
    const unsigned turn = f->meetings++ % 2;
    if (mask != ~0u || first + LANES > fiber_count)
        model_fail("a warp meets, but not all of its lanes are asked");
    counts.warps++;
    f->value[turn] = 0;
    memcpy(&f->value[turn], own, bytes);
    fiber_leave(AT_WARP);
    for (size_t lane = 0; lane < LANES; lane++)
        all[lane] = fibers[first + lane].value[turn];
}

/* Lets go the fibers first .. end - 1 when all that are not ended have come to the same meeting. */
static bool release(size_t first, size_t end, fiber_state meeting)
{
    size_t there = 0, ended = 0;
    for (size_t k = first; k < end; k++) {
        there += fibers[k].state == meeting;
        ended += fibers[k].state == ENDED;
    }
    if (there == 0 || there + ended < end - first)
        return false;
    if (ended)
        model_fail("threads meet that others of the same warp or block have missed");
    for (size_t k = first; k < end; k++)
        fibers[k].state = READY;
    return true;
}

/* Numbers 0 .. count - 1 in the order that is wanted. */
static std::vector<unsigned> order_of(unsigned count)
{
    static uint64_t random = 1;
    std::vector<unsigned> order(count);
    for (unsigned k = 0; k < count; k++)
        order[k] = order_wanted == GPU_MODEL_BACKWARD ? count - 1 - k : k;
    for (unsigned k = count; order_wanted == GPU_MODEL_SHUFFLED && k > 1; k--) {
        random = random * 6364136223846793005u + 1442695040888963407u;
        std::swap(order[k - 1], order[(random >> 33) % k]);
    }
    return order;
}

/* Runs the threads first .. end - 1 of a warp until each has ended or waits for the block. */
static bool warp_run(size_t first, size_t end)
{
    const std::vector<unsigned> order = order_of((unsigned)(end - first));
    bool any = false, going = true;
    while (going) {
        going = false;
        for (unsigned k : order)
            if (fibers[first + k].state == READY) {
                going = any = true;
                threadIdx = dim3((unsigned)first + k, 0, 0);
                fiber_enter(&fibers[first + k]);
            }
        going = release(first, end, AT_WARP) || going;
    }
    return any;
}

/* One warp after the other, each as far as it gets: nothing but what the code asks for keeps them together. */
static void block_run(unsigned threads)
{
    const std::vector<unsigned> order = order_of((threads + LANES - 1) / LANES);
    bool going = true;
    for (size_t k = 0; k < threads; k++) {
        fibers[k].state = READY;
        fibers[k].meetings = 0;
    }
    while (going) {
        going = false;
        for (unsigned warp : order) {
            const size_t first = (size_t)warp * LANES;
            going = warp_run(first, first + LANES < threads ? first + LANES : threads) || going;
        }
        going = release(0, threads, AT_BLOCK) || going;
    }
    for (size_t k = 0; k < threads; k++)
        if (fibers[k].state != ENDED)
            model_fail("threads wait for each other for ever");
}

void model_launch(dim3 grid, dim3 block, const std::function<void()> &thread)
{
    LOCK;
    counts.kernels++;
    counts.in_graphs += in_graph;
    fiber_count = block.x;
    body = &thread;
    gridDim = grid;
    blockDim = block;
    for (unsigned b : order_of(grid.x)) {
        blockIdx = dim3(b, 0, 0);
        block_run(block.x);
    }
}

/* Streams, events, graphs */

struct model_stream {
    std::deque<std::function<void()>> queue;
    model_graph *capture; /* or NULL */
};
struct model_event {
    model_stream *by;
    long asked, done;
};
struct model_graph {
    std::vector<std::function<void()>> nodes;
    int owners; /* of the graph and of its executable */
};

static std::vector<model_stream *> streams;
static cudaError_t last_error;

static cudaError_t failed(cudaError_t error)
{
    last_error = error;
    return error;
}

cudaError_t model_queue(cudaStream_t stream, std::function<void()> what)
{
    LOCK;
    if (stream->capture)
        stream->capture->nodes.push_back(what);
    else
        stream->queue.push_back(what);
    return cudaSuccess;
}

static void stream_step(model_stream *s)
{
    std::function<void()> what = s->queue.front();
    s->queue.pop_front();
    what();
}

cudaError_t cudaStreamSynchronize(cudaStream_t s)
{
    LOCK;
    if (s->capture)
        return failed(cudaErrorStreamCaptureUnsupported);
    while (!s->queue.empty())
        stream_step(s);
    return cudaSuccess;
}

static void device_synchronize()
{
    for (model_stream *s : streams)
        while (!s->queue.empty())
            stream_step(s);
}

cudaError_t cudaStreamCreateWithFlags(cudaStream_t *s, unsigned)
{
    LOCK;
    *s = new model_stream();
    streams.push_back(*s);
    return cudaSuccess;
}

cudaError_t cudaStreamDestroy(cudaStream_t s)
{
    LOCK;
    cudaStreamSynchronize(s);
    for (size_t k = 0; k < streams.size(); k++)
        if (streams[k] == s)
            streams.erase(streams.begin() + (long)k--);
    delete s;
    return cudaSuccess;
}

cudaError_t cudaEventCreateWithFlags(cudaEvent_t *event, unsigned)
{
    *event = new model_event();
    return cudaSuccess;
}

cudaError_t cudaEventCreate(cudaEvent_t *event)
{
    return cudaEventCreateWithFlags(event, 0);
}

cudaError_t cudaEventDestroy(cudaEvent_t event)
{
    LOCK;
    device_synchronize();
    delete event;
    return cudaSuccess;
}

cudaError_t cudaEventRecord(cudaEvent_t event, cudaStream_t stream)
{
    LOCK;
    const long asked = ++event->asked;
    event->by = stream;
    return model_queue(stream, [=] { event->done = asked; });
}

static void event_reach(model_event *event, long asked)
{
    while (event->done < asked)
        stream_step(event->by);
}

cudaError_t cudaStreamWaitEvent(cudaStream_t stream, cudaEvent_t event, unsigned)
{
    LOCK;
    const long asked = event->asked;
    return model_queue(stream, [=] { event_reach(event, asked); });
}

cudaError_t cudaEventSynchronize(cudaEvent_t event)
{
    LOCK;
    event_reach(event, event->asked);
    return cudaSuccess;
}

cudaError_t cudaEventElapsedTime(float *ms, cudaEvent_t, cudaEvent_t)
{
    *ms = 1;
    return cudaSuccess;
}

cudaError_t cudaStreamBeginCapture(cudaStream_t s, cudaStreamCaptureMode)
{
    LOCK;
    if (s->capture)
        return failed(cudaErrorStreamCaptureUnsupported);
    s->capture = new model_graph();
    s->capture->owners = 1;
    return cudaSuccess;
}

cudaError_t cudaStreamEndCapture(cudaStream_t s, cudaGraph_t *graph)
{
    LOCK;
    *graph = s->capture;
    s->capture = NULL;
    return *graph ? cudaSuccess : failed(cudaErrorInvalidValue);
}

cudaError_t cudaStreamIsCapturing(cudaStream_t s, cudaStreamCaptureStatus *status)
{
    *status = s->capture ? cudaStreamCaptureStatusActive : cudaStreamCaptureStatusNone;
    return cudaSuccess;
}

cudaError_t cudaGraphInstantiate(cudaGraphExec_t *exec, cudaGraph_t graph, unsigned long long)
{
    graph->owners++;
    *exec = graph;
    return cudaSuccess;
}

cudaError_t cudaGraphDestroy(cudaGraph_t graph)
{
    LOCK;
    if (--graph->owners == 0)
        delete graph;
    return cudaSuccess;
}

cudaError_t cudaGraphExecDestroy(cudaGraphExec_t exec)
{
    return cudaGraphDestroy(exec);
}

static void graph_run(const model_graph *graph)
{
    in_graph = true;
    for (const std::function<void()> &node : graph->nodes)
        node();
    in_graph = false;
}

cudaError_t cudaGraphLaunch(cudaGraphExec_t exec, cudaStream_t stream)
{
    return model_queue(stream, [=] { graph_run(exec); });
}

/* Memory */

static std::map<void *, size_t> on_device, pinned;

static bool lies_in(const std::map<void *, size_t> &blocks, const void *address, size_t bytes)
{
    auto after = blocks.upper_bound(const_cast<void *>(address));
    if (after == blocks.begin())
        return false;
    const auto &block = *--after;
    return (const char *)address + bytes <= (const char *)block.first + block.second;
}

static cudaError_t allocate(std::map<void *, size_t> *blocks, void **block, size_t bytes)
{
    LOCK;
    *block = aligned_alloc(256, (bytes + 255) / 256 * 256);
    if (!*block)
        return failed(cudaErrorMemoryAllocation);
    memset(*block, 0xa5, bytes);
    (*blocks)[*block] = bytes;
    return cudaSuccess;
}

static cudaError_t release_block(std::map<void *, size_t> *blocks, void *block)
{
    LOCK;
    if (!block)
        return cudaSuccess;
    device_synchronize();
    if (!blocks->count(block))
        return failed(cudaErrorInvalidValue);
    memset(block, 0x5a, (*blocks)[block]);
    blocks->erase(block);
    free(block);
    return cudaSuccess;
}

cudaError_t cudaMalloc(void **block, size_t bytes)
{
    return allocate(&on_device, block, bytes);
}
cudaError_t cudaFree(void *block)
{
    return release_block(&on_device, block);
}
cudaError_t cudaMallocHost(void **block, size_t bytes)
{
    return allocate(&pinned, block, bytes);
}
cudaError_t cudaFreeHost(void *block)
{
    return release_block(&pinned, block);
}

static cudaError_t memory_check(const void *block, size_t bytes)
{
    return lies_in(on_device, block, bytes) ? cudaSuccess : failed(cudaErrorInvalidValue);
}

cudaError_t cudaMemsetAsync(void *to, int value, size_t bytes, cudaStream_t stream)
{
    LOCK;
    if (memory_check(to, bytes))
        return last_error;
    return model_queue(stream, [=] { memset(to, value, bytes); });
}

/* Memory that is not pinned is read before the call returns, and written before it returns. */
cudaError_t cudaMemcpyAsync(void *to, const void *from, size_t bytes, cudaMemcpyKind kind, cudaStream_t stream)
{
    LOCK;
    if ((kind != cudaMemcpyDeviceToHost && memory_check(to, bytes)) ||
        (kind != cudaMemcpyHostToDevice && memory_check(from, bytes)))
        return last_error;
    if (kind == cudaMemcpyHostToDevice && !lies_in(pinned, from, bytes)) {
        auto copy = std::make_shared<std::vector<char>>((const char *)from, (const char *)from + bytes);
        return model_queue(stream, [=] { memcpy(to, copy->data(), bytes); });
    }
    model_queue(stream, [=] { memcpy(to, from, bytes); });
    if (kind == cudaMemcpyDeviceToHost && !lies_in(pinned, to, bytes))
        return cudaStreamSynchronize(stream);
    return cudaSuccess;
}

/* What there is */

const char *cudaGetErrorString(cudaError_t error)
{
    static const char *const words[] = {"no error", "invalid argument", "out of memory",
                                        "operation not permitted when stream is capturing",
                                        "operation not supported"};
    return words[error];
}
const char *cudaGetErrorName(cudaError_t error)
{
    return cudaGetErrorString(error);
}
cudaError_t cudaGetLastError()
{
    cudaError_t error = last_error;
    last_error = cudaSuccess;
    return error;
}
cudaError_t cudaGetDeviceCount(int *count)
{
    *count = 1;
    return cudaSuccess;
}
cudaError_t cudaGetDevice(int *index)
{
    *index = 0;
    return cudaSuccess;
}
cudaError_t cudaSetDevice(int index)
{
    return index == 0 ? cudaSuccess : failed(cudaErrorInvalidValue);
}
cudaError_t cudaGetDeviceProperties(cudaDeviceProp *properties, int)
{
    *properties = cudaDeviceProp();
    strcpy(properties->name, "a model of a GPU");
    properties->major = 9;
    return cudaSuccess;
}
cudaError_t cudaDeviceGetAttribute(int *value, cudaDeviceAttr, int)
{
    *value = 1;
    return cudaSuccess;
}
cudaError_t cudaMemGetInfo(size_t *available, size_t *all)
{
    *available = *all = (size_t)1 << 40;
    return cudaSuccess;
}
cudaError_t cudaDriverGetVersion(int *version)
{
    *version = 13000;
    return cudaSuccess;
}
cudaError_t cudaRuntimeGetVersion(int *version)
{
    return cudaDriverGetVersion(version);
}

/* Buffers of OpenGL */

struct cudaGraphicsResource {
    unsigned buffer;
    void *mapped;
    size_t bytes;
};

enum { GL_COPY_WRITE_BUFFER = 0x8F37, GL_BUFFER_SIZE = 0x8764, GL_MAP_WRITE_BIT = 2, GL_MAP_INVALIDATE = 8 };

/* A function of the context that EGL has made current; NULL: there is none. */
template <typename F> static F *gl_function(const char *name)
{
    void *library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!library)
        return NULL;
    auto context = (void *(*)())dlsym(library, "eglGetCurrentContext");
    auto find = (void *(*)(const char *))dlsym(library, "eglGetProcAddress");
    return context() ? (F *)find(name) : NULL;
}

cudaError_t cudaGraphicsGLRegisterBuffer(cudaGraphicsResource_t *resource, unsigned buffer, unsigned)
{
    if (!gl_function<void(unsigned, unsigned)>("glBindBuffer"))
        return failed(cudaErrorNotSupported);
    *resource = new cudaGraphicsResource();
    (*resource)->buffer = buffer;
    return cudaSuccess;
}

cudaError_t cudaGraphicsUnregisterResource(cudaGraphicsResource_t resource)
{
    delete resource;
    return cudaSuccess;
}

cudaError_t cudaGraphicsMapResources(int, cudaGraphicsResource_t *resource, cudaStream_t)
{
    LOCK;
    auto bind = gl_function<void(unsigned, unsigned)>("glBindBuffer");
    auto size = gl_function<void(unsigned, unsigned, int64_t *)>("glGetBufferParameteri64v");
    auto map = gl_function<void *(unsigned, intptr_t, intptr_t, unsigned)>("glMapBufferRange");
    int64_t bytes = 0;
    if (!bind || (*resource)->mapped)
        return failed(cudaErrorInvalidValue);
    bind(GL_COPY_WRITE_BUFFER, (*resource)->buffer);
    size(GL_COPY_WRITE_BUFFER, GL_BUFFER_SIZE, &bytes);
    (*resource)->bytes = (size_t)bytes;
    (*resource)->mapped = map(GL_COPY_WRITE_BUFFER, 0, bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE);
    return (*resource)->mapped ? cudaSuccess : failed(cudaErrorInvalidValue);
}

/* OpenGL does not wait for streams here: they are run first. */
cudaError_t cudaGraphicsUnmapResources(int, cudaGraphicsResource_t *resource, cudaStream_t stream)
{
    LOCK;
    auto bind = gl_function<void(unsigned, unsigned)>("glBindBuffer");
    auto unmap = gl_function<unsigned char(unsigned)>("glUnmapBuffer");
    if (!bind || !(*resource)->mapped || cudaStreamSynchronize(stream))
        return failed(cudaErrorInvalidValue);
    bind(GL_COPY_WRITE_BUFFER, (*resource)->buffer);
    (*resource)->mapped = NULL;
    return unmap(GL_COPY_WRITE_BUFFER) ? cudaSuccess : failed(cudaErrorInvalidValue);
}

cudaError_t cudaGraphicsResourceGetMappedPointer(void **pointer, size_t *bytes, cudaGraphicsResource_t resource)
{
    *pointer = resource->mapped;
    *bytes = resource->bytes;
    return *pointer ? cudaSuccess : failed(cudaErrorInvalidValue);
}

/* For tests */

extern "C" void gpu_model_order(enum gpu_model_order order)
{
    order_wanted = order;
}

extern "C" struct gpu_model_counts gpu_model_counts(void)
{
    LOCK;
    counts.device_bytes = 0;
    for (const auto &block : on_device)
        counts.device_bytes += block.second;
    return counts;
}
