/* Encoder "mp4": fragments that survive a crash while the film grows, then the index first. */
#include "encode/video.h"

static const struct container container = {
    .muxer = "mp4",
    .options = {"movflags", "frag_keyframe+empty_moov+default_base_moof"},
    .final_options = {"movflags", "+faststart"},
    .codecs = (const char *const[]){"h264", "av1", "mpeg4", NULL},
    .chooses = true,
    .formats = true,
};

extern const struct encoder_row encoder_mp4;
const struct encoder_row encoder_mp4 = {
    .variant = {.name = "mp4",
                .doc = "a film x.mp4: H.264 by libx264, else the next codec that opens, or movie.codec",
                .missing = VIDEO_MISSING},
    .extensions = (const char *const[]){".mp4", NULL},
    .container = &container,
    VIDEO_FUNCTIONS,
};
