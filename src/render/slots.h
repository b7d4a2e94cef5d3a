/* Places for frames on a device, and their copies on the host for renderers that draw there. */
#ifndef RENDER_SLOTS_H
#define RENDER_SLOTS_H

#include "render/render.h"

struct slots {
    struct render_source source;
    struct device *device; /* a queue of its own, of the thread that draws */
    struct render_slot slot[RENDER_SLOTS];
    float *position;       /* pinned: the last slot that was copied */
    uint32_t *word;
};

/* STATUS_RUN when memory is short; then nothing stays. */
enum status slots_open(struct slots *slots, const struct render_source *source, struct error *e);

/* Waits for the frame's slot, and has the frame read it in host memory. */
enum status slots_copy(struct slots *slots, struct render_frame *frame, bool solid, struct error *e);

void slots_close(struct slots *slots); /* of what was zeroed, too */

#endif
