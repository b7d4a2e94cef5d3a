/* Frames from a film, decoded one by one by libavcodec to full-range sRGB. */
#include "compare/source.h"

extern const struct source_row source_film;

#if HAVE_LIBAV

#include "base/libav.h"
#include "base/memory.h"

#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libswscale/swscale.h>
#include <stdio.h>

struct film {
    AVFormatContext *file;
    AVCodecContext *codec;
    struct SwsContext *convert;
    AVPacket *packet;
    AVFrame *picture;
    int stream;
    bool drained; /* the file has ended, and the decoder knows */
};

static enum status fail(const struct source *source, int code, const char *what, struct error *e)
{
    return libav_error(e, STATUS_USAGE, code, "%s: %s", source->path, what);
}

/* The next packet of the film's stream to the decoder, or the end of the file. */
static int feed(struct film *film)
{
    int code;
    while ((code = av_read_frame(film->file, film->packet)) >= 0) {
        if (film->packet->stream_index == film->stream)
            code = avcodec_send_packet(film->codec, film->packet);
        bool sent = film->packet->stream_index == film->stream;
        av_packet_unref(film->packet);
        if (sent)
            return code;
    }
    if (code != AVERROR_EOF)
        return code;
    film->drained = true;
    return avcodec_send_packet(film->codec, NULL);
}

static enum status decode(struct source *source, struct error *e)
{
    struct film *film = source->state;
    int code;
    while ((code = avcodec_receive_frame(film->codec, film->picture)) == AVERROR(EAGAIN))
        if (film->drained || (code = feed(film)) < 0)
            break;
    if (code < 0 && code != AVERROR_EOF)
        return fail(source, code, "cannot be decoded", e);
    source->ended = code == AVERROR_EOF;
    snprintf(source->name, sizeof source->name, "frame %ld", source->number);
    return STATUS_OK;
}

static enum status film_next(struct source *source, struct error *e)
{
    source->number++;
    return decode(source, e);
}

static enum status open_codec(struct source *source, struct error *e)
{
    struct film *film = source->state;
    const AVCodec *codec = NULL;
    int code = avformat_open_input(&film->file, source->path, NULL, NULL);
    if (code < 0)
        return fail(source, code, "is neither a PNG picture nor a film", e);
    if ((code = avformat_find_stream_info(film->file, NULL)) < 0 ||
        (code = av_find_best_stream(film->file, AVMEDIA_TYPE_VIDEO, -1, -1, &codec, 0)) < 0)
        return fail(source, code, "has no pictures that this libavcodec can decode", e);
    film->stream = code;
    film->codec = avcodec_alloc_context3(codec);
    film->packet = av_packet_alloc();
    film->picture = av_frame_alloc();
    if (!film->codec || !film->packet || !film->picture)
        return error_set(e, STATUS_RUN, "%s: no memory", source->path);
    if ((code = avcodec_parameters_to_context(film->codec,
                                              film->file->streams[film->stream]->codecpar)) < 0 ||
        (code = avcodec_open2(film->codec, codec, NULL)) < 0)
        return fail(source, code, "cannot be decoded", e);
    return STATUS_OK;
}

static enum status film_open(struct source *source, enum source_kind kind, enum source_order order,
                             struct error *e)
{
    (void)kind;
    (void)order;
    libav_quiet();
    source->state = memory_create("compare", 1, sizeof(struct film), e);
    if (!source->state || open_codec(source, e) || decode(source, e))
        return e->status;
    if (source->ended)
        return error_set(e, STATUS_USAGE, "%s: the film has no frames", source->path);
    return STATUS_OK;
}

/* The matrix that the film names, BT.709 when it names none, as our own films have. */
static enum status prepare(struct source *source, struct error *e)
{
    struct film *film = source->state;
    const AVFrame *p = film->picture;
    int space = p->colorspace == AVCOL_SPC_UNSPECIFIED ? SWS_CS_ITU709 : (int)p->colorspace;
    const int *from = sws_getCoefficients(space), *to = sws_getCoefficients(SWS_CS_ITU709);
    film->convert = sws_getCachedContext(film->convert, p->width, p->height, p->format, p->width,
                                         p->height, AV_PIX_FMT_RGBA,
                                         SWS_BILINEAR | SWS_ACCURATE_RND | SWS_BITEXACT, NULL, NULL,
                                         NULL);
    if (!film->convert)
        return error_set(e, STATUS_BACKEND, "%s: this libswscale cannot convert its colours",
                         source->path);
    /* Fails for formats that are RGB already, which need no matrix. */
    (void)sws_setColorspaceDetails(film->convert, from, p->color_range == AVCOL_RANGE_JPEG, to, 1,
                                   0, 1 << 16, 1 << 16);
    return STATUS_OK;
}

static enum status film_read(struct source *source, struct image *image, struct error *e)
{
    struct film *film = source->state;
    const AVFrame *p = film->picture;
    if (image->width != p->width || image->height != p->height) {
        image_free(image);
        if (image_create(image, p->width, p->height, e))
            return e->status;
    }
    if (prepare(source, e))
        return e->status;
    uint8_t *const rows[4] = {image->rgba};
    int code = sws_scale(film->convert, (const uint8_t *const *)p->data, p->linesize, 0, p->height,
                         rows, (const int[4]){image->width * 4});
    return code == p->height ? STATUS_OK : fail(source, code, "colour conversion failed", e);
}

static void film_close(struct source *source)
{
    struct film *film = source->state;
    if (!film)
        return;
    sws_freeContext(film->convert);
    av_frame_free(&film->picture);
    av_packet_free(&film->packet);
    avcodec_free_context(&film->codec);
    avformat_close_input(&film->file);
    memory_free(film);
}

const struct source_row source_film = {film_open, film_next, film_read, film_close};

#else

static enum status film_open(struct source *source, enum source_kind kind, enum source_order order,
                             struct error *e)
{
    (void)kind;
    (void)order;
    return error_set(e, STATUS_BACKEND, "%s is no PNG picture, and this build reads no films: install "
                     "libavformat-dev, libavcodec-dev, libswscale-dev and libavutil-dev "
                     "(tools/install-deps does), then make LIBAV=1", source->path);
}

static void film_close(struct source *source)
{
    (void)source;
}

const struct source_row source_film = {.open = film_open, .close = film_close};

#endif
