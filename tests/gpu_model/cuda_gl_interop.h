/* Of the model of a GPU: buffers of the OpenGL context that is current by EGL. */
#ifndef GPU_MODEL_CUDA_GL_INTEROP_H
#define GPU_MODEL_CUDA_GL_INTEROP_H

#include "cuda_runtime.h"

#ifndef GL_VERSION
#error "OpenGL's header comes first, as CUDA on Arm wants it"
#endif

cudaError_t cudaGraphicsGLRegisterBuffer(cudaGraphicsResource_t *, unsigned buffer, unsigned flags);

#endif
