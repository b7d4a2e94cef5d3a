/* What is written over an image as lines and text, sharp at any size: cairo recordings. */
#ifndef BASE_VECTORS_H
#define BASE_VECTORS_H

#include "base/image.h"

/* image->plain becomes a copy of its pixels, and image->over empty. STATUS_RUN when memory is short, or
 * the build has no cairo. */
enum status vectors_start(struct image *image, struct error *e);

/* Moves both into another started image, where they must fit: from->over is gone then. */
void vectors_move(struct image *from, struct image *to, int left, int top);
void vectors_free(struct image *image);

#endif
