/* The devices of EGL, and which of them is which CUDA device. None needs a context. */
#ifndef RENDER_EGL_DEVICES_H
#define RENDER_EGL_DEVICES_H

#include <stdbool.h>

enum { EGL_DEVICES = 32 }; /* at most */

struct egl_device {
    void *handle;  /* EGLDeviceEXT */
    bool software; /* draws by the processors */
    int cuda;      /* number of the CUDA device that it is (EGL_NV_device_cuda); -1: of none */
};

/* libEGL, loaded when first asked for and never unloaded: drivers leave threads and exit handlers behind.
 * NULL: dlerror says why. Only in builds with EGL. */
void *egl_library(void);

/* Fills in the devices and returns how many; 0 when EGL cannot tell, or is not in this build. */
int egl_devices(struct egl_device devices[EGL_DEVICES]);

/* The number of the EGL device that is CUDA device `cuda`; -1 when none is. */
int egl_device_of_cuda(int cuda);

#endif
