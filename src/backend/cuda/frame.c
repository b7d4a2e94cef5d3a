/* What leaves the device with a frame: what pictures show, in memory of the device, and the state's hash. */
#include "backend/cuda/cuda.h"
#include "particles/hash.h"

/* Values that never change are uploaded with the first frame. */
static enum status fixed_upload(struct backend *b, const float *fixed, struct error *e)
{
    if (!fixed || b->fixed)
        return STATUS_OK;
    b->fixed = cuda_array(b, "colours", b->particles.count, sizeof *b->fixed, e);
    return b->fixed ? cuda_upload(b, b->fixed, fixed, b->particles.count * sizeof *b->fixed, e) : e->status;
}

enum status cuda_show(struct backend *b, const struct shown *how, struct device_event *filled,
                      struct error *e)
{
    struct shown s = *how;
    if (fixed_upload(b, how->fixed, e))
        return e->status;
    shown_from(&s, &b->particles, &b->wall);
    s.fixed = b->fixed;
    cuda_flush(b);
    cuda_launch(b, KERNEL_frame_show, s.count + s.wall_count, &s);
    return b->row->signal(b->device, filled, e);
}

enum status cuda_hash(struct backend *b, uint64_t *hash, struct error *e)
{
    const struct particles *p = &b->particles;
    const struct hash_work w = {p->now[FIELD_POSITION], p->now[FIELD_MOTION], p->now[FIELD_DENSITY],
                                p->now[FIELD_ID], b->hash};
    cuda_flush(b);
    b->row->clear(b->device, b->hash, sizeof *b->hash);
    cuda_launch(b, KERNEL_frame_hash, p->count, &w);
    if (b->row->read(b->device, b->hash_read, b->hash, sizeof *b->hash_read, e))
        return e->status;
    *hash = *b->hash_read + hash_mix(p->count);
    return STATUS_OK;
}
