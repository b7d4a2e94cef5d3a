/* Files of one frame each, x-%04d.pdf, or one, x.pdf, that wait as NAME.new until the film is whole. */
#ifndef ENCODE_NUMBERED_H
#define ENCODE_NUMBERED_H

#include "base/output.h"
#include "base/sequence.h"
#include "encode/encode.h"

struct numbered {
    struct sequence names;
    long *frames; /* numbers of those that wait */
    size_t count, room;
};

/* The names that the target's path stands for, which ends in `ending`. STATUS_USAGE when all frames of
 * several would have one name. */
enum status numbered_names(struct sequence *names, const struct encode_target *target,
                           const char *ending, struct error *e);

/* Opens the waiting file of a frame; STATUS_OUTPUT, STATUS_RUN. */
enum status numbered_open(struct numbered *numbered, long index, struct output_file *file,
                          struct error *e);

/* Closes it: keep: it is whole. Else, and on failure, no trace. */
enum status numbered_close(struct numbered *numbered, long index, struct output_file *file, bool keep,
                           struct error *e);

/* keep: the files take their names; else they are removed. Frees what `numbered` holds. */
enum status numbered_end(struct numbered *numbered, bool keep, struct error *e);

#endif
