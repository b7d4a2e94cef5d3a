/* A study file that is being read, part by part. */
#ifndef STUDY_READING_H
#define STUDY_READING_H

#include "study/read_value.h"
#include "study/set.h"

struct reading {
    struct study *study;
    struct json doc;
    struct error *e;
};

/* Record the message, the first without a place; return the status. */
enum status reading_memory(struct reading *r);
enum status reading_fail(struct reading *r, int node, const char *text);

/* The member as settings, appended; none: nothing. */
enum status reading_set(struct reading *r, int object, const char *key, struct study_set *set);

/* The object of lists of the member, at least one, each of at least one value; lists->object is -1 when
 * it is not there. */
enum status reading_lists(struct reading *r, int object, const char *key, bool needed,
                          struct set_lists *lists);

/* The parts of a study. Errors need case and reference, ladders need errors. STATUS_USAGE, STATUS_RUN. */
enum status read_methods(struct reading *r);
enum status read_ladders(struct reading *r);
enum status read_errors(struct reading *r);

/* A path, which in the file is from the file's directory; malloc. */
enum status reading_path(struct reading *r, int object, const char *key, bool needed, char **out);

#endif
