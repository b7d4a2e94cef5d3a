/* Films: images to pictures of a codec to a container's file, whole or absent under its name. */
#include "encode/video.h"

#if HAVE_LIBAV

#include "base/log.h"
#include "base/memory.h"
#include "encode/codec.h"
#include "encode/container.h"
#include "base/libav.h"
#include "encode/palette.h"

#include <errno.h>
#include <fcntl.h>
#include <libavcodec/avcodec.h>
#include <libavutil/pixdesc.h>
#include <libgen.h>
#include <libswscale/swscale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct encoder {
    const struct container *container;
    char *path, *part, *final;         /* the film; as it grows; its final order, to be renamed */
    char *title, *comment;
    int width, height;                 /* of the images, pixels */
    struct image padded;               /* only when a side must be longer */
    AVCodecContext *codec;
    struct SwsContext *convert;
    struct palette *palette;           /* instead, of a format with one */
    AVFrame *picture;
    AVPacket *packet;
    struct container_file *file;
    long first, count;                 /* index of the first frame; frames taken */
    struct error error;                /* the first, once a frame has failed */
};

static bool is_pipe(const char *path)
{
    return strcmp(path, "-") == 0;
}

static void encoder_free(struct encoder *encoder)
{
    codec_close(&encoder->codec, encoder->count > 0);
    sws_freeContext(encoder->convert);
    palette_free(encoder->palette);
    av_frame_free(&encoder->picture);
    av_packet_free(&encoder->packet);
    image_free(&encoder->padded);
    free(encoder->path);
    free(encoder->part);
    free(encoder->final);
    free(encoder->title);
    free(encoder->comment);
    memory_free(encoder);
}

/* Full-range sRGB, as it is or to limited-range BT.709; libswscale's default would be BT.601. */
static enum status open_scaler(struct encoder *encoder, struct error *e)
{
    int w = encoder->codec->width, h = encoder->codec->height;
    int flags = SWS_BILINEAR | SWS_ACCURATE_RND | SWS_BITEXACT;
    const int *bt709 = sws_getCoefficients(SWS_CS_ITU709);
    const AVPixFmtDescriptor *format = av_pix_fmt_desc_get(encoder->codec->pix_fmt);
    if (!format->log2_chroma_w)
        flags |= SWS_FULL_CHR_H_INT | SWS_FULL_CHR_H_INP; /* the chroma of every pixel */
    encoder->convert = sws_getContext(w, h, AV_PIX_FMT_RGBA, w, h, encoder->codec->pix_fmt, flags,
                                      NULL, NULL, NULL);
    bool rgb = format->flags & AV_PIX_FMT_FLAG_RGB;
    if (!encoder->convert ||
        (!rgb && sws_setColorspaceDetails(encoder->convert, bt709, 1, bt709, 0, 0, 1 << 16,
                                          1 << 16) < 0))
        return error_set(e, STATUS_BACKEND, "%s: this libswscale cannot convert to %s in BT.709",
                         encoder->path, format->name);
    return STATUS_OK;
}

/* The picture that the codec gets, and what fills it. */
static enum status open_convert(struct encoder *encoder, struct error *e)
{
    AVFrame *picture = encoder->picture;
    int w = encoder->codec->width, h = encoder->codec->height;
    picture->format = encoder->codec->pix_fmt;
    picture->width = w;
    picture->height = h;
    picture->color_range = encoder->codec->color_range;
    picture->color_primaries = encoder->codec->color_primaries;
    picture->color_trc = encoder->codec->color_trc;
    picture->colorspace = encoder->codec->colorspace;
    picture->chroma_location = encoder->codec->chroma_sample_location;
    int code = av_frame_get_buffer(picture, 0);
    if (code < 0)
        return libav_error(e, STATUS_RUN, code, "%s: no memory for a picture", encoder->path);
    if (picture->format != AV_PIX_FMT_PAL8)
        return open_scaler(encoder, e);
    encoder->palette = palette_create();
    return encoder->palette ? STATUS_OK
                            : error_set(e, STATUS_RUN, "%s: no memory for colours", encoder->path);
}

/* Opens the codec, or with `codec` NULL looks whether it could be. */
static enum status open_codec(AVCodecContext **codec, const struct container *container,
                              const struct encode_target *target, struct error *e)
{
    AVRational rate = av_d2q(target->fps, 65535); /* mpeg4 allows no finer clock */
    struct codec_picture picture = {target->width, target->height, {rate.num, rate.den}};
    struct encode_video video = target->video;
    if (rate.num <= 0 || rate.den <= 0)
        return error_set(e, STATUS_USAGE, "%s: %g frames per second are too few or too many",
                         target->path, target->fps);
    if (!container->chooses)
        video = (struct encode_video){.pixel_format = video.pixel_format};
    if (!container->formats)
        video.pixel_format = NULL;
    if (codec_open(codec, container, &picture, &video, e))
        return error_context(e, "%s", target->path);
    return STATUS_OK;
}

enum status video_check(const struct encode_target *target, struct error *e)
{
    const struct encoder_row *row = encode_find(target->path, e);
    if (is_pipe(target->path) && isatty(STDOUT_FILENO))
        return error_set(e, STATUS_USAGE, "output \"-\": standard output is a terminal; send it to a "
                         "program, or name a file x.y4m");
    return row ? open_codec(NULL, row->container, target, e) : e->status;
}

static enum status open_parts(struct encoder *encoder, const struct encode_target *target,
                              struct error *e)
{
    struct container_tags tags = {encoder->title, encoder->comment};
    if (open_codec(&encoder->codec, encoder->container, target, e))
        return e->status;
    int width = encoder->codec->width, height = encoder->codec->height;
    if (width != target->width || height != target->height) {
        if (image_create(&encoder->padded, width, height, e))
            return e->status;
        log_info("%s: %d x %d pixels are padded to %d x %d, since video needs even sides",
                 target->path, target->width, target->height, width, height);
    }
    if (open_convert(encoder, e))
        return e->status;
    return container_open(&encoder->file, encoder->container, encoder->part, encoder->codec, &tags,
                          e);
}

enum status video_open(struct encoder **made, const struct encode_target *target, struct error *e)
{
    const struct encoder_row *row = encode_find(target->path, e);
    struct encoder *encoder = memory_create("encoder", 1, sizeof *encoder, e);
    *made = NULL;
    if (!encoder || !row)
        return e->status;
    libav_quiet();
    encoder->container = row->container;
    encoder->width = target->width;
    encoder->height = target->height;
    encoder->path = strdup(target->path);
    encoder->title = strdup(target->title ? target->title : "");
    encoder->comment = strdup(target->comment ? target->comment : "");
    encoder->packet = av_packet_alloc();
    encoder->picture = av_frame_alloc();
    if (asprintf(&encoder->part, is_pipe(target->path) ? "%s" : "%s.part", target->path) < 0)
        encoder->part = NULL;
    if (asprintf(&encoder->final, "%s.final.part", target->path) < 0)
        encoder->final = NULL;
    if (!encoder->path || !encoder->title || !encoder->comment || !encoder->part ||
        !encoder->final || !encoder->packet || !encoder->picture)
        error_set(e, STATUS_RUN, "%s: no memory", target->path);
    else if (open_parts(encoder, target, e) == STATUS_OK) {
        *made = encoder;
        return STATUS_OK;
    }
    encoder_free(encoder);
    return e->status;
}

/* Repeats the last column and row, so that no dark edge bleeds into the picture. */
static const struct image *pad(struct encoder *encoder, const struct image *image)
{
    struct image *padded = &encoder->padded;
    size_t from = (size_t)image->width * 4, to = (size_t)padded->width * 4;
    if (!padded->rgba)
        return image;
    for (int y = 0; y < padded->height; y++) {
        int source = y < image->height ? y : image->height - 1;
        uint8_t *row = padded->rgba + (size_t)y * to;
        memcpy(row, image->rgba + (size_t)source * from, from);
        if (to > from)
            memcpy(row + from, row + from - 4, 4);
    }
    return padded;
}

/* Sends one picture, or NULL at the end, and writes all packets that are ready. */
static enum status encode(struct encoder *encoder, const AVFrame *picture, struct error *e)
{
    int code = avcodec_send_frame(encoder->codec, picture);
    while (code >= 0) {
        code = avcodec_receive_packet(encoder->codec, encoder->packet);
        if (code == AVERROR(EAGAIN) || code == AVERROR_EOF)
            return STATUS_OK;
        if (code < 0)
            break;
        encoder->packet->duration = 1; /* frame: the last one would have none */
        if (container_write(encoder->file, encoder->packet, e))
            return e->status;
    }
    return libav_error(e, STATUS_RUN, code, "%s: encoding frame %ld failed", encoder->path,
                       encoder->count);
}

static void paint(struct palette *palette, const struct image *image, AVFrame *picture)
{
    uint32_t colors[PALETTE_SIZE];
    palette_choose(palette, image, colors);
    memcpy(picture->data[1], colors, sizeof colors);
    for (int y = 0; y < image->height; y++) {
        const uint8_t *from = image->rgba + (size_t)y * (size_t)image->width * 4;
        uint8_t *to = picture->data[0] + (ptrdiff_t)y * picture->linesize[0];
        for (int x = 0; x < image->width; x++)
            to[x] = palette_index(palette, from + 4 * x);
    }
}

/* The image in the codec's pixel format. */
static enum status convert(struct encoder *encoder, const struct image *image, struct error *e)
{
    AVFrame *picture = encoder->picture;
    const uint8_t *rows[4] = {image->rgba};
    if (encoder->palette) {
        paint(encoder->palette, image, picture);
        return STATUS_OK;
    }
    int code = sws_scale(encoder->convert, rows, (const int[4]){image->width * 4}, 0,
                         image->height, picture->data, picture->linesize);
    return code == image->height ? STATUS_OK : libav_error(e, STATUS_RUN, code, "%s: colour "
                                                           "conversion failed", encoder->path);
}

static enum status encode_image(struct encoder *encoder, const struct encode_frame *frame,
                                struct error *e)
{
    AVFrame *picture = encoder->picture;
    if (frame->image->width != encoder->width || frame->image->height != encoder->height)
        return error_set(e, STATUS_RUN, "%s: frame %ld has %d x %d pixels instead of %d x %d",
                         encoder->path, frame->index, frame->image->width, frame->image->height,
                         encoder->width, encoder->height);
    const struct image *image = pad(encoder, frame->image);
    int code = av_frame_make_writable(picture);
    if (code < 0)
        return libav_error(e, STATUS_RUN, code, "%s: no memory for a picture", encoder->path);
    if (convert(encoder, image, e))
        return e->status;
    if (encoder->count++ == 0)
        encoder->first = frame->index;
    picture->pts = frame->index - encoder->first;
    return encode(encoder, picture, e);
}

enum status video_frame(struct encoder *encoder, const struct encode_frame *frame,
                        struct error *e)
{
    if (encoder->error.status)
        *e = encoder->error;
    else if (encode_image(encoder, frame, e))
        encoder->error = *e;
    return encoder->error.status;
}

/* Renames the finished file to the film's name, durably. */
static enum status publish(const char *from, const char *to, struct error *e)
{
    if (rename(from, to))
        return error_set(e, STATUS_OUTPUT, "%s: %s", to, strerror(errno));
    char *copy = strdup(to);
    int directory = copy ? open(dirname(copy), O_RDONLY | O_DIRECTORY | O_CLOEXEC) : -1;
    if (directory >= 0) {
        fsync(directory); /* best effort: some file systems refuse it for directories */
        close(directory);
    }
    free(copy);
    return STATUS_OK;
}

/* Flushes the codec, completes the file, reorders it if its kind wants that, and gives it the film's
 * name. */
static enum status finish(struct encoder *encoder, struct error *e)
{
    struct error reason;
    if (encoder->error.status) {
        *e = encoder->error;
        return e->status;
    }
    if (encoder->count == 0) {
        log_info("%s: not written, since there was no frame", encoder->path);
        return STATUS_OK;
    }
    if (encode(encoder, NULL, e))
        return e->status;
    struct container_file *file = encoder->file;
    encoder->file = NULL;
    if (container_close(file, true, e))
        return e->status;
    if (is_pipe(encoder->path))
        return STATUS_OK;
    if (!encoder->container->final_options[0])
        return publish(encoder->part, encoder->path, e);
    struct container_tags tags = {encoder->title, encoder->comment};
    if (container_reorder(encoder->container, encoder->part, encoder->final, &tags, &reason) ==
        STATUS_OK)
        return publish(encoder->final, encoder->path, e);
    log_info("%s: kept as a fragmented mp4, which plays everywhere but seeks slower, since %s",
             encoder->path, reason.text);
    return publish(encoder->part, encoder->path, e);
}

enum status video_close(struct encoder *encoder, bool keep, struct error *e)
{
    struct error ignored;
    enum status status = keep ? finish(encoder, e) : STATUS_OK;
    if (encoder->file)
        container_close(encoder->file, false, &ignored);
    if (!is_pipe(encoder->path))
        unlink(encoder->part);
    encoder_free(encoder);
    return status;
}

#endif
