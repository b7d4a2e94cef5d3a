/* Names of numbered frames: x-%04d.png. */
#ifndef BASE_SEQUENCE_H
#define BASE_SEQUENCE_H

#include "base/error.h"

#include <limits.h>
#include <stddef.h>

enum { SEQUENCE_NAME = 2 * PATH_MAX + 32 }; /* room for a name */

/* "dir/x-" number of at least `digits` digits ".png"; no number when digits is 0. */
struct sequence {
    char before[PATH_MAX], after[PATH_MAX];
    int digits;
};

/* Reads %d or %0Nd once, in the file's name, and %% as a percent sign; STATUS_USAGE with a message
 * that begins with `what` and the path, STATUS_OUTPUT when the path is too long. */
enum status sequence_read(struct sequence *sequence, const char *what, const char *path,
                          struct error *e);

void sequence_name(const struct sequence *sequence, long index, char *name, size_t size);

/* The number of a file of that path, -1 when it is not one of the sequence. */
long sequence_number(const struct sequence *sequence, const char *path);

#endif
