/* CUDA devices: what their queues share with other queues, by events, and with OpenGL, by buffers. */
#if HAVE_EGL
#include <GL/gl.h> /* which the next wants before it on Arm; nothing of OpenGL is linked */
#include <cuda_gl_interop.h>
#endif
#include <cuda_runtime.h>

#include <stdlib.h>

#include "device/device_cuda.h"

struct device_event {
    cudaEvent_t event;
};

struct device_buffer {
    cudaGraphicsResource_t resource;
    size_t bytes;
};

struct device_event *cuda_event(struct device *d, struct error *e)
{
    struct device_event *event = (struct device_event *)calloc(1, sizeof *event);
    cuda_stream(d);
    cudaError_t result = event ? cudaEventCreateWithFlags(&event->event, cudaEventDisableTiming)
                               : cudaErrorMemoryAllocation;
    if (result == cudaSuccess)
        return event;
    cudaGetLastError();
    free(event);
    error_set(e, STATUS_RUN, "the GPU has no event to wait for: %s", cudaGetErrorString(result));
    return NULL;
}

void cuda_drop(struct device *d, struct device_event *event)
{
    if (!event)
        return;
    cuda_stream(d);
    cudaEventDestroy(event->event);
    free(event);
}

/* What is recorded waits for nothing outside its graph, and nothing outside waits for it. */
static cudaError_t not_recording(cudaStream_t stream)
{
    cudaStreamCaptureStatus capture = cudaStreamCaptureStatusNone;
    cudaError_t result = cudaStreamIsCapturing(stream, &capture);
    return capture == cudaStreamCaptureStatusNone ? result : cudaErrorStreamCaptureUnsupported;
}

enum status cuda_signal(struct device *d, struct device_event *event, struct error *e)
{
    cudaStream_t stream = cuda_stream(d);
    cudaError_t result = not_recording(stream);
    cuda_keep(d, result == cudaSuccess ? cudaEventRecord(event->event, stream) : result, "an event");
    return result == cudaSuccess ? cuda_report(d, e) : STATUS_OK; /* a recording's own failures are its end's */
}

void cuda_follow(struct device *d, struct device_event *event)
{
    cudaStream_t stream = cuda_stream(d);
    cudaError_t result = not_recording(stream);
    cuda_keep(d, result == cudaSuccess ? cudaStreamWaitEvent(stream, event->event, 0) : result, "an event");
}

#if HAVE_EGL

/* Some drivers register what they cannot map. */
static cudaError_t try_map(struct device *d, cudaGraphicsResource_t *resource)
{
    cudaError_t result = cudaGraphicsMapResources(1, resource, cuda_stream(d));
    if (result == cudaSuccess)
        result = cudaGraphicsUnmapResources(1, resource, cuda_stream(d));
    if (result != cudaSuccess)
        cudaGraphicsUnregisterResource(*resource);
    return result;
}

struct device_buffer *cuda_attach(struct device *d, const struct device_gl *gl, struct error *e)
{
    struct device_buffer *buffer = (struct device_buffer *)calloc(1, sizeof *buffer);
    if (!buffer) {
        error_set(e, STATUS_RUN, "out of memory");
        return NULL;
    }
    buffer->bytes = gl->bytes;
    cuda_stream(d);
    cudaError_t result = cudaGraphicsGLRegisterBuffer(&buffer->resource, gl->name,
                                                      cudaGraphicsRegisterFlagsWriteDiscard);
    if (result == cudaSuccess)
        result = try_map(d, &buffer->resource);
    if (result == cudaSuccess)
        return buffer;
    cudaGetLastError();
    free(buffer);
    error_set(e, STATUS_BACKEND, "cuda:%d cannot write to OpenGL's buffer %u: %s (%s)", d->index, gl->name,
              cudaGetErrorString(result), cudaGetErrorName(result));
    return NULL;
}

#else

struct device_buffer *cuda_attach(struct device *d, const struct device_gl *gl, struct error *e)
{
    error_set(e, STATUS_BACKEND, "cuda:%d cannot write to OpenGL's buffer %u: not in this build; build with "
              "make EGL=1", d->index, gl->name);
    return NULL;
}

#endif

void cuda_detach(struct device *d, struct device_buffer *buffer)
{
    if (!buffer)
        return;
    cuda_stream(d);
    cuda_keep(d, cudaGraphicsUnregisterResource(buffer->resource), "giving OpenGL's buffer back");
    free(buffer);
}

enum status cuda_unmap(struct device *d, struct device_buffer *buffer, struct error *e)
{
    cuda_keep(d, cudaGraphicsUnmapResources(1, &buffer->resource, cuda_stream(d)), "giving OpenGL's buffer back");
    return cuda_report(d, e);
}

void *cuda_map(struct device *d, struct device_buffer *buffer, struct error *e)
{
    static const char what[] = "taking OpenGL's buffer";
    void *block = NULL;
    size_t bytes = 0;
    struct error ignored;
    if (!cuda_keep(d, cudaGraphicsMapResources(1, &buffer->resource, cuda_stream(d)), what)) {
        cuda_report(d, e);
        return NULL;
    }
    if (cuda_keep(d, cudaGraphicsResourceGetMappedPointer(&block, &bytes, buffer->resource), what) &&
        bytes < buffer->bytes)
        error_set(e, STATUS_RUN, "OpenGL's buffer has %zu bytes for CUDA, not %zu", bytes, buffer->bytes);
    else if (cuda_report(d, e) == STATUS_OK)
        return block;
    cuda_unmap(d, buffer, &ignored);
    return NULL;
}
