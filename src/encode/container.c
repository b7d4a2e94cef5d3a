/* Writes films' files through libavformat, with every error of the disk caught. */
#include "encode/container.h"

#if HAVE_LIBAV

#include "base/libav.h"

#include <errno.h>
#include <fcntl.h>
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct container_file {
    AVFormatContext *format;
    AVRational time_base; /* of the packets that come */
    char *path;           /* for messages */
    bool is_pipe;
};

bool container_holds(const struct container *container, const char *encoder)
{
    const AVOutputFormat *format = av_guess_format(container->muxer, NULL, NULL);
    const AVCodec *codec = avcodec_find_encoder_by_name(encoder);
    return format && codec && avformat_query_codec(format, codec->id, FF_COMPLIANCE_NORMAL) == 1;
}

/* Makes sure that the bytes of a closed file are on the disk. */
static enum status sync_path(const char *path, struct error *e)
{
    int file = open(path, O_RDONLY | O_CLOEXEC);
    int code = file < 0 ? -1 : fsync(file);
    int reason = errno;
    if (file >= 0)
        close(file);
    return code ? error_set(e, STATUS_OUTPUT, "%s: %s", path, strerror(reason)) : STATUS_OK;
}

/* A full disk is remembered in the I/O context, and may be missing in the code of a call. */
static int worst(const AVFormatContext *format, int code)
{
    return code < 0 ? code : format->pb && format->pb->error < 0 ? format->pb->error : 0;
}

static void file_free(struct container_file *file)
{
    if (file->format && file->format->pb)
        avio_closep(&file->format->pb);
    avformat_free_context(file->format);
    free(file->path);
    free(file);
}

/* Makes a writer with one stream, not yet opened; the name gets "file:" in front since a colon in it
 * would otherwise be read as a protocol. */
static enum status file_create(struct container_file **made, const struct container *container,
                               const char *path, struct error *e)
{
    bool is_pipe = strcmp(path, "-") == 0;
    struct container_file *file = calloc(1, sizeof *file);
    char *url = NULL;
    libav_quiet();
    *made = NULL;
    if (!file || !(file->path = strdup(is_pipe ? "standard output" : path)) ||
        asprintf(&url, is_pipe ? "pipe:1" : "file:%s", path) < 0)
        goto memory;
    file->is_pipe = is_pipe;
    int code = avformat_alloc_output_context2(&file->format, NULL, container->muxer, url);
    if (code < 0) {
        libav_error(e, STATUS_BACKEND, code, "%s: no writer of %s in this machine's libavformat",
                    path, container->muxer);
        goto fail;
    }
    if (!avformat_new_stream(file->format, NULL))
        goto memory;
    file->format->flags |= AVFMT_FLAG_BITEXACT | AVFMT_FLAG_FLUSH_PACKETS;
    free(url);
    *made = file;
    return STATUS_OK;
memory:
    error_set(e, STATUS_RUN, "%s: no memory", path);
fail:
    free(url);
    if (file)
        file_free(file);
    return e->status;
}

static void set_tag(AVFormatContext *format, const char *key, const char *text)
{
    if (text && *text)
        av_dict_set(&format->metadata, key, text, 0);
}

/* Creates the file and writes its header with the given options: key, value, ended by NULL. */
static enum status file_begin(struct container_file *file, const char *const *said,
                              const struct container_tags *tags, struct error *e)
{
    AVFormatContext *format = file->format;
    AVDictionary *options = NULL;
    int code = avio_open(&format->pb, format->url, AVIO_FLAG_WRITE);
    if (code < 0)
        return libav_error(e, STATUS_OUTPUT, code, "%s", file->path);
    set_tag(format, "title", tags->title);
    set_tag(format, "comment", tags->comment);
    for (; *said; said += 2)
        av_dict_set(&options, said[0], said[1], 0);
    code = worst(format, avformat_write_header(format, &options));
    if (code >= 0 && av_dict_count(options))
        code = AVERROR_OPTION_NOT_FOUND;
    av_dict_free(&options);
    if (code < 0)
        return libav_error(e, STATUS_OUTPUT, code, "%s: cannot write the header", file->path);
    return STATUS_OK;
}

enum status container_open(struct container_file **made, const struct container *container,
                           const char *path, const AVCodecContext *codec,
                           const struct container_tags *tags, struct error *e)
{
    struct container_file *file;
    if (file_create(&file, container, path, e))
        return e->status;
    AVStream *stream = file->format->streams[0];
    int code = avcodec_parameters_from_context(stream->codecpar, codec);
    stream->time_base = file->time_base = codec->time_base;
    stream->avg_frame_rate = stream->r_frame_rate = codec->framerate;
    stream->sample_aspect_ratio = codec->sample_aspect_ratio;
    if (code < 0)
        libav_error(e, STATUS_OUTPUT, code, "%s", path);
    else
        code = file_begin(file, container->options, tags, e) ? AVERROR(EIO) : 0;
    if (code < 0) {
        bool is_pipe = file->is_pipe;
        file_free(file);
        if (!is_pipe)
            unlink(path);
        return e->status;
    }
    *made = file;
    return STATUS_OK;
}

enum status container_write(struct container_file *file, AVPacket *packet, struct error *e)
{
    AVStream *stream = file->format->streams[0];
    av_packet_rescale_ts(packet, file->time_base, stream->time_base);
    packet->stream_index = 0;
    int code = worst(file->format, av_interleaved_write_frame(file->format, packet));
    return code < 0 ? libav_error(e, STATUS_OUTPUT, code, "%s", file->path) : STATUS_OK;
}

enum status container_close(struct container_file *file, bool finish, struct error *e)
{
    int code = 0;
    enum status status = STATUS_OK;
    if (finish) {
        code = worst(file->format, av_write_trailer(file->format));
        if (code >= 0) {
            avio_flush(file->format->pb);
            code = worst(file->format, 0);
        }
    }
    int closed = avio_closep(&file->format->pb);
    code = code < 0 ? code : closed;
    if (finish && code < 0)
        status = libav_error(e, STATUS_OUTPUT, code, "%s", file->path);
    else if (finish && !file->is_pipe)
        status = sync_path(file->path, e);
    file_free(file);
    return status;
}

/* Opens the fragments for reading; their first packet is the next that av_read_frame gives. */
static enum status open_fragments(AVFormatContext **input, const char *path, struct error *e)
{
    char *url = NULL;
    if (asprintf(&url, "file:%s", path) < 0)
        return error_set(e, STATUS_RUN, "%s: no memory", path);
    int code = avformat_open_input(input, url, NULL, NULL);
    free(url);
    if (code >= 0)
        code = avformat_find_stream_info(*input, NULL);
    if (code >= 0 && (*input)->nb_streams != 1)
        code = AVERROR_INVALIDDATA;
    return code < 0 ? libav_error(e, STATUS_OUTPUT, code, "%s", path) : STATUS_OK;
}

/* Copies all packets, with the time of the first picture moved to 0. */
static enum status copy_packets(AVFormatContext *input, struct container_file *file, struct error *e)
{
    AVPacket *packet = av_packet_alloc();
    int64_t start = AV_NOPTS_VALUE;
    int code = packet ? 0 : AVERROR(ENOMEM);
    enum status status = STATUS_OK;
    while (!status && code >= 0 && (code = av_read_frame(input, packet)) >= 0) {
        if (start == AV_NOPTS_VALUE)
            start = packet->pts;
        packet->pts -= start;
        packet->dts -= start;
        packet->pos = -1;
        status = container_write(file, packet, e);
    }
    av_packet_free(&packet);
    if (!status && code != AVERROR_EOF)
        status = libav_error(e, STATUS_OUTPUT, code, "%s: cannot read it back", file->path);
    return status;
}

enum status container_reorder(const struct container *container, const char *from, const char *to,
                              const struct container_tags *tags, struct error *e)
{
    AVFormatContext *input = NULL;
    struct container_file *file = NULL;
    enum status status = file_create(&file, container, to, e);
    if (!status)
        status = open_fragments(&input, from, e);
    if (!status) {
        const AVStream *source = input->streams[0];
        AVStream *stream = file->format->streams[0];
        int code = avcodec_parameters_copy(stream->codecpar, source->codecpar);
        stream->time_base = file->time_base = source->time_base;
        stream->avg_frame_rate = source->avg_frame_rate;
        stream->sample_aspect_ratio = source->sample_aspect_ratio;
        if (code < 0)
            status = libav_error(e, STATUS_OUTPUT, code, "%s", to);
    }
    if (!status)
        status = file_begin(file, container->final_options, tags, e);
    if (!status)
        status = copy_packets(input, file, e);
    avformat_close_input(&input);
    struct error closing;
    if (file && container_close(file, !status, &closing) && !status) {
        *e = closing;
        status = closing.status;
    }
    if (status)
        unlink(to);
    return status;
}

#endif
