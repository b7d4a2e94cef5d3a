/* Lists EGL's devices. */
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

typedef __eglMustCastToProperFunctionPointerType address_function(const char *name);

void *egl_library(void)
{
    return dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);
}

static address_function *find_function(void)
{
    address_function *find = NULL;
    void *library = egl_library();
    void *address = library ? dlsym(library, "eglGetProcAddress") : NULL;
    memcpy(&find, &address, sizeof find);
    return find;
}

static int cuda_of(EGLDeviceEXT device, const char *extensions, PFNEGLQUERYDEVICEATTRIBEXTPROC attribute)
{
    EGLAttrib number = -1;
    if (attribute && strstr(extensions, "EGL_NV_device_cuda") &&
        attribute(device, EGL_CUDA_DEVICE_NV, &number))
        return (int)number;
    return -1;
}

int egl_devices(struct egl_device devices[EGL_DEVICES])
{
    EGLDeviceEXT handles[EGL_DEVICES];
    EGLint count = 0;
    address_function *find = find_function();
    if (!find)
        return 0;
    PFNEGLQUERYDEVICESEXTPROC query = (PFNEGLQUERYDEVICESEXTPROC)find("eglQueryDevicesEXT");
    PFNEGLQUERYDEVICESTRINGEXTPROC text =
        (PFNEGLQUERYDEVICESTRINGEXTPROC)find("eglQueryDeviceStringEXT");
    PFNEGLQUERYDEVICEATTRIBEXTPROC attribute =
        (PFNEGLQUERYDEVICEATTRIBEXTPROC)find("eglQueryDeviceAttribEXT");
    if (!query || !query(EGL_DEVICES, handles, &count))
        return 0;
    for (EGLint i = 0; i < count; i++) {
        const char *list = text ? text(handles[i], EGL_EXTENSIONS) : NULL;
        list = list ? list : "";
        devices[i] = (struct egl_device){.handle = handles[i],
                                         .software = strstr(list, "EGL_MESA_device_software"),
                                         .cuda = cuda_of(handles[i], list, attribute)};
    }
    return count;
}

#else

int egl_devices(struct egl_device devices[EGL_DEVICES])
{
    (void)devices;
    return 0;
}

#endif

int egl_device_of_cuda(int cuda)
{
    struct egl_device devices[EGL_DEVICES];
    int count = cuda < 0 ? 0 : egl_devices(devices);
    for (int i = 0; i < count; i++)
        if (devices[i].cuda == cuda)
            return i;
    return -1;
}
