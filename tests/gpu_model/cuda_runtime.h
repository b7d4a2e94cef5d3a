/* A model of a GPU for tests: what the .cu files use of CUDA, in C++ on the host, so that they run where there is no
 * GPU. Threads of a block are fibers, which meet where warps and blocks do; blocks and fibers come in an order
 * that tests choose. Streams do nothing until somebody waits for them. Device memory begins as garbage. */
#ifndef GPU_MODEL_CUDA_RUNTIME_H
#define GPU_MODEL_CUDA_RUNTIME_H

#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <tuple>
#include <utility>

#define __global__ static
#define __device__
#define __shared__ static
#define __launch_bounds__(...)
#define __grid_constant__

struct dim3 {
    unsigned x, y, z;
    dim3(unsigned x = 1, unsigned y = 1, unsigned z = 1) : x(x), y(y), z(z) {}
};
struct alignas(16) float4 {
    float x, y, z, w;
};
struct alignas(16) uint4 {
    unsigned x, y, z, w;
};
extern dim3 threadIdx, blockIdx, blockDim, gridDim; /* of the fiber that runs */

/* Meetings. Every thread of the warp, or of the block, has to come. */
void model_warp_exchange(unsigned mask, const void *own, size_t bytes, uint64_t all[32]);
void model_block_meet();

static inline void __syncthreads()
{
    model_block_meet();
}
template <typename T> static inline T model_of_lane(unsigned mask, T own, unsigned lane)
{
    uint64_t all[32];
    T value;
    static_assert(sizeof(T) <= sizeof all[0], "a lane's value fits");
    model_warp_exchange(mask, &own, sizeof own, all);
    memcpy(&value, &all[lane % 32], sizeof value);
    return value;
}
template <typename T> static inline T __shfl_sync(unsigned mask, T own, int lane)
{
    return model_of_lane(mask, own, (unsigned)lane);
}
template <typename T> static inline T __shfl_xor_sync(unsigned mask, T own, int step)
{
    return model_of_lane(mask, own, (threadIdx.x % 32) ^ (unsigned)step);
}
static inline unsigned __ballot_sync(unsigned mask, bool own)
{
    uint64_t all[32];
    unsigned bits = 0, bit = own;
    model_warp_exchange(mask, &bit, sizeof bit, all);
    for (int lane = 0; lane < 32; lane++)
        bits |= (unsigned)(all[lane] & 1) << lane;
    return bits;
}

static inline int __popc(unsigned x)
{
    return __builtin_popcount(x);
}
static inline int __ffs(int x)
{
    return __builtin_ffs(x);
}
static inline int __float_as_int(float x)
{
    int bits;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}
static inline unsigned __float_as_uint(float x)
{
    return (unsigned)__float_as_int(x);
}
static inline float __uint_as_float(unsigned bits)
{
    float x;
    memcpy(&x, &bits, sizeof x);
    return x;
}
template <typename T> static inline T min(T a, T b)
{
    return b < a ? b : a;
}
template <typename T> static inline T atomicAdd(T *at, T x)
{
    return __atomic_fetch_add(at, x, __ATOMIC_RELAXED);
}
template <typename T> static inline T atomicMin(T *at, T x)
{
    T old = __atomic_load_n(at, __ATOMIC_RELAXED);
    while (x < old && !__atomic_compare_exchange_n(at, &old, x, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
    }
    return old;
}
template <typename T> static inline T atomicMax(T *at, T x)
{
    T old = __atomic_load_n(at, __ATOMIC_RELAXED);
    while (x > old && !__atomic_compare_exchange_n(at, &old, x, false, __ATOMIC_RELAXED, __ATOMIC_RELAXED)) {
    }
    return old;
}

/* The runtime. */
enum cudaError_t {
    cudaSuccess,
    cudaErrorInvalidValue,
    cudaErrorMemoryAllocation,
    cudaErrorStreamCaptureUnsupported,
    cudaErrorNotSupported,
    cudaErrorLaunchFailure,
    cudaErrorInsufficientDriver
};
const char *cudaGetErrorString(cudaError_t);
const char *cudaGetErrorName(cudaError_t);
cudaError_t cudaGetLastError();

typedef struct model_stream *cudaStream_t;
typedef struct model_event *cudaEvent_t;
typedef struct model_graph *cudaGraph_t;
typedef struct model_graph *cudaGraphExec_t;
struct cudaDeviceProp {
    char name[256];
    int major, minor;
};
struct cudaFuncAttributes {
    int numRegs;
};
enum { cudaStreamNonBlocking = 1, cudaEventDisableTiming = 2 };
enum cudaStreamCaptureMode { cudaStreamCaptureModeRelaxed };
enum cudaStreamCaptureStatus { cudaStreamCaptureStatusNone, cudaStreamCaptureStatusActive };
enum cudaMemcpyKind { cudaMemcpyHostToDevice, cudaMemcpyDeviceToHost, cudaMemcpyDeviceToDevice };
enum cudaDeviceAttr { cudaDevAttrMultiProcessorCount };

cudaError_t cudaGetDeviceCount(int *);
cudaError_t cudaGetDevice(int *);
cudaError_t cudaSetDevice(int);
cudaError_t cudaGetDeviceProperties(cudaDeviceProp *, int);
cudaError_t cudaDeviceGetAttribute(int *, cudaDeviceAttr, int);
cudaError_t cudaMemGetInfo(size_t *, size_t *);
cudaError_t cudaDriverGetVersion(int *);
cudaError_t cudaRuntimeGetVersion(int *);
cudaError_t cudaMalloc(void **, size_t);
cudaError_t cudaFree(void *);
cudaError_t cudaMallocHost(void **, size_t);
cudaError_t cudaFreeHost(void *);
cudaError_t cudaMemcpyAsync(void *, const void *, size_t, cudaMemcpyKind, cudaStream_t);
cudaError_t cudaMemsetAsync(void *, int, size_t, cudaStream_t);
cudaError_t cudaStreamCreateWithFlags(cudaStream_t *, unsigned);
cudaError_t cudaStreamDestroy(cudaStream_t);
cudaError_t cudaStreamSynchronize(cudaStream_t);
cudaError_t cudaStreamWaitEvent(cudaStream_t, cudaEvent_t, unsigned = 0);
cudaError_t cudaStreamBeginCapture(cudaStream_t, cudaStreamCaptureMode);
cudaError_t cudaStreamEndCapture(cudaStream_t, cudaGraph_t *);
cudaError_t cudaStreamIsCapturing(cudaStream_t, cudaStreamCaptureStatus *);
cudaError_t cudaEventCreate(cudaEvent_t *);
cudaError_t cudaEventCreateWithFlags(cudaEvent_t *, unsigned);
cudaError_t cudaEventDestroy(cudaEvent_t);
cudaError_t cudaEventRecord(cudaEvent_t, cudaStream_t);
cudaError_t cudaEventSynchronize(cudaEvent_t);
cudaError_t cudaEventElapsedTime(float *, cudaEvent_t, cudaEvent_t);
cudaError_t cudaGraphInstantiate(cudaGraphExec_t *, cudaGraph_t, unsigned long long);
cudaError_t cudaGraphLaunch(cudaGraphExec_t, cudaStream_t);
cudaError_t cudaGraphDestroy(cudaGraph_t);
cudaError_t cudaGraphExecDestroy(cudaGraphExec_t);
template <typename K> cudaError_t cudaFuncGetAttributes(cudaFuncAttributes *, K *)
{
    return cudaSuccess;
}

typedef struct cudaGraphicsResource *cudaGraphicsResource_t;
enum { cudaGraphicsRegisterFlagsWriteDiscard = 2 };
cudaError_t cudaGraphicsUnregisterResource(cudaGraphicsResource_t);
cudaError_t cudaGraphicsMapResources(int, cudaGraphicsResource_t *, cudaStream_t = 0);
cudaError_t cudaGraphicsUnmapResources(int, cudaGraphicsResource_t *, cudaStream_t = 0);
cudaError_t cudaGraphicsResourceGetMappedPointer(void **, size_t *, cudaGraphicsResource_t);

/* Queues what a stream does; keeps it while the stream captures. */
cudaError_t model_queue(cudaStream_t stream, std::function<void()> what);
/* Runs a kernel's threads, `thread` for each. */
void model_launch(dim3 grid, dim3 block, const std::function<void()> &thread);

struct cudaLaunchConfig_t {
    dim3 gridDim, blockDim;
    size_t dynamicSmemBytes;
    cudaStream_t stream;
};
template <typename... P, typename... A>
cudaError_t cudaLaunchKernelEx(const cudaLaunchConfig_t *config, void (*kernel)(P...), const A &...arguments)
{
    std::tuple<std::decay_t<P>...> kept(arguments...);
    dim3 grid = config->gridDim, block = config->blockDim;
    if (block.x < 1 || block.x > 1024 || grid.x < 1)
        return cudaErrorInvalidValue;
    return model_queue(config->stream, [=] { model_launch(grid, block, [&] { std::apply(kernel, kept); }); });
}

#endif
