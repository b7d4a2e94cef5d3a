/* Sprites whose particles a device writes into OpenGL's buffer, without the host. */
#ifndef RENDER_SPRITES_DEVICE_H
#define RENDER_SPRITES_DEVICE_H

#include "render/slots.h"
#include "render/sprites.h"

struct sprites_device {
    const struct slots *slots;    /* NULL: not in use */
    struct device_buffer *buffer; /* of the sprites */
};

/* Gives the sprites a buffer for the slots' frames, once, for the device to write to. STATUS_BACKEND says why the
 * device cannot, and then the sprites are as before. The context is current here and in the next two. */
enum status sprites_device_open(struct sprites_device *device, struct sprites *sprites, struct gl *gl,
                                const struct slots *slots, struct error *e);

/* Has the device write a slot's frame for the next sprites_draw, when it is there. */
enum status sprites_device_prepare(struct sprites_device *device, struct sprites *sprites,
                                   const struct render_setup *setup, const struct render_frame *frame,
                                   struct error *e);

void sprites_device_close(struct sprites_device *device); /* of what was zeroed, too */

/* The largest distance along the camera's axis of any particle's far end, m; 0 if none is in front. */
double sprites_device_reach(const struct sprites_device *device, const struct camera *camera, double radius);

#endif
