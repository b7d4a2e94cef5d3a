/* The files that films are written to: muxers of libavformat, with every error of the disk caught. */
#ifndef ENCODE_CONTAINER_H
#define ENCODE_CONTAINER_H

#include "base/error.h"

#include <stdbool.h>

struct AVCodecContext;
struct AVPacket;

/* A kind of file; each has an encoder row of its own. */
struct container {
    const char *muxer;         /* as libavformat calls it */
    const char *options[4];    /* of the muxer: key, value; ended by NULL */
    const char *final_options[4]; /* the finished file is copied once more, with these; NULL: not */
    const char *const *codecs; /* rows of codec_table in preference order, ended by NULL */
    bool chooses;              /* movie.codec, crf, preset, tune and options are for it */
    bool formats;              /* movie.pixel_format is for it */
};

/* Texts about the film as a whole; NULL or empty: none. */
struct container_tags {
    const char *title, *comment;
};

/* Whether the file may have a stream of that encoder of libavcodec. */
bool container_holds(const struct container *container, const char *encoder);

struct container_file; /* an open file; of an mp4 what was written so far plays after a crash */

/* Creates `path`, or with "-" takes standard output, for the stream of `codec`. STATUS_OUTPUT. */
enum status container_open(struct container_file **file, const struct container *container,
                           const char *path, const struct AVCodecContext *codec,
                           const struct container_tags *tags, struct error *e);

/* Takes the packet's data; times in the codec's time base. STATUS_OUTPUT, also when an earlier
 * packet met a full disk. */
enum status container_write(struct container_file *file, struct AVPacket *packet,
                            struct error *e);

/* Completes the file on disk (finish) or just lets go of it. Always frees. STATUS_OUTPUT. */
enum status container_close(struct container_file *file, bool finish, struct error *e);

/* Copies the stream of `from` into a new file `to` with the final options, on disk when it returns.
 * On failure `to` is removed; STATUS_OUTPUT. */
enum status container_reorder(const struct container *container, const char *from, const char *to,
                              const struct container_tags *tags, struct error *e);

#endif
