/* How threads of a GPU add to integers that they share: the threads at the same place add together, then
 * one adds for all. Part of kernels_cuda.cu. */
#ifndef BACKEND_CUDA_SHARE_H
#define BACKEND_CUDA_SHARE_H

static __device__ void share_add64(uint64_t *sum, uint64_t x)
{
    namespace groups = cooperative_groups;
    groups::coalesced_group together = groups::coalesced_threads();
    unsigned long long all = groups::reduce(together, (unsigned long long)x,
                                            groups::plus<unsigned long long>());
    if (together.thread_rank() == 0 && all != 0)
        atomicAdd((unsigned long long *)sum, all);
}
static inline void order_add64(uint64_t *sum, uint64_t x)
{
    share_add64(sum, x);
}
static inline void order_move(void *to, const void *from)
{
    *(uint4 *)to = *(const uint4 *)from;
}
static inline uint32_t order_bits(uint32_t word)
{
    return (uint32_t)__popc(word);
}
static inline uint32_t order_lowest(uint32_t word)
{
    return (uint32_t)__ffs((int)word) - 1;
}
static inline void order_add(uint32_t *sum, uint32_t x)
{
    atomicAdd(sum, x);
}

#endif
