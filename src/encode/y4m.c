/* Encoder "y4m": plain pictures for other programs, to a file or to standard output. */
#include "encode/video.h"

static const struct container container = {
    .muxer = "yuv4mpegpipe",
    .options = {"strict", "unofficial"}, /* more than 8 bits */
    .codecs = (const char *const[]){"raw", NULL},
    .formats = true,
};

extern const struct encoder_row encoder_y4m;
const struct encoder_row encoder_y4m = {
    .variant = {.name = "y4m",
                .doc = "a film x.y4m that is not compressed; - writes it to standard output",
                .missing = VIDEO_MISSING},
    .extensions = (const char *const[]){".y4m", "-", NULL},
    .container = &container,
    VIDEO_FUNCTIONS,
};
