/* Of the model of a GPU: a stable sort, by the key's chosen bits. */
#ifndef GPU_MODEL_DEVICE_RADIX_SORT_CUH
#define GPU_MODEL_DEVICE_RADIX_SORT_CUH

#include "cuda_runtime.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace cub
{
struct DeviceRadixSort {
    template <typename K, typename V>
    static cudaError_t SortPairs(void *scratch, size_t &bytes, const K *keys, K *sorted_keys, const V *values,
                                 V *sorted_values, size_t count, int begin, int end, cudaStream_t stream)
    {
        if (!scratch) {
            bytes = 16 * count + 1;
            return cudaSuccess;
        }
        return model_queue(stream, [=] {
            const K mask = (end < 64 ? (K)1 << end : (K)0) - ((K)1 << begin);
            std::vector<size_t> order(count);
            memset(scratch, 0xa5, 16 * count + 1);
            std::iota(order.begin(), order.end(), 0);
            std::stable_sort(order.begin(), order.end(),
                             [=](size_t a, size_t b) { return (keys[a] & mask) < (keys[b] & mask); });
            for (size_t i = 0; i < count; i++) {
                sorted_keys[i] = keys[order[i]];
                sorted_values[i] = values[order[i]];
            }
        });
    }
};
} // namespace cub

#endif
