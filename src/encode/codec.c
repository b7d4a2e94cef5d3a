/* Opens video codecs with their options and those of the scene. */
#include "encode/codec.h"

#if HAVE_LIBAV

#include "base/log.h"
#include "base/libav.h"

#include <libavcodec/avcodec.h>
#include <libavutil/opt.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double KEYFRAME_SECONDS = 2; /* what a killed process may lose, about */

/* Appends "word" or ", word"; what does not fit is left out. */
static void append(char *text, size_t size, const char *word)
{
    size_t used = strlen(text);
    if (used + strlen(word) + 3 < size)
        snprintf(text + used, size - used, "%s%s", used ? ", " : "", word);
}

/* Whether frames can be converted to it, by libswscale or encode/palette.h. The yuvj formats would
 * contradict our range; and GPUs make BT.601 of packed RGB, which would contradict our matrix. */
static bool format_usable(const struct codec_row *row, enum AVPixelFormat format)
{
    const uint64_t rgb = AV_PIX_FMT_FLAG_RGB, planar = AV_PIX_FMT_FLAG_PLANAR;
    if (format == AV_PIX_FMT_PAL8)
        return true;
    if (row->without_gpu && (av_pix_fmt_desc_get(format)->flags & (rgb | planar)) == rgb)
        return false;
    return sws_isSupportedOutput(format) && strncmp(av_get_pix_fmt_name(format), "yuvj", 4) != 0;
}

/* The pixel format of that name, if the encoder takes it. */
static enum status find_format(const AVCodec *encoder, const struct codec_row *row,
                               const char *name, enum AVPixelFormat *found, struct error *e)
{
    char known[900] = "";
    *found = av_get_pix_fmt(name);
    if (!encoder->pix_fmts && *found != AV_PIX_FMT_NONE && format_usable(row, *found))
        return STATUS_OK;
    for (const enum AVPixelFormat *f = encoder->pix_fmts; f && *f != AV_PIX_FMT_NONE; f++) {
        if (!format_usable(row, *f))
            continue;
        if (*f == *found)
            return STATUS_OK;
        append(known, sizeof known, av_get_pix_fmt_name(*f));
    }
    return error_set(e, STATUS_USAGE, "movie.pixel_format: codec %s does not take \"%s\"; it takes %s",
                     row->variant.name, name, known[0] ? known : "what libswscale writes");
}

static int padded(int side, int chroma_shift)
{
    int unit = 1 << chroma_shift;
    return (side + unit - 1) / unit * unit;
}

static void describe_colors(AVCodecContext *context, const AVPixFmtDescriptor *format)
{
    bool rgb = format->flags & (AV_PIX_FMT_FLAG_RGB | AV_PIX_FMT_FLAG_PAL);
    context->color_range = rgb ? AVCOL_RANGE_JPEG : AVCOL_RANGE_MPEG;
    context->color_primaries = AVCOL_PRI_BT709;
    context->color_trc = rgb ? AVCOL_TRC_IEC61966_2_1 : AVCOL_TRC_BT709;
    context->colorspace = rgb ? AVCOL_SPC_RGB : AVCOL_SPC_BT709;
    if (format->log2_chroma_w)
        context->chroma_sample_location = AVCHROMA_LOC_LEFT;
}

static void describe(AVCodecContext *context, const struct codec_row *row,
                     const struct codec_picture *picture, enum AVPixelFormat format)
{
    const AVPixFmtDescriptor *d = av_pix_fmt_desc_get(format);
    context->width = padded(picture->width, d->log2_chroma_w);
    context->height = padded(picture->height, d->log2_chroma_h);
    context->sample_aspect_ratio = (AVRational){1, 1};
    context->pix_fmt = format;
    context->framerate = (AVRational){picture->rate[0], picture->rate[1]};
    context->time_base = av_inv_q(context->framerate);
    context->gop_size = (int)fmax(1, ceil(KEYFRAME_SECONDS * av_q2d(context->framerate)));
    context->thread_count = row->threads;
    context->flags |= AV_CODEC_FLAG_GLOBAL_HEADER | AV_CODEC_FLAG_BITEXACT;
    if (row->tag)
        context->codec_tag = MKTAG(row->tag[0], row->tag[1], row->tag[2], row->tag[3]);
    describe_colors(context, d);
}

static bool has_avx512(void)
{
#if defined(__x86_64__)
    return __builtin_cpu_supports("avx512f");
#else
    return false;
#endif
}

static enum status set_defaults(AVCodecContext *context, const struct codec_row *row,
                                struct error *e)
{
    for (const struct codec_option *o = row->options; o->key; o++) {
        if (o->avx512 && !has_avx512())
            continue;
        int code = av_opt_set(context, o->key, o->value, AV_OPT_SEARCH_CHILDREN);
        if (code < 0)
            return libav_error(e, STATUS_BACKEND, code, "option %s=%s", o->key, o->value);
    }
    return STATUS_OK;
}

/* The codec lacks what the scene key stands for: names the options that it has of its own. */
static enum status no_option(const AVCodecContext *context, const struct codec_row *row,
                             const char *key, struct error *e)
{
    char known[1100] = "";
    const AVOption *o = NULL;
    while (context->codec->priv_class && (o = av_opt_next(context->priv_data, o)))
        if (o->type != AV_OPT_TYPE_CONST)
            append(known, sizeof known, o->name);
    return error_set(e, STATUS_USAGE, "%s: codec %s has no such option; it has %s", key,
                     row->variant.name, known[0] ? known : "none of its own");
}

/* Sets what a scene key says; NULL: nothing. `name` is the encoder's word for it, or NULL. */
static enum status set_said(AVCodecContext *context, const struct codec_row *row, const char *key,
                            const char *name, const char *value, struct error *e)
{
    if (!value)
        return STATUS_OK;
    int code = name ? av_opt_set(context, name, value, AV_OPT_SEARCH_CHILDREN)
                    : AVERROR_OPTION_NOT_FOUND;
    if (code == AVERROR_OPTION_NOT_FOUND)
        return no_option(context, row, key, e);
    return code < 0 ? libav_error(e, STATUS_USAGE, code, "%s: codec %s does not take \"%s\"", key,
                                  row->variant.name, value) : STATUS_OK;
}

/* movie.crf, which some encoders would take for something else below a number. */
static enum status set_crf(AVCodecContext *context, const struct codec_row *row, const char *crf,
                           struct error *e)
{
    if (crf && row->crf && strtod(crf, NULL) < row->least_crf)
        return error_set(e, STATUS_USAGE, "movie.crf: codec %s takes %d and more, not %s",
                         row->variant.name, row->least_crf, crf);
    return set_said(context, row, "movie.crf", row->crf, crf, e);
}

/* "key=value key=value" */
static enum status set_listed(AVCodecContext *context, const struct codec_row *row,
                              const char *list, struct error *e)
{
    AVDictionary *options = NULL;
    const AVDictionaryEntry *o = NULL;
    char key[160];
    enum status status = STATUS_OK;
    if (list && av_dict_parse_string(&options, list, "=", " ", 0) < 0)
        status = error_set(e, STATUS_USAGE, "movie.options: \"%s\" is no list of the form \"key=value "
                           "key=value\"", list);
    while (!status && (o = av_dict_get(options, "", o, AV_DICT_IGNORE_SUFFIX))) {
        snprintf(key, sizeof key, "movie.options: %.100s", o->key);
        status = set_said(context, row, key, o->key, o->value, e);
    }
    av_dict_free(&options);
    return status;
}

static enum status set_options(AVCodecContext *context, const struct codec_row *row,
                               const struct encode_video *v, struct error *e)
{
    if (set_defaults(context, row, e) ||
        set_said(context, row, "movie.preset", row->preset, v->preset, e) ||
        set_said(context, row, "movie.tune", row->tune, v->tune, e) ||
        set_crf(context, row, v->crf, e))
        return e->status;
    return set_listed(context, row, v->options, e);
}

/* A value that the encoder itself refuses is the scene's fault, if the scene has said any. */
static enum status open_context(AVCodecContext *context, const struct encode_video *v,
                                struct error *e)
{
    char reason[400];
    int code = avcodec_open2(context, context->codec, NULL);
    bool said = v->crf || v->preset || v->tune || v->options;
    if (code >= 0)
        return STATUS_OK;
    libav_reason(code, reason, sizeof reason);
    return error_set(e, said && code == AVERROR(EINVAL) ? STATUS_USAGE : STATUS_BACKEND, "%s",
                     reason);
}

static enum status check_size(const AVCodecContext *context, const struct codec_row *row,
                              struct error *e)
{
    const int *least = row->least_size;
    if (context->width >= least[0] && context->height >= least[1])
        return STATUS_OK;
    return error_set(e, STATUS_USAGE, "movie.size: codec %s takes %d x %d pixels and more, not %d x %d; "
                     "smaller ones are for \"%s\"", row->variant.name, least[0], least[1],
                     context->width, context->height, row->without_gpu);
}

enum status codec_prepare(AVCodecContext **prepared, const struct codec_row *row,
                          const struct codec_picture *picture, const struct encode_video *video,
                          struct error *e)
{
    enum AVPixelFormat format;
    libav_quiet();
    *prepared = NULL;
    const AVCodec *found = avcodec_find_encoder_by_name(row->encoder);
    if (!found)
        return error_set(e, STATUS_BACKEND, "%s is not in this machine's libavcodec", row->encoder);
    if (find_format(found, row, video->pixel_format ? video->pixel_format : row->pixel_format,
                    &format, e))
        return e->status;
    AVCodecContext *context = avcodec_alloc_context3(found);
    if (!context)
        return error_set(e, STATUS_RUN, "no memory");
    describe(context, row, picture, format);
    if (set_options(context, row, video, e) || check_size(context, row, e)) {
        avcodec_free_context(&context);
        return e->status;
    }
    *prepared = context;
    return STATUS_OK;
}

/* Whether the GPU has this encoder at all, for a picture and settings that suit any. */
static bool gpu_has(const struct codec_row *row)
{
    const struct codec_picture picture = {256, 256, {30, 1}};
    const struct encode_video video = {.codec = NULL};
    AVCodecContext *context = NULL;
    struct error ignored = {STATUS_OK, ""};
    bool has = codec_prepare(&context, row, &picture, &video, &ignored) == STATUS_OK &&
               open_context(context, &video, &ignored) == STATUS_OK;
    avcodec_free_context(&context);
    return has;
}

enum status codec_try(AVCodecContext **opened, const struct codec_row *row,
                      const struct codec_picture *picture, const struct encode_video *video,
                      struct error *e)
{
    AVCodecContext *context;
    enum status status = STATUS_OK;
    setenv("SVT_LOG", "1", 0); /* errors only; the first call comes before there are threads */
    if (opened)
        *opened = NULL;
    if (codec_prepare(&context, row, picture, video, e))
        return e->status;
    if (opened || row->without_gpu)
        status = open_context(context, video, e);
    if (status == STATUS_BACKEND && row->without_gpu && gpu_has(row)) {
        struct error reason = *e;
        status = error_set(e, STATUS_USAGE, "codec %s opens here, but not for %d x %d pixels of %s and "
                           "these settings: %s; \"%s\" needs no GPU", row->variant.name,
                           context->width, context->height, av_get_pix_fmt_name(context->pix_fmt),
                           reason.text, row->without_gpu);
    }
    if (!status && opened)
        *opened = context;
    else
        avcodec_free_context(&context);
    return status;
}

/* Completes the reason why a codec that was asked for does not open. */
static enum status cannot_open(const struct codec_row *row, struct error *e)
{
    struct error reason = *e;
    if (!row->without_gpu)
        return error_context(e, "movie.codec: %s cannot be opened", row->variant.name);
    return error_set(e, STATUS_BACKEND, "movie.codec: %s cannot be opened: %s. It needs an NVIDIA GPU "
                     "with an encoder, and its driver; use \"%s\", which needs none",
                     row->variant.name, reason.text, row->without_gpu);
}

/* The codec that the scene names, when the container can hold it. */
static enum status open_named(AVCodecContext **opened, const struct container *container,
                              const struct codec_picture *picture, const struct encode_video *video,
                              struct error *e)
{
    const struct codec_row *row = (const struct codec_row *)variant_find(&codec_table, video->codec);
    char known[300] = "";
    if (!row)
        return error_set(e, STATUS_USAGE, "movie.codec: \"%s\" is unknown", video->codec);
    if (avcodec_find_encoder_by_name(row->encoder) && !container_holds(container, row->encoder)) {
        for (size_t i = 0; i < codec_table.count; i++) {
            const struct codec_row *other = (const struct codec_row *)codec_table.rows[i];
            if (container_holds(container, other->encoder))
                append(known, sizeof known, other->variant.name);
        }
        return error_set(e, STATUS_USAGE, "movie.codec: %s files cannot hold %s; they hold %s",
                         container->muxer, row->variant.name, known);
    }
    if (codec_try(opened, row, picture, video, e) == STATUS_BACKEND)
        return cannot_open(row, e);
    return e->status;
}

/* Which codecs that fit the file were not even tried, and why: "; ..." for the log, or nothing. */
static void passed_over(const struct container *container, char *text, size_t size)
{
    char names[100] = "";
    for (size_t i = 0; container->chooses && i < codec_table.count; i++) {
        const struct codec_row *row = (const struct codec_row *)codec_table.rows[i];
        if (row->without_gpu && container_holds(container, row->encoder))
            append(names, sizeof names, row->variant.name);
    }
    snprintf(text, size, "%s%s", names[0] ? "; passed over, since a GPU's films differ between machines "
             "and movie.codec does not ask for them: " : "", names);
}

enum status codec_open(AVCodecContext **opened, const struct container *container,
                       const struct codec_picture *picture, const struct encode_video *video,
                       struct error *e)
{
    char tried[1500] = "", others[300];
    size_t used = 0;
    e->status = STATUS_OK;
    if (video->codec)
        return open_named(opened, container, picture, video, e);
    for (const char *const *name = container->codecs; *name; name++) {
        const struct codec_row *row = (const struct codec_row *)variant_find(&codec_table, *name);
        enum status status = codec_try(opened, row, picture, video, e);
        if (status == STATUS_OK) {
            passed_over(container, others, sizeof others);
            if (opened)
                log_detail("video codec %s%s%s%s", row->encoder, used ? ", since " : "", tried,
                           others);
            return STATUS_OK;
        }
        if (status == STATUS_USAGE)
            return status;
        if (used < sizeof tried)
            used += (size_t)snprintf(tried + used, sizeof tried - used, "%s%s: %.300s",
                                     used ? "; " : "", row->variant.name, e->text);
    }
    return error_set(e, STATUS_BACKEND, "no video codec opens for %d x %d pixels: %s. Install a "
                     "libavcodec with %s, or write x-%%04d.png", picture->width, picture->height,
                     tried, container->codecs[0]);
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
void codec_close(AVCodecContext **context, bool used)
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
