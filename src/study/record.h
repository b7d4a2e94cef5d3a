/* One run on the disk: FOLDER/rK.json (the report), rK.csv, and rK.end, written last, how it ended. */
#ifndef STUDY_RECORD_H
#define STUDY_RECORD_H

#include "study/study.h"

#include <time.h>

/* "DIRECTORY/FOLDER/rK.SUFFIX" (malloc), or NULL when memory is short. */
char *record_path(const struct study_point *point, const char *directory, int repeat,
                  const char *suffix);

/* Whether the run is there; then *outcome and cause of the point are its own, and *had the time that it had, s.
 * One that was late counts only if that was at least `limit`. */
bool record_load(struct study_point *point, const char *directory, int repeat, double limit, double *had);

/* Runs the point for the `repeat`th time. STATUS_RUN, STATUS_OUTPUT, STATUS_INTERRUPTED; that the run
 * itself fails is an outcome. */
enum status record_make(struct study_point *point, const char *directory, int repeat, double limit,
                        struct error *e);

/* When the first run ended; 0: it is not there. */
time_t record_time(const struct study_point *point, const char *directory);

/* Appends the repeat's times, and checks that its last state is that of the others. STATUS_RUN. */
enum status record_times(struct study_point *point, const char *directory, int repeat,
                         struct error *e);

#endif
