/* Opens sources that fit each other, and reads the frames that belong together. */
#include "compare/lineup.h"

#include <string.h>

enum status lineup_open(struct lineup *lineup, const char *const *paths, size_t count,
                        struct error *e)
{
    enum source_kind kinds[LINEUP_MAX] = {SOURCE_PICTURE};
    memset(lineup, 0, sizeof *lineup);
    for (size_t i = 0; i < count; i++)
        if (source_find(&kinds[i], paths[i], e))
            return e->status;
    if (source_order(&lineup->order, kinds, count, e))
        return e->status;
    for (; lineup->count < count; lineup->count++)
        if (source_open(&lineup->sources[lineup->count], paths[lineup->count],
                        kinds[lineup->count], lineup->order, e))
            return e->status;
    return STATUS_OK;
}

void lineup_close(struct lineup *lineup)
{
    for (size_t i = 0; i < lineup->count; i++) {
        source_close(&lineup->sources[i]);
        image_free(&lineup->images[i]);
    }
    memset(lineup, 0, sizeof *lineup);
}

const struct source *lineup_first(const struct lineup *lineup)
{
    const struct source *first = &lineup->sources[0];
    for (size_t i = 1; i < lineup->count; i++)
        if (source_compare(&lineup->sources[i], first, lineup->order) < 0)
            first = &lineup->sources[i];
    return first;
}

enum status lineup_read(struct lineup *lineup, const struct source *place,
                        const struct image *frames[LINEUP_MAX], struct error *e)
{
    const struct source fixed = *place; /* it may be one of ours */
    for (size_t i = 0; i < lineup->count; i++) {
        struct source *source = &lineup->sources[i];
        frames[i] = NULL;
        if (source_compare(source, &fixed, lineup->order) != 0)
            continue;
        frames[i] = &lineup->images[i];
        if (source->row->read(source, &lineup->images[i], e) || source->row->next(source, e))
            return e->status;
    }
    return STATUS_OK;
}
