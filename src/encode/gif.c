/* Encoder "gif": films that repeat, for web pages and slides, in 256 colours. */
#include "encode/video.h"

static const struct container container = {
    .muxer = "gif",
    .codecs = (const char *const[]){"gif", NULL},
};

extern const struct encoder_row encoder_gif;
const struct encoder_row encoder_gif = {
    .variant = {.name = "gif",
                .doc = "a film x.gif that repeats, 256 colours",
                .missing = VIDEO_MISSING},
    .extensions = (const char *const[]){".gif", NULL},
    .container = &container,
    VIDEO_FUNCTIONS,
};
