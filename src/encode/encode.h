/* Writes finished frames to files; encoders are rows, chosen by the output's extension. */
#ifndef ENCODE_ENCODE_H
#define ENCODE_ENCODE_H

#include "base/error.h"
#include "base/image.h"
#include "base/variant.h"

#include <stdbool.h>
#include <stdint.h>

/* Accepted frames, for the encoder "reference". */
struct encode_reference {
    const char *const *paths; /* directories, or names as -o takes them; any one will do */
    size_t count;
    const char *gate;         /* row of the table "gates" */
    const char *page;         /* HTML to write, or NULL */
    bool update;              /* accept the frames instead of comparing them */
};

/* How a film is compressed (movie.codec and so on); NULL: as suits its codec. */
struct encode_video {
    const char *codec;        /* row of the table "codecs" */
    const char *crf, *preset, *tune;
    const char *pixel_format; /* as libavutil calls it */
    const char *options;      /* of the codec: "key=value key=value" */
};

struct encode_target {
    const char *path;      /* as given to -o */
    int width, height;     /* pixels */
    double fps;
    bool single;           /* one frame only: x.png is allowed without %d */
    const char *title, *comment; /* metadata; NULL: none */
    struct encode_video video;
    const char *const *columns; /* of rows: "time (s)" */
    size_t column_count;
    long frame_count;           /* of the whole film; an interrupted one has fewer */
    const struct encode_reference *reference; /* NULL: none */
};

struct encode_frame {
    long index;                /* from 0 */
    double time;               /* s */
    const struct image *image; /* NULL when the encoder does not want pixels */
    uint64_t state_hash;       /* of the particles; of encoders that want hashes */
};

struct encoder; /* each encoder's own state */
struct container; /* encode/container.h */

struct encoder_row {
    struct variant variant;
    const char *const *extensions; /* ".mp4", NULL-terminated; or the whole word "null", "hash" */
    const struct container *container; /* of a film; else NULL */
    bool wants_pixels;             /* false: the run may skip drawing altogether */
    bool wants_raw;                /* image->raw, too */
    bool wants_vectors;            /* image->plain and image->over, too */
    bool wants_hashes;             /* of states */
    bool wants_rows;               /* of measured numbers, by `row` */
    /* What only this encoder can say about a target before the run; writes nothing. May be NULL. */
    enum status (*check)(const struct encode_target *, struct error *);
    enum status (*open)(struct encoder **, const struct encode_target *, struct error *);
    /* May return before the frame is on disk; the image may be changed after it returns. */
    enum status (*frame)(struct encoder *, const struct encode_frame *, struct error *);
    /* A number for each column, on its way to the disk when it returns; may be called while `frame`
     * runs in another thread. NULL without wants_rows. */
    enum status (*row)(struct encoder *, const double *numbers, struct error *);
    /* keep: finish the file (also after SIGINT); else leave no trace but an earlier file intact.
     * Always frees. */
    enum status (*close)(struct encoder *, bool keep, struct error *);
};

/* "encoders": mp4, webm ... png, pdf, svg, csv, hash, null, reference */
extern const struct variant_table encode_table;

/* The row for an output name, or NULL with STATUS_USAGE naming the known extensions. */
const struct encoder_row *encode_find(const char *path, struct error *e);

/* Does the row write a file of that name, as against a name like "null" that stands for itself? */
bool encode_is_file(const struct encoder_row *row, const char *path);

/* Whether `has` says so of the row of any output; one that no encoder writes counts as none. */
bool encode_any(const char *const *outputs, size_t count, bool (*has)(const struct encoder_row *));

/* Checks before the run, without writing: directory exists and is writable, pattern is right,
 * encoder is in this build. */
enum status encode_check(const struct encode_target *target, struct error *e);

#endif
