/* The video codecs that an mp4 film may use, in preference order. */
#ifndef ENCODE_MP4_CODEC_H
#define ENCODE_MP4_CODEC_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>

struct AVCodecContext;

struct mp4_option {
    const char *key, *value;
    bool avx512; /* only on a processor with AVX-512 */
};

struct mp4_codec {
    const char *name;             /* as libavcodec calls it */
    int threads;                  /* fixed: the file must not depend on the machine */
    struct mp4_option options[5]; /* ended by a NULL key; an unknown one is an error */
};

extern const struct mp4_codec mp4_codecs[];
extern const size_t mp4_codec_count;

struct mp4_picture {
    int width, height;      /* pixels, even */
    int rate[2];            /* frames per second as a fraction */
};

/* Opens one codec: yuv420p, BT.709, limited range, time in frames; STATUS_BACKEND with the bare
 * reason. Free with mp4_codec_close. */
enum status mp4_codec_try(struct AVCodecContext **context, const struct mp4_codec *codec,
                          const struct mp4_picture *picture, struct error *e);

/* Opens the first codec that can be opened; the message of STATUS_BACKEND has each one's reason. */
enum status mp4_codec_open(struct AVCodecContext **context, const struct mp4_picture *picture,
                           struct error *e);

/* Ends the stream, drops what is still inside, frees and forgets the codec; NULL inside is allowed.
 * `used`: a frame has been sent to it. */
void mp4_codec_close(struct AVCodecContext **context, bool used);

#endif
