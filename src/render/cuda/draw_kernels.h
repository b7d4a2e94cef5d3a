/* The kernels of the cuda renderer, made from their list. */
#ifndef RENDER_CUDA_DRAW_KERNELS_H
#define RENDER_CUDA_DRAW_KERNELS_H

#include "device/device.h"
#include "render/cuda/draw_work.h"

enum draw_kernel {
#define DRAW(name) DRAW_##name,
#include "render/cuda/draw_list.h"
#undef DRAW
    DRAW_COUNT
};

/* By enum draw_kernel; they take struct draw_work. */
extern const struct kernel draw_kernels_host[DRAW_COUNT];
extern const struct kernel draw_kernels_cuda[DRAW_COUNT]; /* only with CUDA=1 */

#endif
