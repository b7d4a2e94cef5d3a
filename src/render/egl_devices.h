/* Which OpenGL device is which CUDA device. */
#ifndef RENDER_EGL_DEVICES_H
#define RENDER_EGL_DEVICES_H

/* The number of the EGL device that is CUDA device `cuda` (EGL_NV_device_cuda); -1 when none is, or this
 * build or machine has no EGL. */
int egl_device_of_cuda(int cuda);

#endif
