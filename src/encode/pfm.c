/* Encoder "pfm": raw numbers of pixels as floats, x.depth.pfm, x.value.pfm or x.id.pfm, numbered or one.
 *
 * Portable float map, little-endian, lower row first. Frames wait as NAME.new until close. */
#include "base/memory.h"
#include "encode/numbered.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct encoder {
    struct numbered files;
    enum raw_plane plane;
    float *line;
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
    return numbered_names(&encoder->files.names, target, planes[encoder->plane], e);
}

static enum status pfm_check(const struct encode_target *target, struct error *e)
{
    struct encoder encoder = {0};
    return read_names(&encoder, target, e);
}

static void encoder_free(struct encoder *encoder)
{
    free(encoder->line);
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

static enum status pfm_frame(struct encoder *encoder, const struct encode_frame *frame, struct error *e)
{
    const struct image *image = frame->image;
    struct output_file file;
    if (!image->raw)
        return error_set(e, STATUS_RUN, "pfm: this picture has no raw numbers; a sheet has none");
    if (numbered_open(&encoder->files, frame->index, &file, e))
        return e->status;
    fprintf(file.stream, "Pf\n%d %d\n-1.0\n", image->width, image->height);
    for (int y = image->height - 1; y >= 0; y--) {
        const float *raw = image->raw + (size_t)y * (size_t)image->width * RAW_PLANES + encoder->plane;
        for (int x = 0; x < image->width; x++)
            encoder->line[x] = raw[(size_t)x * RAW_PLANES];
        fwrite(encoder->line, sizeof *encoder->line, (size_t)image->width, file.stream);
    }
    return numbered_close(&encoder->files, frame->index, &file, true, e);
}

static enum status pfm_close(struct encoder *encoder, bool keep, struct error *e)
{
    enum status status = numbered_end(&encoder->files, keep, e);
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
