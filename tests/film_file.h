/* Writes films of test pictures and decodes them again. */
#ifndef TESTS_FILM_FILE_H
#define TESTS_FILM_FILE_H

#include "encode/encode.h"
#include "picture.h"

#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/pixdesc.h>

/* What a film turned out to be. */
struct film {
    int width, height, frames;
    double fps, start, duration; /* duration of the container, s */
    bool tagged;                 /* BT.709, limited range */
    bool index_first;            /* the index precedes the data */
    char title[40], comment[80];
    char format[40];             /* of pixels */
    uint8_t first[16];           /* bytes of the first plane of the last frame */
    double patches[PATCH_COUNT][3]; /* mean RGB in the middle of each patch of the last frame */
};

static inline bool index_first(const char *path)
{
    static char bytes[1 << 20];
    FILE *file = fopen(path, "rb");
    size_t size = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    char *index = memmem(bytes, size, "moov", 4), *data = memmem(bytes, size, "mdat", 4);
    return index && (!data || index < data) && !memmem(bytes, size, "moof", 4);
}

/* Limited-range BT.709 (ITU-R BT.709-6, 3.5), written out here so as not to trust libswscale. */
static inline void mean_rgb(const AVFrame *f, int patch, double rgb[3])
{
    int x0 = (patch % 4 * 2 + 1) * f->width / 8, y0 = (patch / 4 * 2 + 1) * f->height / 4;
    double y = 0, u = 0, v = 0;
    for (int dy = -4; dy < 4; dy++)
        for (int dx = -4; dx < 4; dx++) {
            y += f->data[0][(y0 + dy) * f->linesize[0] + x0 + dx] / 64.0;
            u += f->data[1][(y0 + dy) / 2 * f->linesize[1] + (x0 + dx) / 2] / 64.0;
            v += f->data[2][(y0 + dy) / 2 * f->linesize[2] + (x0 + dx) / 2] / 64.0;
        }
    y = (y - 16) / 219, u = (u - 128) / 224, v = (v - 128) / 224;
    rgb[0] = 255 * (y + 1.5748 * v);
    rgb[1] = 255 * (y - 0.1873 * u - 0.4681 * v);
    rgb[2] = 255 * (y + 1.8556 * u);
}

static inline void look_at(const AVFrame *frame, struct film *film)
{
    film->frames++;
    film->width = frame->width;
    film->height = frame->height;
    film->tagged = frame->colorspace == AVCOL_SPC_BT709 && frame->color_range == AVCOL_RANGE_MPEG &&
                   frame->color_primaries == AVCOL_PRI_BT709 && frame->color_trc == AVCOL_TRC_BT709;
    snprintf(film->format, sizeof film->format, "%s", av_get_pix_fmt_name(frame->format));
    memcpy(film->first, frame->data[0], sizeof film->first);
    for (int k = 0; k < PATCH_COUNT && frame->format == AV_PIX_FMT_YUV420P; k++)
        mean_rgb(frame, k, film->patches[k]);
}

/* Decodes a whole film; false when it does not open. */
static inline bool decode(const char *path, struct film *film)
{
    AVFormatContext *format = NULL;
    AVPacket *packet = av_packet_alloc();
    AVFrame *frame = av_frame_alloc();
    memset(film, 0, sizeof *film);
    if (avformat_open_input(&format, path, NULL, NULL) < 0)
        goto done;
    assert_true(avformat_find_stream_info(format, NULL) >= 0);
    AVStream *stream = format->streams[0];
    AVDictionaryEntry *title = av_dict_get(format->metadata, "title", NULL, 0);
    AVDictionaryEntry *comment = av_dict_get(format->metadata, "comment", NULL, 0);
    AVCodecContext *codec =
        avcodec_alloc_context3(avcodec_find_decoder(stream->codecpar->codec_id));
    avcodec_parameters_to_context(codec, stream->codecpar);
    assert_int_equal(avcodec_open2(codec, codec->codec, NULL), 0);
    film->fps = av_q2d(stream->avg_frame_rate);
    film->start = stream->start_time == AV_NOPTS_VALUE
                  ? -1 : (double)stream->start_time * av_q2d(stream->time_base);
    film->duration = (double)format->duration / AV_TIME_BASE;
    film->index_first = index_first(path);
    snprintf(film->title, sizeof film->title, "%s", title ? title->value : "");
    snprintf(film->comment, sizeof film->comment, "%s", comment ? comment->value : "");
    for (bool more = true; more;) {
        more = av_read_frame(format, packet) >= 0;
        avcodec_send_packet(codec, more ? packet : NULL);
        av_packet_unref(packet);
        while (avcodec_receive_frame(codec, frame) >= 0)
            look_at(frame, film);
    }
    avcodec_free_context(&codec);
done:
    avformat_close_input(&format);
    av_packet_free(&packet);
    av_frame_free(&frame);
    return film->frames > 0;
}

enum drawing { PATCHES, MOVING, NOISE };

static inline struct encode_target target_of(const char *path, int width, int height)
{
    return (struct encode_target){.path = path, .width = width, .height = height, .fps = 30,
                                  .title = "Dam break", .comment = "sph-render 1, scene 5"};
}

static inline enum status write_film(struct encode_target target, enum drawing drawing, long count,
                              bool keep, struct error *e)
{
    const struct encoder_row *row = encode_find(target.path, e);
    struct encoder *encoder;
    struct error closing;
    struct image image;
    enum status status = row->open(&encoder, &target, e);
    if (status || image_create(&image, target.width, target.height, e))
        return status;
    for (long i = 0; !status && i < count; i++) {
        struct encode_frame frame = {i + 5, 0, &image, 0};
        if (drawing == PATCHES)
            picture_patches(&image);
        else if (drawing == MOVING)
            picture_moving(&image, i);
        else
            picture_noise(&image, (uint32_t)i);
        status = row->frame(encoder, &frame, e);
    }
    if (row->close(encoder, keep, &closing) && !status) {
        *e = closing;
        status = e->status;
    }
    image_free(&image);
    return status;
}

#endif
