/* How .cu files launch kernels. */
#ifndef DEVICE_LAUNCH_H
#define DEVICE_LAUNCH_H

#include <cuda_runtime.h>

template <typename... Parameters, typename... Arguments>
static void launch(void (*kernel)(Parameters...), unsigned blocks, unsigned threads, void *stream,
                   const Arguments &...arguments)
{
    cudaLaunchConfig_t config = {};
    config.gridDim = dim3(blocks);
    config.blockDim = dim3(threads);
    config.stream = (cudaStream_t)stream;
    cudaLaunchKernelEx(&config, kernel, arguments...);
}

#endif
