/* The model of a GPU: buffers of the OpenGL context that is current by EGL. */
#include "model.h"

#include <dlfcn.h>

#if HAVE_EGL
#include <GL/gl.h>
#include <GL/glext.h>
#include <cuda_gl_interop.h>
#else
enum { GL_COPY_WRITE_BUFFER, GL_BUFFER_SIZE, GL_MAP_WRITE_BIT, GL_MAP_INVALIDATE_BUFFER_BIT };
#endif

struct cudaGraphicsResource {
    unsigned buffer;
    void *mapped;
    size_t bytes;
};

/* A function of the context that EGL has made current; NULL: there is none. */
template <typename F> static F *gl_function(const char *name)
{
    void *library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    if (!library)
        return NULL;
    auto context = (void *(*)())dlsym(library, "eglGetCurrentContext");
    auto find = (void *(*)(const char *))dlsym(library, "eglGetProcAddress");
    return context() ? (F *)find(name) : NULL;
}

cudaError_t cudaGraphicsGLRegisterBuffer(cudaGraphicsResource_t *resource, unsigned buffer, unsigned)
{
    if (!gl_function<void(unsigned, unsigned)>("glBindBuffer"))
        return model_failed(cudaErrorNotSupported);
    *resource = new cudaGraphicsResource();
    (*resource)->buffer = buffer;
    return cudaSuccess;
}

cudaError_t cudaGraphicsUnregisterResource(cudaGraphicsResource_t resource)
{
    delete resource;
    return cudaSuccess;
}

cudaError_t cudaGraphicsMapResources(int, cudaGraphicsResource_t *resource, cudaStream_t)
{
    MODEL_LOCK;
    auto bind = gl_function<void(unsigned, unsigned)>("glBindBuffer");
    auto size = gl_function<void(unsigned, unsigned, int64_t *)>("glGetBufferParameteri64v");
    auto map = gl_function<void *(unsigned, intptr_t, intptr_t, unsigned)>("glMapBufferRange");
    int64_t bytes = 0;
    if (!bind || (*resource)->mapped || model_lost)
        return model_failed(cudaErrorInvalidValue);
    bind(GL_COPY_WRITE_BUFFER, (*resource)->buffer);
    size(GL_COPY_WRITE_BUFFER, GL_BUFFER_SIZE, &bytes);
    (*resource)->bytes = (size_t)bytes;
    (*resource)->mapped = map(GL_COPY_WRITE_BUFFER, 0, bytes, GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
    return (*resource)->mapped ? cudaSuccess : model_failed(cudaErrorInvalidValue);
}

/* OpenGL does not wait for streams here: they are run first. */
cudaError_t cudaGraphicsUnmapResources(int, cudaGraphicsResource_t *resource, cudaStream_t stream)
{
    MODEL_LOCK;
    auto bind = gl_function<void(unsigned, unsigned)>("glBindBuffer");
    auto unmap = gl_function<unsigned char(unsigned)>("glUnmapBuffer");
    if (!bind || !(*resource)->mapped || cudaStreamSynchronize(stream))
        return model_failed(cudaErrorInvalidValue);
    bind(GL_COPY_WRITE_BUFFER, (*resource)->buffer);
    (*resource)->mapped = NULL;
    return unmap(GL_COPY_WRITE_BUFFER) ? cudaSuccess : model_failed(cudaErrorInvalidValue);
}

cudaError_t cudaGraphicsResourceGetMappedPointer(void **pointer, size_t *bytes, cudaGraphicsResource_t resource)
{
    *pointer = resource->mapped;
    *bytes = resource->bytes;
    return *pointer ? cudaSuccess : model_failed(cudaErrorInvalidValue);
}
