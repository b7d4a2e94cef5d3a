/* What encoder rows of films share; a row adds its container. */
#ifndef ENCODE_VIDEO_H
#define ENCODE_VIDEO_H

#include "encode/container.h"
#include "encode/encode.h"

#if HAVE_LIBAV
#define VIDEO_MISSING NULL
#define VIDEO_FUNCTIONS \
    .wants_pixels = true, .check = video_check, .open = video_open, .frame = video_frame, \
    .close = video_close

enum status video_check(const struct encode_target *target, struct error *e);
enum status video_open(struct encoder **encoder, const struct encode_target *target,
                       struct error *e);
enum status video_frame(struct encoder *encoder, const struct encode_frame *frame,
                        struct error *e);
enum status video_close(struct encoder *encoder, bool keep, struct error *e);
#else
#define VIDEO_MISSING \
    "install libavformat-dev, libavcodec-dev, libswscale-dev and libavutil-dev " \
    "(tools/install-deps does), then make LIBAV=1"
#define VIDEO_FUNCTIONS .wants_pixels = true
#endif

#endif
