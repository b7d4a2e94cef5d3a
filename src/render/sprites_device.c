/* Sprites whose particles a device writes into OpenGL's buffer, without the host. */
#include "render/sprites_device.h"

#include "render/cuda/draw_kernels.h"
#include "render/shared_buffer.h"

#include <math.h>

enum status sprites_device_open(struct sprites_device *d, struct sprites *s, struct gl *gl,
                                const struct slots *slots, struct error *e)
{
    const struct render_source *source = &slots->source;
    const size_t bytes = source->count * sizeof *s->packed;
    if (!source->kernels)
        return error_set(e, STATUS_BACKEND, "the device has no kernels for it");
    if (source->count > s->chunk || source->count == 0)
        return error_set(e, STATUS_BACKEND, "%zu particles do not go into one buffer of OpenGL, which takes %zu",
                         source->count, s->chunk);
    gl->BindBuffer(GL_TEXTURE_BUFFER, s->buffer);
    gl->BufferData(GL_TEXTURE_BUFFER, (GLsizeiptr)bytes, NULL, GL_STREAM_DRAW);
    if (gl_check(gl, "while making memory for particles", e))
        return e->status;
    const struct device_gl shared = shared_buffer_of(gl, s->buffer, bytes);
    d->buffer = source->row->attach(slots->device, &shared, e);
    if (!d->buffer)
        return e->status;
    d->slots = slots;
    return STATUS_OK;
}

enum status sprites_device_prepare(struct sprites_device *d, struct sprites *s, const struct render_setup *setup,
                                   const struct render_frame *frame, struct error *e)
{
    const struct render_source *source = &d->slots->source;
    struct device *device = d->slots->device;
    struct draw_work w = {.position = frame->slot->to.position, .word = frame->slot->to.word,
                          .values = !setup->solid, .scale = frame->scale ? *frame->scale : setup->scale};
    source->row->follow(device, frame->slot->filled);
    w.packed = source->row->map(device, d->buffer, e);
    if (!w.packed)
        return e->status;
    source->row->launch(device, &source->kernels[DRAW_pack], frame->count, &w);
    s->is_filled = true;
    return source->row->unmap(device, d->buffer, e);
}

void sprites_device_close(struct sprites_device *d)
{
    if (d->buffer)
        d->slots->source.row->detach(d->slots->device, d->buffer);
    *d = (struct sprites_device){0};
}

double sprites_device_reach(const struct sprites_device *d, const struct camera *camera, double radius)
{
    const struct render_source *source = &d->slots->source;
    double far = 0;
    for (int corner = 0; corner < 8; corner++) {
        double point[3], view[3];
        for (int a = 0; a < 3; a++)
            point[a] = corner >> a & 1 ? source->high[a] : source->low[a];
        camera_view(camera, point, view);
        far = fmax(far, view[2]);
    }
    return far > 0 ? far + radius : 0;
}
