/* GL context through EGL without a window system: a GPU by the device platform, or Mesa's
 * surfaceless platform. libEGL is loaded when asked for, so the program starts without it. */
#include "render/context.h"

#include "render/egl_devices.h"

#if HAVE_EGL

#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <dlfcn.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* X(result, name without egl, arguments) */
#define EGL_FUNCTIONS(X)                                                                           \
    X(EGLBoolean, BindAPI, (EGLenum))                                                              \
    X(EGLBoolean, ChooseConfig, (EGLDisplay, const EGLint *, EGLConfig *, EGLint, EGLint *))       \
    X(EGLContext, CreateContext, (EGLDisplay, EGLConfig, EGLContext, const EGLint *))              \
    X(EGLBoolean, DestroyContext, (EGLDisplay, EGLContext))                                        \
    X(EGLint, GetError, (void))                                                                    \
    X(__eglMustCastToProperFunctionPointerType, GetProcAddress, (const char *))                    \
    X(EGLBoolean, Initialize, (EGLDisplay, EGLint *, EGLint *))                                    \
    X(EGLBoolean, MakeCurrent, (EGLDisplay, EGLSurface, EGLSurface, EGLContext))                   \
    X(const char *, QueryString, (EGLDisplay, EGLint))                                             \
    X(EGLBoolean, ReleaseThread, (void))                                                           \
    X(EGLBoolean, Terminate, (EGLDisplay))

struct egl {
    EGLDisplay display;
    EGLContext context;
    int cuda; /* number of the CUDA device that it draws on; -1: of none, or unknown */
#define X(result, name, args) result(*name) args;
    EGL_FUNCTIONS(X)
#undef X
    PFNEGLGETPLATFORMDISPLAYEXTPROC GetPlatformDisplay; /* of an extension */
};

static enum status library_open(struct egl *egl, struct error *e)
{
    void *address, *library = egl_library();
    if (!library)
        return error_set(e, STATUS_BACKEND, "%s (Debian package libegl1)", dlerror());
#define X(result, name, args)                                                                      \
    address = dlsym(library, "egl" #name);                                                         \
    if (!address)                                                                                  \
        return error_set(e, STATUS_BACKEND, "libEGL.so.1 has no egl" #name);                       \
    memcpy(&egl->name, &address, sizeof address);
    EGL_FUNCTIONS(X)
#undef X
    egl->GetPlatformDisplay =
        (PFNEGLGETPLATFORMDISPLAYEXTPROC)egl->GetProcAddress("eglGetPlatformDisplayEXT");
    if (!egl->GetPlatformDisplay)
        return error_set(e, STATUS_BACKEND, "libEGL.so.1 cannot open a display without a window "
                                            "system (no EGL_EXT_platform_base)");
    return STATUS_OK;
}

static EGLContext context_create(struct egl *egl)
{
    static const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0,
                                    EGL_NONE};
    static const EGLint core[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    EGLConfig config = NULL;
    EGLint count = 0;
    if (!egl->BindAPI(EGL_OPENGL_API))
        return EGL_NO_CONTEXT;
    if (!egl->ChooseConfig(egl->display, wanted, &config, 1, &count) || count < 1)
        config = EGL_NO_CONFIG_KHR;
    return egl->CreateContext(egl->display, config, EGL_NO_CONTEXT, core);
}

/* Tries one display; on failure nothing stays open and `why` gets a note. */
static bool display_open(struct egl *egl, EGLenum platform, void *native, const char *what,
                         char *why, size_t size)
{
    size_t used = strlen(why);
    egl->display = egl->GetPlatformDisplay(platform, native, NULL);
    if (egl->display != EGL_NO_DISPLAY && egl->Initialize(egl->display, NULL, NULL)) {
        egl->context = context_create(egl);
        if (egl->context != EGL_NO_CONTEXT &&
            egl->MakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl->context)) {
            egl->MakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
            return true;
        }
    }
    snprintf(why + used, size - used, "%s%s: EGL error 0x%04x", used ? ", " : "", what,
             (unsigned)egl->GetError());
    if (egl->context != EGL_NO_CONTEXT)
        egl->DestroyContext(egl->display, egl->context);
    if (egl->display != EGL_NO_DISPLAY)
        egl->Terminate(egl->display);
    egl->context = EGL_NO_CONTEXT;
    egl->display = EGL_NO_DISPLAY;
    return false;
}

/* Which to try first: the GPU that is CUDA device `cuda`, other GPUs, software devices. */
enum { RANK_SHARED, RANK_GPU, RANK_SOFTWARE, RANK_COUNT };

static int rank_of(const struct egl_device *device, int cuda)
{
    if (cuda >= 0 && device->cuda == cuda)
        return RANK_SHARED;
    return device->software ? RANK_SOFTWARE : RANK_GPU;
}

static bool devices_open(struct egl *egl, int cuda, char *why, size_t size)
{
    struct egl_device devices[EGL_DEVICES];
    int count = egl_devices(devices);
    for (int rank = 0; rank < RANK_COUNT; rank++)
        for (int i = 0; i < count; i++)
            if (rank_of(&devices[i], cuda) == rank &&
                display_open(egl, EGL_PLATFORM_DEVICE_EXT, devices[i].handle,
                             devices[i].software ? "software device" : "device", why, size)) {
                egl->cuda = devices[i].cuda;
                return true;
            }
    return false;
}

static void egl_close(void *state)
{
    struct egl *egl = state;
    if (!egl)
        return;
    if (egl->context != EGL_NO_CONTEXT)
        egl->DestroyContext(egl->display, egl->context);
    if (egl->display != EGL_NO_DISPLAY)
        egl->Terminate(egl->display);
    if (egl->ReleaseThread)
        egl->ReleaseThread();
    free(egl);
}

static enum status egl_open(void **state, int cuda, struct error *e)
{
    char why[500] = "";
    enum status status;
    struct egl *egl = calloc(1, sizeof *egl);
    if (!egl)
        return error_set(e, STATUS_RUN, "out of memory");
    egl->cuda = -1;
    status = library_open(egl, e);
    if (status == STATUS_OK && !devices_open(egl, cuda, why, sizeof why) &&
        !display_open(egl, EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, "surfaceless", why,
                      sizeof why))
        status = error_set(e, STATUS_BACKEND, "no OpenGL 3.3 core context (%s); install a GPU "
                                              "driver or the Debian package libgl1-mesa-dri", why);
    if (status != STATUS_OK) {
        egl_close(egl);
        egl = NULL;
    }
    *state = egl;
    return status;
}

static enum status egl_bind(void *state, struct error *e)
{
    struct egl *egl = state;
    egl->BindAPI(EGL_OPENGL_API);
    if (egl->MakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl->context))
        return STATUS_OK;
    return error_set(e, STATUS_BACKEND, "EGL context is lost: error 0x%04x",
                     (unsigned)egl->GetError());
}

static void egl_unbind(void *state)
{
    struct egl *egl = state;
    egl->MakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

static void *egl_getproc(void *state, const char *name)
{
    struct egl *egl = state;
    __eglMustCastToProperFunctionPointerType function = egl->GetProcAddress(name);
    void *address;
    memcpy(&address, &function, sizeof address);
    return address;
}

static int egl_cuda(void *state)
{
    return ((struct egl *)state)->cuda;
}

#else
#define egl_open NULL
#define egl_bind NULL
#define egl_unbind NULL
#define egl_getproc NULL
#define egl_cuda NULL
#define egl_close NULL
#endif

const struct gl_context_row context_egl = {
    .name = "egl",
    .open = egl_open,
    .bind = egl_bind,
    .unbind = egl_unbind,
    .getproc = egl_getproc,
    .cuda = egl_cuda,
    .close = egl_close,
};
