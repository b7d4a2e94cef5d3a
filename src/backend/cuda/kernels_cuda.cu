/* The kernels on a GPU: a thread is a particle, and sums over particles do not depend on their order. */
#include <cooperative_groups.h>
#include <cooperative_groups/reduce.h>

#include "device/launch.h"
#include "device/subset.h"
extern "C" {
#include "backend/cuda/lanes_cuda.h"
#include "backend/cuda/share.h"
#include "backend/work.h"

static inline void residual_count(const struct work *w, size_t i, int64_t error, int64_t signed_error)
{
    (void)i;
    share_add64((uint64_t *)&w->scalars->sums.fixed[0], (uint64_t)error);
    share_add64((uint64_t *)&w->scalars->sums.fixed[1], (uint64_t)signed_error);
}

#include "backend/bodies/each.h"
#include "backend/bodies/pair_bodies.h"
#include "backend/cuda/frame.h"
#include "backend/cuda/order.h"
}
#undef inline

extern "C" {
#include "backend/cuda/kernels.h"
}

static_assert(sizeof(struct work) <= KERNEL_ARGS && sizeof(struct order_work) <= KERNEL_ARGS,
              "arguments of kernels fit");
#define FRAME(name, type) static_assert(sizeof(type) <= KERNEL_ARGS, "arguments of kernels fit");
#include "backend/cuda/frame_list.h"
#undef FRAME

/* PAIR_MOST bounds the registers of a thread (128), of which pair sums need fewer. */
enum { THREADS = 256, PAIR_THREADS = 128, PAIR_MOST = 512, GRID_MAX = 2048, WARP = 32 };

/* Blocks for one thread each, or, where blocks go on to further particles, at most GRID_MAX. */
static unsigned blocks_for(size_t threads, unsigned per_block)
{
    return (unsigned)((threads + per_block - 1) / per_block);
}
static unsigned few_blocks(size_t threads)
{
    unsigned blocks = blocks_for(threads, THREADS);
    return blocks < GRID_MAX ? blocks : GRID_MAX;
}

/* Every thread of a block runs as often: `inside` says whether there is a particle. */
#define OVER_PARTICLES(n)                                                                          \
    for (size_t base = (size_t)blockIdx.x * THREADS; base < (n); base += (size_t)gridDim.x * THREADS)

static __device__ struct extremes extremes_of_warp(struct extremes own)
{
    for (int step = WARP / 2; step > 0; step /= 2) {
        own.speed2 = fmaxf(own.speed2, __shfl_xor_sync(~0u, own.speed2, step));
        own.acceleration2 = fmaxf(own.acceleration2, __shfl_xor_sync(~0u, own.acceleration2, step));
        own.move2 = fmaxf(own.move2, __shfl_xor_sync(~0u, own.move2, step));
        own.bad = min(own.bad, __shfl_xor_sync(~0u, own.bad, step));
    }
    return own;
}

/* None is negative: their bits are in the same order. */
static __device__ void largest_share(float *all, float own)
{
    if (own > 0)
        atomicMax((int *)all, __float_as_int(own));
}

/* Those of a block first, so that few threads meet at the same place. */
static __device__ void extremes_share(struct extremes *all, struct extremes own)
{
    __shared__ struct extremes part[THREADS / WARP];
    own = extremes_of_warp(own);
    if (threadIdx.x % WARP == 0)
        part[threadIdx.x / WARP] = own;
    __syncthreads();
    if (threadIdx.x >= WARP)
        return;
    own = extremes_of_warp(part[threadIdx.x % (THREADS / WARP)]);
    if (threadIdx.x != 0)
        return;
    largest_share(&all->speed2, own.speed2);
    largest_share(&all->acceleration2, own.acceleration2);
    largest_share(&all->move2, own.move2);
    if (own.bad != UINT32_MAX)
        atomicMin(&all->bad, own.bad);
}

/* Exact sums of a block's threads, in shared memory. */
template <int TERMS> struct block_sums {
    unsigned long long part[TERMS][EXACT_PARTS];
};

template <int TERMS> static __device__ void sums_clear(block_sums<TERMS> *s)
{
    for (unsigned k = threadIdx.x; k < TERMS * EXACT_PARTS; k += THREADS)
        s->part[k / EXACT_PARTS][k % EXACT_PARTS] = 0;
    __syncthreads();
}

static __device__ unsigned long long warp_sum(unsigned long long x)
{
    for (int step = WARP / 2; step > 0; step /= 2)
        x += __shfl_xor_sync(~0u, x, step);
    return x;
}

/* Every thread of a warp adds a term, 0 for none: those of the same parts together, then one for all. */
template <int TERMS>
static __device__ void sums_add(block_sums<TERMS> *s, const double term[], struct exact_sum *all)
{
    for (int t = 0; t < TERMS; t++) {
        int64_t part[3] = {0, 0, 0};
        int k = exact_split(term[t], part);
        if (k == -2)
            all[t].bad = true;
        for (unsigned left = __ballot_sync(~0u, k >= 0); left != 0;) {
            int lowest = __shfl_sync(~0u, k, __ffs((int)left) - 1);
            bool mine = k == lowest;
            for (int n = 0; n < 3; n++) {
                unsigned long long sum = warp_sum(mine ? (unsigned long long)part[n] : 0);
                if (threadIdx.x % WARP == 0 && sum != 0)
                    atomicAdd(&s->part[t][lowest + n], sum);
            }
            left &= ~__ballot_sync(~0u, mine);
        }
    }
}

template <int TERMS> static __device__ void sums_share(const block_sums<TERMS> *s, struct exact_sum *all)
{
    __syncthreads();
    for (unsigned k = threadIdx.x; k < TERMS * EXACT_PARTS; k += THREADS) {
        unsigned long long part = s->part[k / EXACT_PARTS][k % EXACT_PARTS];
        if (part != 0)
            atomicAdd((unsigned long long *)&all[k / EXACT_PARTS].part[k % EXACT_PARTS], part);
    }
}

/* The sums of a term over each 16 threads of a block, one after the other, in its first threads; 0 in the others.
 * One warp adds, since many GPUs have few units for double precision. */
static __device__ double sum_in_order(double term)
{
    constexpr int ROWS = (int)THREADS / (int)PARTICLE_BLOCK;
    __shared__ double kept[ROWS][PARTICLE_BLOCK + 1]; /* one more: each row in banks of its own */
    double sum = 0;
    __syncthreads();
    kept[threadIdx.x / PARTICLE_BLOCK][threadIdx.x % PARTICLE_BLOCK] = term;
    __syncthreads();
    if (threadIdx.x < ROWS)
        for (int l = 0; l < PARTICLE_BLOCK; l++)
            sum += kept[threadIdx.x][l];
    return sum;
}

#define LAUNCH(name, blocks, per_block, type)                                                      \
    static void run_##name(size_t threads, const void *args, void *stream)                         \
    {                                                                                              \
        launch(kernel_##name, blocks, per_block, stream, *(const type *)args);                     \
    }
#define KERNEL(name, per_block)                                                                    \
    __global__ void __launch_bounds__(per_block)                                                   \
        kernel_##name(const __grid_constant__ struct work work)
#define UNLESS_ENDED(w)                                                                            \
    const struct work *w = &work;                                                                  \
    if (work_ended(w))                                                                             \
        return

#define EACH(name, terms)                                                                          \
    KERNEL(name, THREADS)                                                                          \
    {                                                                                              \
        UNLESS_ENDED(w);                                                                           \
        size_t i = (size_t)blockIdx.x * THREADS + threadIdx.x;                                     \
        if (i < w->count)                                                                          \
            each_##name(w, i);                                                                     \
    }                                                                                              \
    LAUNCH(name, blocks_for(threads, THREADS), THREADS, struct work)
#define SCALAR(name, terms)                                                                        \
    KERNEL(name, 1)                                                                                \
    {                                                                                              \
        UNLESS_ENDED(w);                                                                           \
        scalar_##name(w);                                                                          \
    }                                                                                              \
    LAUNCH(name, (unsigned)threads, 1, struct work)
#define EXTREMES(name, terms)                                                                      \
    KERNEL(name, THREADS)                                                                          \
    {                                                                                              \
        UNLESS_ENDED(w);                                                                           \
        struct extremes own = {0, 0, 0, UINT32_MAX};                                               \
        OVER_PARTICLES(w->count)                                                                   \
        if (base + threadIdx.x < w->count)                                                         \
            each_##name(w, base + threadIdx.x, &own);                                              \
        extremes_share(&w->scalars->extremes, own);                                                \
    }                                                                                              \
    LAUNCH(name, few_blocks(threads), THREADS, struct work)
#define FIXED(name, terms)                                                                         \
    KERNEL(name, THREADS)                                                                          \
    {                                                                                              \
        UNLESS_ENDED(w);                                                                           \
        int64_t sum = 0;                                                                           \
        OVER_PARTICLES(w->count)                                                                   \
        if (base + threadIdx.x < w->count)                                                         \
            sum += each_##name(w, base + threadIdx.x);                                             \
        share_add64((uint64_t *)&w->scalars->sums.fixed[0], (uint64_t)sum);                        \
    }                                                                                              \
    LAUNCH(name, few_blocks(threads), THREADS, struct work)
/* `gather` is what the threads of a warp do with their terms first. */
#define SUMMED(name, terms, gather)                                                                \
    KERNEL(name, THREADS)                                                                          \
    {                                                                                              \
        UNLESS_ENDED(w);                                                                           \
        __shared__ block_sums<terms> sums;                                                         \
        sums_clear(&sums);                                                                         \
        OVER_PARTICLES(w->count)                                                                   \
        {                                                                                          \
            double term[SCALAR_SUMS] = {0};                                                        \
            if (base + threadIdx.x < w->count)                                                     \
                each_##name(w, base + threadIdx.x, term);                                          \
            gather;                                                                                \
            sums_add(&sums, term, w->scalars->sums.exact);                                         \
        }                                                                                          \
        sums_share(&sums, w->scalars->sums.exact);                                                 \
    }                                                                                              \
    LAUNCH(name, few_blocks(threads), THREADS, struct work)
#define SUMS(name, terms) SUMMED(name, terms, )
#define BLOCKS(name, terms)                                                                        \
    SUMMED(name, terms, for (int t = 0; t < terms; t++) term[t] = sum_in_order(term[t]))
#define STAGE(kind, name, terms) kind(name, terms)
#include "backend/bodies/stage_list.h"
#undef STAGE

static unsigned pair_block(const void *work)
{
    const unsigned block = ((const struct work *)work)->block;
    return block ? block : PAIR_THREADS;
}

#define PAIR(name, call)                                                                           \
    KERNEL(pair_##name, PAIR_MOST)                                                                 \
    {                                                                                              \
        UNLESS_ENDED(w);                                                                           \
        size_t i = (size_t)blockIdx.x * blockDim.x + threadIdx.x;                                  \
        if (i < w->count)                                                                          \
            call;                                                                                  \
    }                                                                                              \
    LAUNCH(pair_##name, blocks_for(threads, pair_block(args)), pair_block(args), struct work)
#include "backend/bodies/pair_list.h"
#define FORCE(flags)                                                                               \
    PAIR(force_##flags, force_sum(w, i, flags, false))                                             \
    PAIR(force_walls_##flags, force_sum(w, i, flags, true))
#include "backend/bodies/force_list.h"
#undef FORCE
#undef PAIR

/* Of as many threads as there are things to do. */
#define PLAIN(name, type)                                                                          \
    __global__ void __launch_bounds__(THREADS)                                                     \
        kernel_##name(const __grid_constant__ type work, size_t threads)                           \
    {                                                                                              \
        size_t i = (size_t)blockIdx.x * THREADS + threadIdx.x;                                     \
        if (i < threads)                                                                           \
            name(&work, i);                                                                        \
    }                                                                                              \
    static void run_##name(size_t threads, const void *args, void *stream)                         \
    {                                                                                              \
        launch(kernel_##name, blocks_for(threads, THREADS), THREADS, stream, *(const type *)args,  \
               threads);                                                                           \
    }
#define ORDER(name) PLAIN(order_##name, struct order_work)
#include "backend/cuda/order_list.h"
#undef ORDER
#define FRAME(name, type) PLAIN(frame_##name, type)
#include "backend/cuda/frame_list.h"
#undef FRAME

extern "C" const struct kernel kernels_cuda[KERNEL_COUNT] = {
#include "backend/cuda/kernel_rows.h"
};

extern "C" bool kernels_cuda_load(int device, const char **why)
{
    struct cudaFuncAttributes attributes;
    cudaError_t result = cudaSetDevice(device);
    if (result == cudaSuccess)
        result = cudaFuncGetAttributes(&attributes, kernel_pressure);
    *why = cudaGetErrorString(result);
    cudaGetLastError();
    return result == cudaSuccess;
}
