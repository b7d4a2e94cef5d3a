/* How the host writes to buffers of OpenGL. */
#include "render/shared_buffer.h"

/* By a target of its own, so that what is bound for drawing stays bound. */
static void *buffer_map(void *context, unsigned name, size_t bytes)
{
    const struct gl *gl = context;
    gl->BindBuffer(GL_COPY_WRITE_BUFFER, name);
    void *block = gl->MapBufferRange(GL_COPY_WRITE_BUFFER, 0, (GLsizeiptr)bytes,
                                     GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
    gl->BindBuffer(GL_COPY_WRITE_BUFFER, 0);
    return block;
}

static bool buffer_unmap(void *context, unsigned name)
{
    const struct gl *gl = context;
    gl->BindBuffer(GL_COPY_WRITE_BUFFER, name);
    bool kept = gl->UnmapBuffer(GL_COPY_WRITE_BUFFER);
    gl->BindBuffer(GL_COPY_WRITE_BUFFER, 0);
    return kept;
}

struct device_gl shared_buffer_of(struct gl *gl, GLuint name, size_t bytes)
{
    return (struct device_gl){.name = name, .bytes = bytes, .map = buffer_map, .unmap = buffer_unmap,
                              .context = gl};
}
