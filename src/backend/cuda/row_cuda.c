/* The row of the cuda back end; without CUDA only how to get it. */
#include "backend/cuda/cuda.h"

#include <stdio.h>

#define NAME "cuda"
#define DOC "a GPU of NVIDIA: --backend cuda, or cuda:N for device N, cuda:N:B with B threads a block"

#if HAVE_CUDA
static enum status open_cuda(struct backend **out, const struct backend_setup *setup,
                             struct particles *particles, struct particles *walls, struct error *e)
{
    const char *why;
    if (device_cuda.exists(setup->device, e))
        return e->status;
    if (!kernels_cuda_load(setup->device, &why))
        return error_set(e, STATUS_BACKEND, "cuda:%d cannot run this program: %s; use --backend cpu, or build for its "
                         "compute capability (make CUDA_ARCHS=...; docs/gpus.md)", setup->device, why);
    return cuda_open_on(&device_cuda, kernels_cuda, out, setup, particles, walls, e);
}

static bool available(const char **why)
{
    return device_cuda.count(why) > 0 && kernels_cuda_load(0, why);
}

static enum status exists(int device, struct error *e)
{
    e->status = STATUS_OK;
    return device_cuda.exists(device, e);
}

static double memory(int device, char name[64], struct error *e)
{
    struct device_info info;
    if (device_cuda.info(device, &info, e))
        return 0;
    snprintf(name, 64, "%.63s", info.name);
    return (double)info.free;
}

const struct backend_row backend_cuda = {
    .variant = {.name = NAME, .doc = DOC},
    .has_devices = true,
    .device = &device_cuda,
    .available = available,
    .exists = exists,
    .memory = memory,
    .open = open_cuda,
    CUDA_FUNCTIONS,
};
#else
const struct backend_row backend_cuda = {
    .variant = {.name = NAME, .doc = DOC,
                .missing = "build with make CUDA=1 (the CUDA toolkit, for nvcc)"},
};
#endif
