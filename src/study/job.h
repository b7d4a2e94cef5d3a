/* A study from its file to what it leaves: read, run, judged, written. */
#ifndef STUDY_JOB_H
#define STUDY_JOB_H

#include "base/output.h"
#include "study/products/products.h"

#include <time.h>

struct job {
    struct study study;
    struct study_points points;
    struct study_about about;
    struct output_claim claim;
    const char *directory;
};

/* Reads and checks a study; nothing is written. `repeats`: of each point, 0: as the study says. The
 * command and the directory must outlive the job. STATUS_USAGE, STATUS_RUN. Close it, also after
 * failure. */
enum status job_open(struct job *job, const char *study, const char *directory, const char *command,
                     int repeats, struct error *e);

/* Claims the directory and runs what it does not have yet as far as the budget goes (s, or INFINITY), at most
 * `repeats` times each (0: as the study says). STATUS_OUTPUT, STATUS_INTERRUPTED, STATUS_RUN. */
enum status job_run(struct job *job, int repeats, double budget, struct error *e);

/* Whether the last call left something out. */
bool job_lacks(const struct job *job);

/* Judges what ran, and writes tables and figures. STATUS_OUTPUT, STATUS_RUN; STATUS_USAGE when figures are
 * asked for that cannot be. */
enum status job_write(struct job *job, struct error *e);
void job_close(struct job *job);

/* For products of several jobs. */
struct study_results job_results(struct job *job);

/* When something was measured. */
void about_date(struct study_about *about, time_t when);

#endif
