/* Films of t443 on a model of a GPU (tests/gpu_model): the .cu files' kernels and streams, and buffers of OpenGL
 * that cudaGraphics functions map. */
#include "backend/cuda/kernels.h"
#include "render/cuda/draw_kernels.h"

#define ON_MODEL
#define DEVICE device_cuda
static const struct kernel *const kernels = kernels_cuda, *const draw_kernels = draw_kernels_cuda;

#include "t443_frames.c"
