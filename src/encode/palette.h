/* Chooses 256 colours for a picture. */
#ifndef ENCODE_PALETTE_H
#define ENCODE_PALETTE_H

#include "base/image.h"

#include <stdint.h>

enum { PALETTE_SIZE = 256 };

struct palette; /* room to work in */

struct palette *palette_create(void); /* NULL when memory is short */
void palette_free(struct palette *palette);

/* Chooses colours (0xffRRGGBB) with little error over all pixels; a picture that has no more gets its
 * own, but for differences below 4 of 255. */
void palette_choose(struct palette *palette, const struct image *image,
                    uint32_t colors[PALETTE_SIZE]);

/* Which of the colours chosen last stands for a pixel of that picture. */
uint8_t palette_index(const struct palette *palette, const uint8_t rgba[4]);

#endif
