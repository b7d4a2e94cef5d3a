/* A CUDA device, for the files that make one. */
#ifndef DEVICE_DEVICE_CUDA_H
#define DEVICE_DEVICE_CUDA_H

#include <cuda_runtime.h>

extern "C" {
#include "device/device.h"
}

enum { FAILED_NAME = 160 };

struct device {
    int index;
    cudaStream_t stream;
    void *scratch;       /* of sorting and scanning */
    size_t scratch_bytes;
    const char *last;    /* kernel, or graph of them, that was launched last */
    const char *first;   /* of a recording; NULL: none yet */
    cudaError_t failure; /* the first that was not reported yet */
    char failed[FAILED_NAME]; /* what failed */
    cudaError_t before;  /* the failure before a recording began */
};

/* Its queue, with the device set for this thread, which each has its own: frames may be drawn by another than
 * steps. */
cudaStream_t cuda_stream(struct device *d);

/* Keeps the first failure for the next call that can report it. */
bool cuda_keep(struct device *d, cudaError_t result, const char *what);
enum status cuda_report(struct device *d, struct error *e);

/* Members of device_cuda (struct device_row). */
struct device_event *cuda_event(struct device *d, struct error *e);
void cuda_drop(struct device *d, struct device_event *event);
enum status cuda_signal(struct device *d, struct device_event *event, struct error *e);
void cuda_follow(struct device *d, struct device_event *event);
struct device_buffer *cuda_attach(struct device *d, const struct device_gl *gl, struct error *e);
void cuda_detach(struct device *d, struct device_buffer *buffer);
void *cuda_map(struct device *d, struct device_buffer *buffer, struct error *e);
enum status cuda_unmap(struct device *d, struct device_buffer *buffer, struct error *e);
double cuda_peak(struct device *d);
double cuda_bandwidth(struct device *d);

#endif
