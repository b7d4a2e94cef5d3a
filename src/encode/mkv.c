/* Encoder "mkv": Matroska, which holds any codec, also lossless ones. */
#include "encode/video.h"

static const struct container container = {
    .muxer = "matroska",
    .codecs = (const char *const[]){"h264", "av1", "mpeg4", "ffv1", NULL},
    .chooses = true,
    .formats = true,
};

extern const struct encoder_row encoder_mkv;
const struct encoder_row encoder_mkv = {
    .variant = {.name = "mkv",
                .doc = "a film x.mkv, of any movie.codec, lossless too; H.264 by libx264 "
                       "unless one is said",
                .missing = VIDEO_MISSING},
    .extensions = (const char *const[]){".mkv", NULL},
    .container = &container,
    VIDEO_FUNCTIONS,
};
