/* Draws spheres on a device of a launch layer: the cuda renderer, and in tests the same on the host. */
#ifndef RENDER_CUDA_CANVAS_DEVICE_H
#define RENDER_CUDA_CANVAS_DEVICE_H

#include "device/device.h"
#include "render/canvas.h"

/* `kernels` are those of the device, by enum draw_kernel. As canvas_row.open and the others. */
enum status canvas_device_open(void **canvas, const struct device_row *device, const struct kernel *kernels,
                               const struct render_setup *setup, struct error *e);
enum status canvas_device_share(void *canvas, const struct slots *slots, struct error *e);
enum status canvas_device_draw(void *canvas, const struct camera *camera, const struct render_frame *frame,
                               struct image *image, struct error *e);
const char *canvas_device_name(const void *canvas);
void canvas_device_close(void *canvas);

#endif
