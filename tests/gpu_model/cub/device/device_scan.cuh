/* Of the model of a GPU: sums of what comes before. */
#ifndef GPU_MODEL_DEVICE_SCAN_CUH
#define GPU_MODEL_DEVICE_SCAN_CUH

#include "cuda_runtime.h"

namespace cub
{
struct DeviceScan {
    template <typename T>
    static cudaError_t ExclusiveSum(void *scratch, size_t &bytes, const T *in, T *out, size_t count,
                                    cudaStream_t stream)
    {
        if (!scratch) {
            bytes = 64;
            return cudaSuccess;
        }
        return model_queue(stream, [=] {
            T sum = 0;
            memset(scratch, 0xa5, 64);
            for (size_t i = 0; i < count; i++) {
                T own = in[i];
                out[i] = sum;
                sum += own;
            }
        });
    }
};
} // namespace cub

#endif
