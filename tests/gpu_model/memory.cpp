/* The model of a GPU: memory that begins as garbage, copies, errors, and what the device is. */
#include "model.h"

#include <map>
#include <memory>
#include <vector>

static cudaError_t last_error;

cudaError_t model_failed(cudaError_t error)
{
    last_error = error;
    return error;
}

/* What the environment says, or the usual. */
static size_t setting(const char *name, size_t usual)
{
    const char *text = getenv(name);
    return text ? strtoull(text, NULL, 10) : usual;
}
static const size_t memory_most = setting("GPU_MODEL_MEMORY", (size_t)1 << 40); /* bytes */
static const size_t memory_short = setting("GPU_MODEL_SHORT", 0); /* bytes that are free but cannot be had */
static const long lost_at = (long)setting("GPU_MODEL_LOST", 0);

bool model_lost;

void model_lose()
{
    model_lost = model_lost || (lost_at > 0 && model_counts.kernels >= lost_at);
}

cudaError_t model_state()
{
    return model_lost ? model_failed(cudaErrorLaunchFailure) : cudaSuccess;
}

static std::map<void *, size_t> on_device, pinned;

static size_t allocated()
{
    size_t sum = 0;
    for (const auto &block : on_device)
        sum += block.second;
    return sum;
}

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
    MODEL_LOCK;
    if (model_lost)
        return model_state();
    if (blocks == &on_device && allocated() + bytes + memory_short > memory_most)
        return model_failed(cudaErrorMemoryAllocation);
    *block = aligned_alloc(256, (bytes + 255) / 256 * 256);
    if (!*block)
        return model_failed(cudaErrorMemoryAllocation);
    memset(*block, 0xa5, bytes);
    (*blocks)[*block] = bytes;
    return cudaSuccess;
}

static cudaError_t release_block(std::map<void *, size_t> *blocks, void *block)
{
    MODEL_LOCK;
    if (!block)
        return cudaSuccess;
    model_synchronize();
    if (!blocks->count(block))
        return model_failed(cudaErrorInvalidValue);
    memset(block, 0x5a, (*blocks)[block]);
    blocks->erase(block);
    free(block);
    return model_state();
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
    return lies_in(on_device, block, bytes) ? cudaSuccess : model_failed(cudaErrorInvalidValue);
}

cudaError_t cudaMemsetAsync(void *to, int value, size_t bytes, cudaStream_t stream)
{
    MODEL_LOCK;
    if (memory_check(to, bytes))
        return cudaErrorInvalidValue;
    return model_queue(stream, [=] { memset(to, value, bytes); });
}

/* Memory that is not pinned is read before the call returns, and written before it returns. */
cudaError_t cudaMemcpyAsync(void *to, const void *from, size_t bytes, cudaMemcpyKind kind, cudaStream_t stream)
{
    MODEL_LOCK;
    if ((kind != cudaMemcpyDeviceToHost && memory_check(to, bytes)) ||
        (kind != cudaMemcpyHostToDevice && memory_check(from, bytes)))
        return cudaErrorInvalidValue;
    if (kind == cudaMemcpyHostToDevice && !lies_in(pinned, from, bytes)) {
        auto copy = std::make_shared<std::vector<char>>((const char *)from, (const char *)from + bytes);
        return model_queue(stream, [=] { memcpy(to, copy->data(), bytes); });
    }
    model_queue(stream, [=] { memcpy(to, from, bytes); });
    if (kind == cudaMemcpyDeviceToHost && !lies_in(pinned, to, bytes))
        return cudaStreamSynchronize(stream);
    return cudaSuccess;
}

extern "C" struct gpu_model_counts gpu_model_counts(void)
{
    MODEL_LOCK;
    model_counts.device_bytes = allocated();
    return model_counts;
}

const char *cudaGetErrorString(cudaError_t error)
{
    static const char *const words[] = {"no error", "invalid argument", "out of memory",
                                        "operation not permitted when stream is capturing",
                                        "operation not supported", "unspecified launch failure",
                                        "CUDA driver version is insufficient for CUDA runtime version"};
    return words[error];
}
const char *cudaGetErrorName(cudaError_t error)
{
    return cudaGetErrorString(error);
}
cudaError_t cudaGetLastError()
{
    cudaError_t error = model_lost ? cudaErrorLaunchFailure : last_error;
    last_error = cudaSuccess;
    return error;
}
cudaError_t cudaGetDeviceCount(int *count)
{
    *count = 1;
    return getenv("GPU_MODEL_DRIVER") ? cudaErrorInsufficientDriver : cudaSuccess;
}
cudaError_t cudaGetDevice(int *index)
{
    *index = 0;
    return cudaSuccess;
}
cudaError_t cudaSetDevice(int index)
{
    return index == 0 ? model_state() : model_failed(cudaErrorInvalidValue);
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
    MODEL_LOCK;
    *available = memory_most - allocated();
    *all = memory_most;
    return model_state();
}
cudaError_t cudaDriverGetVersion(int *version)
{
    const char *old = getenv("GPU_MODEL_DRIVER"); /* as 12040 */
    *version = old ? atoi(old) : 13000;
    return cudaSuccess;
}
cudaError_t cudaRuntimeGetVersion(int *version)
{
    *version = 13000;
    return cudaSuccess;
}
