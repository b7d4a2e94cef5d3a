/* Encoder "hash": one line per frame on stdout, "index time state-hash pixel-hash". */
#include "base/fnv.h"
#include "encode/encode.h"

#include <endian.h>
#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

/* FNV-1a over 64-bit little-endian words instead of bytes, with a shift so that
 * high bits reach low ones; the size is hashed last. */
static uint64_t hash_bytes(const uint8_t *bytes, size_t size)
{
    uint64_t hash = FNV_START;
    for (size_t i = 0; i < size; i += 8) {
        uint64_t word = 0;
        memcpy(&word, bytes + i, size - i < 8 ? size - i : 8);
        hash = (hash ^ le64toh(word)) * FNV_PRIME;
        hash ^= hash >> 32;
    }
    hash = (hash ^ size) * FNV_PRIME;
    return hash ^ hash >> 32;
}

static enum status hash_open(struct encoder **encoder, const struct encode_target *target,
                             struct error *e)
{
    (void)target;
    (void)e;
    *encoder = NULL;
    return STATUS_OK;
}

static enum status flush(struct error *e)
{
    if (fflush(stdout) || ferror(stdout))
        return error_set(e, STATUS_OUTPUT, "cannot write frame hashes to standard output: %s",
                         strerror(errno));
    return STATUS_OK;
}

static enum status hash_frame(struct encoder *encoder, const struct encode_frame *frame,
                              struct error *e)
{
    (void)encoder;
    const struct image *image = frame->image;
    size_t size = (size_t)image->width * (size_t)image->height * 4;
    printf("%ld %.9g %016" PRIx64 " %016" PRIx64 "\n", frame->index, frame->time,
           frame->state_hash, hash_bytes(image->rgba, size));
    return flush(e);
}

static enum status hash_close(struct encoder *encoder, bool keep, struct error *e)
{
    (void)encoder;
    return keep ? flush(e) : STATUS_OK;
}

extern const struct encoder_row encoder_hash;
const struct encoder_row encoder_hash = {
    .variant = {.name = "hash",
                .doc = "prints \"index time state-hash pixel-hash\" for each frame on stdout"},
    .extensions = (const char *const[]){"hash", NULL},
    .wants_pixels = true,
    .wants_hashes = true,
    .open = hash_open,
    .frame = hash_frame,
    .close = hash_close,
};
