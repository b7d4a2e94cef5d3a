/* The cuda renderer's kernels on a GPU. */
#include <cuda/atomic>

#include "device/launch.h"
#include "device/subset.h"
extern "C" {
/* Only what is nearer than what a thread finds there: others may have put something nearer since. */
static __device__ __inline__ void draw_least(uint64_t *least, uint64_t key)
{
    const cuda::atomic_ref<uint64_t, cuda::thread_scope_device> now(*least);
    if (key < now.load(cuda::memory_order_relaxed))
        atomicMin((unsigned long long *)least, (unsigned long long)key);
}
static __device__ __inline__ int draw_lowest(uint32_t bits)
{
    return __ffs((int)bits) - 1;
}

#include "render/picture.h"
#include "render/place.h"
#include "render/sample.h"
#include "render/cuda/draw.h"
}
#undef inline

extern "C" {
#include "render/cuda/draw_kernels.h"
}

static_assert(sizeof(struct draw_work) <= KERNEL_ARGS, "arguments of kernels fit");

enum { THREADS = 256 };

#define DRAW(name)                                                                                 \
    __global__ void __launch_bounds__(THREADS)                                                     \
        kernel_##name(const __grid_constant__ struct draw_work work, size_t threads)               \
    {                                                                                              \
        const size_t i = (size_t)blockIdx.x * THREADS + threadIdx.x;                               \
        if (i < threads)                                                                           \
            draw_##name(&work, i);                                                                 \
    }                                                                                              \
    static void run_##name(size_t threads, const void *args, void *stream)                         \
    {                                                                                              \
        const unsigned blocks = (unsigned)((threads + THREADS - 1) / THREADS);                     \
        launch(kernel_##name, blocks, THREADS, stream, *(const struct draw_work *)args, threads);  \
    }
#include "render/cuda/draw_list.h"
#undef DRAW

#define DRAW(name) {"draw: " #name, sizeof(struct draw_work), run_##name},
extern "C" const struct kernel draw_kernels_cuda[DRAW_COUNT] = {
#include "render/cuda/draw_list.h"
};
