/* Buffers of OpenGL that devices write to. */
#ifndef RENDER_SHARED_BUFFER_H
#define RENDER_SHARED_BUFFER_H

#include "device/device.h"
#include "render/gl.h"

/* The buffer as devices take it; `gl` must stay, and the context be current whenever it is used. What a buffer
 * had is lost when the host maps it. */
struct device_gl shared_buffer_of(struct gl *gl, GLuint name, size_t bytes);

#endif
