/* Places of text and marks over a picture, so that no two meet. */
#ifndef RENDER_LAYOUT_H
#define RENDER_LAYOUT_H

#include "scene/scene.h"

#include <stdbool.h>

struct layout_box {
    double x, y, width, height; /* pixels, upper left first */
};

enum { LAYOUT_BOXES = 64 };

struct layout {
    double width, height;     /* of the picture, pixels */
    double side, end, gap;    /* free pixels at the sides, above and below, and between boxes */
    struct layout_box taken[LAYOUT_BOXES];
    int count;
};

/* Marks a box as taken. */
void layout_take(struct layout *layout, const struct layout_box *box);

/* Finds and takes a place: at `at`, or the nearest below it (above, at the bottom) that is free. False
 * when there is none. */
bool layout_place(struct layout *layout, enum label_place at, double width, double height,
                  struct layout_box *box);

#endif
