/* Files to be written: checked before a run, claimed against other runs, whole or absent. */
#ifndef BASE_OUTPUT_H
#define BASE_OUTPUT_H

#include "base/error.h"

#include <stdbool.h>
#include <stdio.h>

/* STATUS_OUTPUT unless the directory of `path` can be written, and what has the name is a file. */
enum status output_check(const char *path, struct error *e);

/* Whether both name one file, or would once it is there. */
bool output_same(const char *a, const char *b);

/* Makes a directory and those above it, as mkdir -p. STATUS_OUTPUT. */
enum status output_make_directories(const char *path, struct error *e);

/* While a claim is held no other claim of the same path succeeds, in this program or another, under
 * whatever spelling of the directory. It is an advisory lock of PATH.lock: it ends with the process,
 * however that ends, and a file left behind by a kill hinders nobody. */
struct output_claim {
    char *path; /* of the lock file, or NULL */
    int file;
};

/* STATUS_OUTPUT when somebody else holds it. */
enum status output_claim(struct output_claim *claim, const char *path, struct error *e);
void output_release(struct output_claim *claim);

/* A file that is written as PATH.part and takes its name when it is whole and on the disk. */
struct output_file {
    FILE *stream;
    char *path, *part;
};

/* STATUS_OUTPUT, STATUS_RUN; then nothing is left open. */
enum status output_open(struct output_file *file, const char *path, struct error *e);

/* keep: to the disk and to its name; else, and on failure, no trace. Accepts a zeroed file. */
enum status output_close(struct output_file *file, bool keep, struct error *e);

#endif
