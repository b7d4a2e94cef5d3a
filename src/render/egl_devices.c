/* Finds the EGL device of a CUDA device. libEGL is loaded when asked for. */
#include "render/egl_devices.h"

#if HAVE_EGL

#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <dlfcn.h>
#include <string.h>

#ifndef EGL_CUDA_DEVICE_NV
#define EGL_CUDA_DEVICE_NV 0x323A
#endif

enum { MAX_DEVICES = 32 };

typedef __eglMustCastToProperFunctionPointerType address_function(const char *name);

static address_function *load(void)
{
    address_function *find = NULL;
    void *library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
    void *address = library ? dlsym(library, "eglGetProcAddress") : NULL;
    memcpy(&find, &address, sizeof find);
    return find; /* the library stays loaded: drivers leave threads and exit handlers behind */
}

int egl_device_of_cuda(int cuda)
{
    EGLDeviceEXT devices[MAX_DEVICES];
    EGLint count = 0;
    address_function *find = load();
    if (!find)
        return -1;
    PFNEGLQUERYDEVICESEXTPROC query = (PFNEGLQUERYDEVICESEXTPROC)find("eglQueryDevicesEXT");
    PFNEGLQUERYDEVICESTRINGEXTPROC text =
        (PFNEGLQUERYDEVICESTRINGEXTPROC)find("eglQueryDeviceStringEXT");
    PFNEGLQUERYDEVICEATTRIBEXTPROC attribute =
        (PFNEGLQUERYDEVICEATTRIBEXTPROC)find("eglQueryDeviceAttribEXT");
    if (!query || !text || !attribute || !query(MAX_DEVICES, devices, &count))
        return -1;
    for (EGLint i = 0; i < count; i++) {
        const char *list = text(devices[i], EGL_EXTENSIONS);
        EGLAttrib number = -1;
        if (list && strstr(list, "EGL_NV_device_cuda") &&
            attribute(devices[i], EGL_CUDA_DEVICE_NV, &number) && number == cuda)
            return i;
    }
    return -1;
}

#else

int egl_device_of_cuda(int cuda)
{
    (void)cuda;
    return -1;
}

#endif
