/* Opens a video codec for mp4 films: the first in the table that this machine can open. */
#include "encode/mp4_codec.h"

#if HAVE_LIBAV

#include "base/libav.h"
#include "base/log.h"

#include <libavcodec/avcodec.h>
#include <libavutil/opt.h>
#include <math.h>
#include <stdio.h>

static const double KEYFRAME_SECONDS = 2; /* what a killed process may lose, about */

/* x264: build 164 gives files that differ from run to run with AVX-512 and mbtree, for widths such
 * as 160, 720 and 854; AVX2 gives the same file always, as fast. h264_nvenc is in every build of
 * libavcodec, yet opens only where the GPU has an encoder. mpeg4: quality 3 * FF_QP2LAMBDA. */
const struct mp4_codec mp4_codecs[] = {
    {"libx264", 4, {{"preset", "veryfast", false}, {"crf", "18", false},
                    {"x264-params", "asm=avx2", true}}},
    {"h264_nvenc", 1, {{"preset", "p4", false}, {"rc", "constqp", false}, {"qp", "20", false}}},
    {"libsvtav1", 4, {{"preset", "10", false}, {"crf", "28", false}}},
    {"mpeg4", 1, {{"flags", "+qscale", false}, {"global_quality", "354", false}}},
};
const size_t mp4_codec_count = sizeof mp4_codecs / sizeof mp4_codecs[0];

static void describe(AVCodecContext *context, const struct mp4_codec *codec,
                     const struct mp4_picture *picture)
{
    context->width = picture->width;
    context->height = picture->height;
    context->sample_aspect_ratio = (AVRational){1, 1};
    context->pix_fmt = AV_PIX_FMT_YUV420P;
    context->framerate = (AVRational){picture->rate[0], picture->rate[1]};
    context->time_base = av_inv_q(context->framerate);
    context->gop_size = (int)fmax(1, ceil(KEYFRAME_SECONDS * av_q2d(context->framerate)));
    context->color_range = AVCOL_RANGE_MPEG;
    context->color_primaries = AVCOL_PRI_BT709;
    context->color_trc = AVCOL_TRC_BT709;
    context->colorspace = AVCOL_SPC_BT709;
    context->chroma_sample_location = AVCHROMA_LOC_LEFT;
    context->thread_count = codec->threads;
    context->flags |= AV_CODEC_FLAG_GLOBAL_HEADER | AV_CODEC_FLAG_BITEXACT;
}

static bool has_avx512(void)
{
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx512f");
#else
    return false;
#endif
}

static enum status set_options(AVCodecContext *context, const struct mp4_codec *codec,
                               struct error *e)
{
    for (const struct mp4_option *o = codec->options; o->key; o++) {
        if (o->avx512 && !has_avx512())
            continue;
        int code = av_opt_set(context, o->key, o->value, AV_OPT_SEARCH_CHILDREN);
        if (code < 0)
            return libav_error(e, STATUS_BACKEND, code, "option %s=%s", o->key, o->value);
    }
    return STATUS_OK;
}

enum status mp4_codec_try(AVCodecContext **opened, const struct mp4_codec *codec,
                          const struct mp4_picture *picture, struct error *e)
{
    char reason[400];
    libav_quiet();
    *opened = NULL;
    const AVCodec *found = avcodec_find_encoder_by_name(codec->name);
    if (!found)
        return error_set(e, STATUS_BACKEND, "not in this machine's libavcodec");
    AVCodecContext *context = avcodec_alloc_context3(found);
    if (!context)
        return error_set(e, STATUS_RUN, "no memory");
    describe(context, codec, picture);
    if (set_options(context, codec, e))
        goto fail;
    int code = avcodec_open2(context, found, NULL);
    if (code < 0) {
        libav_reason(code, reason, sizeof reason);
        error_set(e, STATUS_BACKEND, "%s", reason);
        goto fail;
    }
    *opened = context;
    return STATUS_OK;
fail:
    avcodec_free_context(&context);
    return e->status;
}

enum status mp4_codec_open(AVCodecContext **opened, const struct mp4_picture *picture,
                           struct error *e)
{
    char tried[1500] = "";
    size_t used = 0;
    for (size_t i = 0; i < mp4_codec_count; i++) {
        if (mp4_codec_try(opened, &mp4_codecs[i], picture, e) == STATUS_OK) {
            log_detail("video codec %s%s%s", mp4_codecs[i].name, used ? ", since " : "", tried);
            return STATUS_OK;
        }
        if (used < sizeof tried)
            used += (size_t)snprintf(tried + used, sizeof tried - used, "%s%s: %.300s",
                                     used ? "; " : "", mp4_codecs[i].name, e->text);
    }
    return error_set(e, STATUS_BACKEND, "no video codec opens for %d x %d pixels: %s. Install a "
                     "libavcodec with libx264, or write x-%%04d.png", picture->width,
                     picture->height, tried);
}

static void send_blank(AVCodecContext *context)
{
    AVFrame *frame = av_frame_alloc();
    if (frame) {
        frame->format = context->pix_fmt;
        frame->width = context->width;
        frame->height = context->height;
        frame->pts = 0;
        if (av_frame_get_buffer(frame, 0) >= 0)
            avcodec_send_frame(context, frame);
    }
    av_frame_free(&frame);
}

/* SVT-AV1 waits for ever when it is freed in mid-stream, and when a stream without frames ends. */
void mp4_codec_close(AVCodecContext **context, bool used)
{
    AVPacket *packet = *context ? av_packet_alloc() : NULL;
    if (packet) {
        if (!used)
            send_blank(*context);
        avcodec_send_frame(*context, NULL);
        while (avcodec_receive_packet(*context, packet) >= 0)
            av_packet_unref(packet);
    }
    av_packet_free(&packet);
    avcodec_free_context(context);
}

#endif
