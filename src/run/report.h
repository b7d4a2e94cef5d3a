/* What a run did, as JSON. */
#ifndef RUN_REPORT_H
#define RUN_REPORT_H

#include "run/film.h"
#include "run/simulation.h"

struct report_frame {
    long index;
    double time; /* s */
    uint64_t state_hash;
};

struct report {
    struct error end;   /* how the run ended */
    double wall, solve; /* s */
    struct film_times film;
    const char *renderer; /* or NULL */
    struct report_frame *frames;
    size_t frame_count;
    long row_count;       /* of measured numbers */
    double measure;       /* s */
};

/* Sum over the step's passes of their time, s. */
double report_pass_seconds(const struct backend_counts *counts);

/* Writes by way of PATH.part and rename; STATUS_OUTPUT. */
enum status report_write(const char *path, const struct report *report, struct simulation *s,
                         struct error *e);

/* The model name of the processor. */
const char *report_processor(void);

#endif
