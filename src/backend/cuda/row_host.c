/* The passes of cuda on the host: a back end for tests, in no table. */
#include "backend/cuda/cuda.h"

static enum status open_host(struct backend **out, const struct backend_setup *setup,
                             struct particles *particles, struct particles *walls, struct error *e)
{
    return cuda_open_on(&device_host, kernels_host, out, setup, particles, walls, e);
}

const struct backend_row backend_cuda_host = {
    .variant = {.name = "cuda-host", .doc = "the passes of cuda on the host"},
    .device = &device_host,
    .open = open_host,
    CUDA_FUNCTIONS,
};
