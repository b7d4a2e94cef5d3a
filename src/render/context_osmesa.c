/* GL context in plain memory through Mesa's OSMesa library, loaded when asked for: Mesa 25.1
 * dropped it, so it may be absent where the program runs. */
#include "render/context.h"

#if HAVE_OSMESA

#include <GL/osmesa.h>

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

/* X(result, name without OSMesa, arguments) */
#define OSMESA_FUNCTIONS(X)                                                                        \
    X(OSMesaContext, CreateContextAttribs, (const int *, OSMesaContext))                           \
    X(void, DestroyContext, (OSMesaContext))                                                       \
    X(GLboolean, MakeCurrent, (OSMesaContext, void *, GLenum, GLsizei, GLsizei))                   \
    X(OSMESAproc, GetProcAddress, (const char *))

enum { SIDE = 16 }; /* of the colour buffer it insists on; frames go to a framebuffer object */

struct osmesa {
    void *library;
    OSMesaContext context;
    unsigned char buffer[SIDE * SIDE * 4];
#define X(result, name, args) result(*name) args;
    OSMESA_FUNCTIONS(X)
#undef X
};

static enum status library_open(struct osmesa *o, struct error *e)
{
    static const char *const names[] = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
    void *address;
    for (size_t i = 0; !o->library && i < sizeof names / sizeof names[0]; i++)
        o->library = dlopen(names[i], RTLD_NOW | RTLD_LOCAL);
    if (!o->library)
        return error_set(e, STATUS_BACKEND, "%s (Debian package libosmesa6)", dlerror());
#define X(result, name, args)                                                                      \
    address = dlsym(o->library, "OSMesa" #name);                                                   \
    if (!address)                                                                                  \
        return error_set(e, STATUS_BACKEND, "libOSMesa is too old: no OSMesa" #name);              \
    memcpy(&o->name, &address, sizeof address);
    OSMESA_FUNCTIONS(X)
#undef X
    return STATUS_OK;
}

static void osmesa_close(void *state)
{
    struct osmesa *o = state;
    if (!o)
        return;
    if (o->context)
        o->DestroyContext(o->context);
    free(o); /* the library stays loaded, as with EGL */
}

static enum status osmesa_open(void **state, int cuda, struct error *e)
{
    static const int core[] = {OSMESA_FORMAT, OSMESA_RGBA, OSMESA_PROFILE, OSMESA_CORE_PROFILE,
                               OSMESA_CONTEXT_MAJOR_VERSION, 3, OSMESA_CONTEXT_MINOR_VERSION, 3,
                               0};
    enum status status;
    struct osmesa *o = calloc(1, sizeof *o);
    (void)cuda;
    if (!o)
        return error_set(e, STATUS_RUN, "out of memory");
    status = library_open(o, e);
    if (status == STATUS_OK) {
        o->context = o->CreateContextAttribs(core, NULL);
        if (!o->context)
            status = error_set(e, STATUS_BACKEND, "libOSMesa has no OpenGL 3.3 core profile");
    }
    if (status != STATUS_OK) {
        osmesa_close(o);
        o = NULL;
    }
    *state = o;
    return status;
}

static enum status osmesa_bind(void *state, struct error *e)
{
    struct osmesa *o = state;
    if (o->MakeCurrent(o->context, o->buffer, GL_UNSIGNED_BYTE, SIDE, SIDE))
        return STATUS_OK;
    return error_set(e, STATUS_BACKEND, "OSMesaMakeCurrent failed");
}

static void osmesa_unbind(void *state)
{
    struct osmesa *o = state;
    o->MakeCurrent(NULL, NULL, GL_UNSIGNED_BYTE, 0, 0);
}

static void *osmesa_getproc(void *state, const char *name)
{
    struct osmesa *o = state;
    OSMESAproc function = o->GetProcAddress(name);
    void *address;
    memcpy(&address, &function, sizeof address);
    return address;
}

static int osmesa_cuda(void *state)
{
    (void)state;
    return -1;
}

#else
#define osmesa_open NULL
#define osmesa_bind NULL
#define osmesa_unbind NULL
#define osmesa_getproc NULL
#define osmesa_cuda NULL
#define osmesa_close NULL
#endif

const struct gl_context_row context_osmesa = {
    .name = "osmesa",
    .open = osmesa_open,
    .bind = osmesa_bind,
    .unbind = osmesa_unbind,
    .getproc = osmesa_getproc,
    .cuda = osmesa_cuda,
    .close = osmesa_close,
};
