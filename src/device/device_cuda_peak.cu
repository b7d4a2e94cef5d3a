/* CUDA devices: what they can do at most, measured. */
#include <cuda_runtime.h>

#include "device/device_cuda.h"
#include "device/launch.h"

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
        cudaEventRecord(first, cuda_stream(d));
        run(d, context);
        cudaEventRecord(last, cuda_stream(d));
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
    return 16 * processors;
}

static void run_multiply_adds(struct device *d, void *out)
{
    launch(multiply_adds, (unsigned)peak_blocks(), PEAK_THREADS, cuda_stream(d), (float *)out, 0.999f, 1e-3f);
}

double cuda_peak(struct device *d)
{
    const double flops = 2.0 * (double)PEAK_ROUNDS * (double)PEAK_CHAINS * (double)PEAK_THREADS;
    void *out = NULL;
    cuda_stream(d);
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
    cudaMemcpyAsync((char *)block + COPY_BYTES, block, COPY_BYTES, cudaMemcpyDeviceToDevice, cuda_stream(d));
}

double cuda_bandwidth(struct device *d)
{
    void *block = NULL;
    cuda_stream(d);
    if (cudaMalloc(&block, 2 * COPY_BYTES) != cudaSuccess) {
        cudaGetLastError();
        return 0;
    }
    double seconds = shortest(d, run_copy, block);
    cudaFree(block);
    return seconds > 0 ? 2.0 * (double)COPY_BYTES / seconds : 0;
}
