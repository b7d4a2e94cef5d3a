/* What a method needs for an error, and errs after a time, between the rungs that were run. */
#ifndef STUDY_CROSSING_H
#define STUDY_CROSSING_H

#include "study/study.h"

enum crossing_kind {
    CROSSING_NONE,  /* nothing was measured */
    CROSSING_AT,    /* between two rungs, on straight lines of their logarithms */
    CROSSING_BELOW, /* less than `value`: outside of what was measured */
    CROSSING_ABOVE, /* more than `value` */
    CROSSING_NEVER  /* the error is not reached; `value` is the least error */
};

struct crossing {
    enum crossing_kind kind;
    double value; /* s, or an error */
};

/* One method on one ladder, and the name of an error. */
struct curve {
    const struct study_points *points;
    const struct study_ladder *ladder;
    const struct study_method *method;
    const char *error;
};

/* The least wall time by which |error| is at most `error`. */
struct crossing crossing_time(const struct curve *curve, double error);

/* |error| of a run of that wall time, s. */
struct crossing crossing_error(const struct curve *curve, double seconds);

/* "3.2 s", "< 3.2 s", "not reached, least 4.1 %"; `unit` is the error's. */
void crossing_time_text(const struct crossing *crossing, const char *unit, char *out, size_t size);
void crossing_error_text(const struct crossing *crossing, const char *unit, char *out, size_t size);

#endif
