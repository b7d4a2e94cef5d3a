/* Encoder "pfm": raw numbers of pixels as floats, x.depth.pfm, x.value.pfm or x.id.pfm, numbered or one.
 *
 * Portable float map, little-endian, lower row first. Frames wait as NAME.new until close. */
#include "base/memory.h"
#include "base/output.h"
#include "base/sequence.h"
#include "encode/encode.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct encoder {
    struct sequence names;
    enum raw_plane plane;
    float *line;
    long *frames;    /* numbers of those that wait */
    size_t count, room;
};

static const char *const planes[RAW_PLANES] = {
    [RAW_DEPTH] = ".depth.pfm", [RAW_VALUE] = ".value.pfm", [RAW_ID] = ".id.pfm"};

static enum status read_names(struct encoder *encoder, const struct encode_target *target,
                              struct error *e)
{
    const char *path = target->path;
    size_t length = strlen(path);
    bool known = false;
    for (int k = 0; k < RAW_PLANES && !known; k++) {
        size_t own = strlen(planes[k]);
        known = length > own && strcmp(path + length - own, planes[k]) == 0;
        encoder->plane = (enum raw_plane)k;
    }
    if (!known)
        return error_set(e, STATUS_USAGE, "output \"%s\": a raw image is x.depth.pfm, x.value.pfm or "
                         "x.id.pfm", path);
    if (sequence_read(&encoder->names, "output", path, e))
        return e->status;
    if (!encoder->names.digits && !target->single)
        return error_set(e, STATUS_USAGE, "output \"%s\": each frame would replace the one before; "
                         "write for example x-%%04d%s, or ask for one frame with --at T", path,
                         planes[encoder->plane]);
    return STATUS_OK;
}

static enum status pfm_check(const struct encode_target *target, struct error *e)
{
    struct encoder encoder = {0};
    return read_names(&encoder, target, e);
}

static void encoder_free(struct encoder *encoder)
{
    free(encoder->line);
    free(encoder->frames);
    memory_free(encoder);
}

static enum status pfm_open(struct encoder **made, const struct encode_target *target, struct error *e)
{
    struct encoder *encoder = memory_create("encoder", 1, sizeof *encoder, e);
    *made = NULL;
    if (!encoder)
        return e->status;
    encoder->line = calloc((size_t)target->width, sizeof *encoder->line);
    if (!encoder->line)
        error_set(e, STATUS_RUN, "%s: no memory", target->path);
    else if (read_names(encoder, target, e) == STATUS_OK) {
        *made = encoder;
        return STATUS_OK;
    }
    encoder_free(encoder);
    return e->status;
}

/* The waiting frame's name. */
static void staged_name(const struct encoder *encoder, long index, char name[SEQUENCE_NAME + 8])
{
    sequence_name(&encoder->names, index, name, SEQUENCE_NAME);
    strcat(name, ".new");
}

static enum status note(struct encoder *encoder, long index, struct error *e)
{
    if (encoder->count == encoder->room) {
        size_t room = 2 * encoder->room + 16;
        long *grown = realloc(encoder->frames, room * sizeof *grown);
        if (!grown)
            return error_set(e, STATUS_RUN, "pfm: no memory to note frame %ld", index);
        encoder->frames = grown;
        encoder->room = room;
    }
    encoder->frames[encoder->count++] = index;
    return STATUS_OK;
}

static enum status pfm_frame(struct encoder *encoder, const struct encode_frame *frame, struct error *e)
{
    const struct image *image = frame->image;
    struct output_file file = {0};
    char name[SEQUENCE_NAME + 8];
    staged_name(encoder, frame->index, name);
    if (!image->raw)
        return error_set(e, STATUS_RUN, "%s: this picture has no raw numbers; a sheet has none", name);
    if (output_open(&file, name, e))
        return e->status;
    fprintf(file.stream, "Pf\n%d %d\n-1.0\n", image->width, image->height);
    for (int y = image->height - 1; y >= 0; y--) {
        const float *raw = image->raw + (size_t)y * (size_t)image->width * RAW_PLANES + encoder->plane;
        for (int x = 0; x < image->width; x++)
            encoder->line[x] = raw[(size_t)x * RAW_PLANES];
        fwrite(encoder->line, sizeof *encoder->line, (size_t)image->width, file.stream);
    }
    if (output_close(&file, true, e))
        return e->status;
    return note(encoder, frame->index, e);
}

static enum status pfm_close(struct encoder *encoder, bool keep, struct error *e)
{
    enum status status = STATUS_OK;
    char name[SEQUENCE_NAME], staged[SEQUENCE_NAME + 8];
    for (size_t i = 0; i < encoder->count; i++) {
        sequence_name(&encoder->names, encoder->frames[i], name, sizeof name);
        staged_name(encoder, encoder->frames[i], staged);
        if (!keep)
            unlink(staged);
        else if (rename(staged, name))
            status = error_set(e, STATUS_OUTPUT, "%s: %s", name, strerror(errno));
    }
    encoder_free(encoder);
    return status;
}

extern const struct encoder_row encoder_pfm;
const struct encoder_row encoder_pfm = {
    .variant = {.name = "pfm",
                .doc = "what pixels show as floats: x.depth.pfm (m), x.value.pfm, x.id.pfm; renderer cpu"},
    .extensions = (const char *const[]){".pfm", NULL},
    .wants_pixels = true,
    .wants_raw = true,
    .check = pfm_check,
    .open = pfm_open,
    .frame = pfm_frame,
    .close = pfm_close,
};
