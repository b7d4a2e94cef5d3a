/* The domain's floor, faces and edges as the triangles that the cpu renderer blends. */
#ifndef RENDER_BLEND_H
#define RENDER_BLEND_H

#include "render/splat.h"
#include "render/wire.h"

struct blends {
    struct blend *blend;
    size_t count, room;
};

/* Which layers. */
enum blend_part {
    BLEND_ALL,
    BLEND_BACK, /* what is seen through a fluid */
    BLEND_OVER  /* all but what shows faintly through spheres */
};

/* Triangles of the layers, in order, for a picture of width x height samples; STATUS_RUN when memory is
 * short. */
enum status blends_make(struct blends *blends, const struct wire *wire, enum blend_part part, int width,
                        int height, struct error *e);
void blends_free(struct blends *blends);

#endif
