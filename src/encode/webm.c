/* Encoder "webm": films for browsers. */
#include "encode/video.h"

static const struct container container = {
    .muxer = "webm",
    .codecs = (const char *const[]){"vp9", "av1", "av1-aom", NULL},
    .chooses = true,
    .formats = true,
};

extern const struct encoder_row encoder_webm;
const struct encoder_row encoder_webm = {
    .variant = {.name = "webm",
                .doc = "a film x.webm: VP9 by libvpx, else AV1, or movie.codec",
                .missing = VIDEO_MISSING},
    .extensions = (const char *const[]){".webm", NULL},
    .container = &container,
    VIDEO_FUNCTIONS,
};
