/* Encoder "apng": lossless films that repeat, for browsers. */
#include "encode/video.h"

static const struct container container = {
    .muxer = "apng",
    .options = {"plays", "0"},
    .codecs = (const char *const[]){"apng", NULL},
};

extern const struct encoder_row encoder_apng;
const struct encoder_row encoder_apng = {
    .variant = {.name = "apng",
                .doc = "a film x.apng that repeats, lossless",
                .missing = VIDEO_MISSING},
    .extensions = (const char *const[]){".apng", NULL},
    .container = &container,
    VIDEO_FUNCTIONS,
};
