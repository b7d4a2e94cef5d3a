/* An OpenGL 3.3 core context without a window. */
#ifndef RENDER_CONTEXT_H
#define RENDER_CONTEXT_H

#include "base/error.h"

#include <stddef.h>

#if HAVE_EGL
#define EGL_MISSING NULL
#else
#define EGL_MISSING "build with make EGL=1 (Debian packages libegl-dev and libgl-dev)"
#endif
#if HAVE_OSMESA
#define OSMESA_MISSING NULL
#else
#define OSMESA_MISSING "build with make OSMESA=1 (Debian package libosmesa6-dev)"
#endif

struct gl_context_row {
    const char *name;
    /* Makes a context, not yet current, on the GPU that is CUDA device number `cuda` if it can be had there;
     * -1: on any. STATUS_BACKEND says what was tried. */
    enum status (*open)(void **state, int cuda, struct error *e);
    /* Makes it current on this thread, and releases it again: around every use, so that contexts
     * of different libraries can take turns on one thread. */
    enum status (*bind)(void *state, struct error *e);
    void (*unbind)(void *state);
    void *(*getproc)(void *state, const char *name);
    int (*cuda)(void *state); /* number of the CUDA device that it draws on; -1: of none, or unknown */
    void (*close)(void *state); /* accepts NULL; the context must not be current */
};

extern const struct gl_context_row context_egl, context_osmesa;

#endif
