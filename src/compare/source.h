/* Where frames to compare come from: one picture, a set of files, or a film; read one by one. */
#ifndef COMPARE_SOURCE_H
#define COMPARE_SOURCE_H

#include "base/error.h"
#include "base/image.h"

#include <stdbool.h>

enum source_kind {
    SOURCE_PICTURE, /* a PNG file */
    SOURCE_NAMED,   /* the PNG files of a directory or of a glob pattern */
    SOURCE_SEQUENCE, /* x-%04d.png */
    SOURCE_FILM
};

/* By what frames of several sources belong together. */
enum source_order { SOURCE_ALONE, SOURCE_BY_NAME, SOURCE_BY_NUMBER };

/* Looks at the name and the file's first bytes; STATUS_USAGE when there is no such thing. */
enum status source_find(enum source_kind *kind, const char *path, struct error *e);

/* Pictures stand alone, films and sequences go by number, other sets by name; STATUS_USAGE when
 * the kinds do not fit each other. */
enum status source_order(enum source_order *order, const enum source_kind *kinds, size_t count,
                         struct error *e);

struct source {
    const struct source_row *row;
    void *state; /* the row's own */
    const char *path;
    /* The frame that comes next: */
    bool ended;
    long number;    /* from its name, or counted */
    char name[300]; /* of the file without its directory, or "frame 12" */
};

/* One way to read frames. */
struct source_row {
    /* `open` and `next` set the next frame, or `ended`. */
    enum status (*open)(struct source *, enum source_kind, enum source_order, struct error *);
    enum status (*next)(struct source *, struct error *);
    /* The picture of the next frame. */
    enum status (*read)(struct source *, struct image *, struct error *);
    void (*close)(struct source *); /* also after a failed open */
};

/* `path` must outlive the source. STATUS_USAGE, STATUS_BACKEND, STATUS_RUN. */
enum status source_open(struct source *source, const char *path, enum source_kind kind,
                        enum source_order order, struct error *e);
void source_close(struct source *source); /* accepts a zeroed one */

/* Frames of equal place belong together; an ended source is after all others. */
int source_compare(const struct source *a, const struct source *b, enum source_order order);

#endif
