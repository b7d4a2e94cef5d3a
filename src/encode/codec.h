/* The video codecs that films may use, and how they are opened. */
#ifndef ENCODE_CODEC_H
#define ENCODE_CODEC_H

#include "encode/container.h"
#include "encode/encode.h"

#include <stdbool.h>

struct AVCodecContext;

struct codec_option {
    const char *key, *value;
    bool avx512; /* only on a processor with AVX-512 */
};

struct codec_row {
    struct variant variant;          /* name as movie.codec has it */
    const char *encoder;             /* as libavcodec calls it */
    int threads;                     /* fixed: the file must not depend on the machine */
    const char *tag;                 /* four letters in an mp4 file; NULL: the usual ones */
    const char *pixel_format;        /* unless movie.pixel_format says another */
    const char *crf, *preset, *tune; /* the encoder's options for movie.crf and so on; NULL: none */
    int least_crf;                   /* a lower movie.crf would mean something else to the encoder */
    int least_size[2];               /* of a GPU's encoder: pixels, after padding */
    /* Of a GPU's encoder: the row that does as much without one. Only movie.codec chooses such a row,
     * since its files depend on the machine, and it is tried before a run. Else NULL. */
    const char *without_gpu;
    struct codec_option options[5];  /* ended by a NULL key; an unknown one is an error */
};

extern const struct variant_table codec_table; /* "codecs" */

struct codec_picture {
    int width, height; /* pixels, before padding to what the pixel format needs */
    int rate[2];       /* frames per second as a fraction */
};

/* Sets one codec up, up to opening it: BT.709 and limited range, or RGB; time in frames; sides padded
 * to whole chroma pixels. STATUS_BACKEND with the bare reason; STATUS_USAGE when `video` asks for what
 * the codec lacks, with what it has. Free with avcodec_free_context. */
enum status codec_prepare(struct AVCodecContext **context, const struct codec_row *row,
                          const struct codec_picture *picture, const struct encode_video *video,
                          struct error *e);

/* Prepares and opens one codec; STATUS_USAGE, too, when a GPU's encoder opens for other pictures, but
 * not for these. Free with codec_close. `context` NULL: only looks whether it could, which takes a
 * trial of a GPU's encoder and no opening of another. */
enum status codec_try(struct AVCodecContext **context, const struct codec_row *row,
                      const struct codec_picture *picture, const struct encode_video *video,
                      struct error *e);

/* Opens the codec that `video` names, or the first of the container's that opens; the message of
 * STATUS_BACKEND has each one's reason. `context` as above. */
enum status codec_open(struct AVCodecContext **context, const struct container *container,
                       const struct codec_picture *picture, const struct encode_video *video,
                       struct error *e);

/* Ends the stream, drops what is still inside, frees and forgets the codec; NULL inside is allowed.
 * `used`: a frame has been sent to it. */
void codec_close(struct AVCodecContext **context, bool used);

#endif
