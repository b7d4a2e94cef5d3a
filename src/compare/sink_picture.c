/* Records a comparison as pictures: the differences, or both frames beside them. */
#include "base/memory.h"
#include "base/sequence.h"
#include "compare/record.h"

#include <string.h>

struct sink {
    bool single, beside;
    long number; /* of the frame, counted through all sources */
    struct sequence names;
};

static enum status picture_open(struct sink **made, const struct comparison *comparison,
                                const char *path, bool beside, struct error *e)
{
    const char *what = beside ? "--side-by-side" : "--diff";
    struct sink *sink = *made = memory_create("compare", 1, sizeof *sink, e);
    if (!sink)
        return e->status;
    sink->single = comparison->single;
    sink->beside = beside;
    e->status = STATUS_OK;
    if (sequence_read(&sink->names, what, path, e) == STATUS_OK && !sink->names.digits &&
        !sink->single)
        error_set(e, STATUS_USAGE, "%s \"%s\": each frame would replace the one before; write for "
                  "example x-%%04d.png", what, path);
    if (e->status)
        memory_free(sink);
    return e->status;
}

static enum status map_open(struct sink **made, const struct comparison *comparison,
                            const char *path, struct error *e)
{
    return picture_open(made, comparison, path, false, e);
}

static enum status side_open(struct sink **made, const struct comparison *comparison,
                             const char *path, struct error *e)
{
    return picture_open(made, comparison, path, true, e);
}

/* Copies a picture, NULL for none, to column x of a wider one. */
static void paste(struct image *out, const struct image *in, int x)
{
    for (int y = 0; in && y < in->height; y++)
        memcpy(out->rgba + 4 * ((size_t)y * (size_t)out->width + (size_t)x),
               in->rgba + 4 * (size_t)y * (size_t)in->width, 4 * (size_t)in->width);
}

static enum status join(struct image *out, const struct image *const parts[3], struct error *e)
{
    int width = 0, height = 0, x = 0;
    for (int k = 0; k < 3; k++) {
        width += parts[k] ? parts[k]->width : 0;
        height = parts[k] && parts[k]->height > height ? parts[k]->height : height;
    }
    if (image_create(out, width, height, e))
        return e->status;
    for (int k = 0; k < 3; k++) {
        paste(out, parts[k], x);
        x += parts[k] ? parts[k]->width : 0;
    }
    return STATUS_OK;
}

/* Of a set only frames that fail; of a frame without its match, or of another size, what there is. */
static enum status picture_frame(struct sink *sink, const struct verdict *verdict, struct error *e)
{
    struct image map = {0}, wide = {0};
    bool mapped = verdict->state <= VERDICT_DIFFERENT;
    char name[SEQUENCE_NAME];
    sequence_name(&sink->names, sink->number++, name, sizeof name);
    if ((!sink->single && verdict_passes(verdict->state)) || (!mapped && !sink->beside))
        return STATUS_OK;
    e->status = STATUS_OK;
    if (mapped && verdict_map(verdict, &map, e))
        return e->status;
    const struct image *parts[3] = {verdict->frame, verdict->accepted, mapped ? &map : NULL};
    if (!sink->beside || join(&wide, parts, e) == STATUS_OK)
        image_write_png(sink->beside ? &wide : &map, name, e);
    image_free(&map);
    image_free(&wide);
    return e->status;
}

static enum status picture_close(struct sink *sink, const struct tally *tally, bool keep,
                                 struct error *e)
{
    (void)tally;
    (void)keep;
    (void)e;
    memory_free(sink);
    return STATUS_OK;
}

const struct sink_row sink_map = {map_open, picture_frame, picture_close};
const struct sink_row sink_side = {side_open, picture_frame, picture_close};
