/* Of the model of a GPU: buffers of the OpenGL context that is current by EGL. */
#ifndef GPU_MODEL_CUDA_GL_INTEROP_H
#define GPU_MODEL_CUDA_GL_INTEROP_H

#include "cuda_runtime.h"

typedef struct cudaGraphicsResource *cudaGraphicsResource_t;
enum { cudaGraphicsRegisterFlagsWriteDiscard = 2 };
cudaError_t cudaGraphicsGLRegisterBuffer(cudaGraphicsResource_t *, unsigned buffer, unsigned flags);
cudaError_t cudaGraphicsUnregisterResource(cudaGraphicsResource_t);
cudaError_t cudaGraphicsMapResources(int, cudaGraphicsResource_t *, cudaStream_t = 0);
cudaError_t cudaGraphicsUnmapResources(int, cudaGraphicsResource_t *, cudaStream_t = 0);
cudaError_t cudaGraphicsResourceGetMappedPointer(void **, size_t *, cudaGraphicsResource_t);

#endif
