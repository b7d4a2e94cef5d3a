/* Writes the mp4 container: first as fragments that survive a crash, then in final order. */
#ifndef ENCODE_MP4_FILE_H
#define ENCODE_MP4_FILE_H

#include "base/error.h"

#include <stdbool.h>

struct AVCodecContext;
struct AVPacket;

struct mp4_file; /* an open fragmented file: what was written so far plays after a crash */

/* Creates `path` for the stream of `codec`; STATUS_OUTPUT. `title` may be NULL. */
enum status mp4_file_open(struct mp4_file **file, const char *path,
                          const struct AVCodecContext *codec, const char *title, struct error *e);

/* Takes the packet's data; times in the codec's time base. STATUS_OUTPUT, also when an earlier
 * packet met a full disk. */
enum status mp4_file_write(struct mp4_file *file, struct AVPacket *packet, struct error *e);

/* Completes the file on disk (finish) or just lets go of it. Always frees. STATUS_OUTPUT. */
enum status mp4_file_close(struct mp4_file *file, bool finish, struct error *e);

/* Copies the stream of `from` into a plain mp4 `to` with its index first, on disk when it returns.
 * On failure `to` is removed; STATUS_OUTPUT. */
enum status mp4_file_reorder(const char *from, const char *to, const char *title, struct error *e);

#endif
