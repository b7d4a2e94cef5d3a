/* Runs this program again, or another, as a child, with a limit of time, and kills it with us. */
#ifndef STUDY_PROCESS_H
#define STUDY_PROCESS_H

#include "base/error.h"

#include <stdbool.h>

struct process_end {
    int code;       /* exit code; 128 + N when signal N ended it */
    bool late;      /* it was stopped at its limit */
    double seconds; /* it ran */
};

/* Runs this program with the arguments (argv[0] is any, the last NULL), its messages into the file
 * `log`. STATUS_RUN when it cannot be started, STATUS_INTERRUPTED when we were told to stop. */
enum status process_run(const char *const *argv, const char *log, double limit,
                        struct process_end *end, struct error *e);

/* Whether PATH has a program of that name. */
bool process_found(const char *name);

/* The same for the program argv[0], found on PATH, in a directory. */
enum status process_run_other(const char *const *argv, const char *directory, const char *log,
                              struct process_end *end, struct error *e);

/* From now on SIGINT, SIGTERM and SIGHUP stop the present child, and process_run with it. One that the
 * caller ignores, as nohup does with SIGHUP, stays ignored, except SIGINT. */
void process_catch_signals(void);

/* Whether such a signal came. */
bool process_interrupted(void);

#endif
