/* Places for frames on a device, and their copies on the host for renderers that draw there. */
#include "render/slots.h"

#include <string.h>

enum { PLACE = 3 * sizeof(float), WORD = sizeof(uint32_t) };

static enum status slot_open(struct slots *s, struct render_slot *slot, struct error *e)
{
    const struct device_row *row = s->source.row;
    const size_t count = s->source.count;
    slot->to.position = row->create(s->device, "frames", count * PLACE, e);
    slot->to.word = slot->to.position ? row->create(s->device, "frames", count * WORD, e) : NULL;
    slot->filled = slot->to.word ? row->event(s->device, e) : NULL;
    return slot->filled ? STATUS_OK : e->status;
}

enum status slots_open(struct slots *s, const struct render_source *source, struct error *e)
{
    memset(s, 0, sizeof *s);
    s->source = *source;
    enum status status = source->row->open(&s->device, source->device, e);
    for (int k = 0; k < RENDER_SLOTS && !status; k++)
        status = slot_open(s, &s->slot[k], e);
    if (!status) /* what create has queued is not to come after a frame */
        status = source->row->wait(s->device, e);
    if (status)
        slots_close(s);
    return status;
}

static enum status copies_open(struct slots *s, struct error *e)
{
    const struct device_row *row = s->source.row;
    s->position = row->pin(s->device, s->source.count * PLACE, e);
    s->word = s->position ? row->pin(s->device, s->source.count * WORD, e) : NULL;
    return s->word ? STATUS_OK : e->status;
}

enum status slots_copy(struct slots *s, struct render_frame *frame, bool solid, struct error *e)
{
    const struct device_row *row = s->source.row;
    const struct render_slot *slot = frame->slot;
    if (!s->word && copies_open(s, e))
        return e->status;
    row->follow(s->device, slot->filled);
    if (row->read(s->device, s->position, slot->to.position, frame->count * PLACE, e) ||
        row->read(s->device, s->word, slot->to.word, frame->count * WORD, e))
        return e->status;
    frame->position = s->position;
    frame->value = solid ? NULL : (const float *)s->word;
    frame->color = solid ? (const uint8_t *)s->word : NULL;
    frame->slot = NULL;
    return STATUS_OK;
}

/* Frames that were not drawn may still be on their way into slots. */
static void slots_wait(struct slots *s)
{
    struct error ignored;
    for (int k = 0; k < RENDER_SLOTS; k++)
        if (s->slot[k].filled)
            s->source.row->follow(s->device, s->slot[k].filled);
    s->source.row->wait(s->device, &ignored);
}

void slots_close(struct slots *s)
{
    const struct device_row *row = s->source.row;
    if (s->device) {
        slots_wait(s);
        for (int k = 0; k < RENDER_SLOTS; k++) {
            row->destroy(s->device, s->slot[k].to.position);
            row->destroy(s->device, s->slot[k].to.word);
            if (s->slot[k].filled)
                row->drop(s->device, s->slot[k].filled);
        }
        row->unpin(s->device, s->position);
        row->unpin(s->device, s->word);
        row->close(s->device);
    }
    memset(s, 0, sizeof *s);
}
