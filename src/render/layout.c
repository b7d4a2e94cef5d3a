/* Places of text and marks over a picture, so that no two meet. */
#include "render/layout.h"

#include <stddef.h>

void layout_take(struct layout *layout, const struct layout_box *box)
{
    if (layout->count < LAYOUT_BOXES)
        layout->taken[layout->count++] = *box;
}

/* The first taken box that is nearer than the gap. */
static const struct layout_box *meets(const struct layout *l, const struct layout_box *box)
{
    for (int i = 0; i < l->count; i++) {
        const struct layout_box *t = &l->taken[i];
        if (box->x < t->x + t->width + l->gap && t->x < box->x + box->width + l->gap &&
            box->y < t->y + t->height + l->gap && t->y < box->y + box->height + l->gap)
            return t;
    }
    return NULL;
}

bool layout_place(struct layout *l, enum label_place at, double width, double height,
                  struct layout_box *box)
{
    static const double slack = 1e-6;
    bool top = at <= LABEL_TOP_RIGHT;
    int column = (int)at % 3; /* left, middle, right */
    const struct layout_box *other;
    box->width = width;
    box->height = height;
    box->x = l->side + column * (l->width - 2 * l->side - width) / 2;
    box->y = top ? l->end : l->height - l->end - height;
    while ((other = meets(l, box)))
        box->y = top ? other->y + other->height + l->gap + slack
                     : other->y - l->gap - height - slack;
    if (l->count == LAYOUT_BOXES || box->y < 0 || box->y + height > l->height || box->x < 0)
        return false;
    layout_take(l, box);
    return true;
}
