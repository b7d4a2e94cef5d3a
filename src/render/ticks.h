/* Where a colour bar has ticks, and what they say. */
#ifndef RENDER_TICKS_H
#define RENDER_TICKS_H

#include "render/render.h"

enum { TICKS_MAX = 272, TICK_TEXT = 40 };

struct ticks {
    struct {
        double part;          /* place on the bar, 0..1 */
        char text[TICK_TEXT + 4]; /* "": a small tick */
    } items[TICKS_MAX];
    int count;
    int exponent; /* of ten, a multiple of 3, that the texts leave to the unit */
};

/* At most `most` texts. None when the range is empty or not finite. */
void ticks_make(struct ticks *ticks, const struct render_setup *setup,
                const struct color_scale *scale, int most);

/* "speed (m/s)", "pressure (10^3 Pa)" with the exponent raised. */
void ticks_name(const struct ticks *ticks, const struct render_setup *setup, char *text,
                size_t size);

/* The largest of 1, 2 and 5 times a power of ten that is not above `most`. */
double ticks_round(double most);

#endif
