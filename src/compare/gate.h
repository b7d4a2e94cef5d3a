/* Gates: sets of limits that two pictures keep to count as the same; rows of a table. */
#ifndef COMPARE_GATE_H
#define COMPARE_GATE_H

#include "compare/metric.h"

/* The limits in force. */
struct limits {
    double value[SCORES_MAX]; /* of each score; NAN: none */
    struct metric_settings settings;
};

extern const struct variant_table gate_table; /* "gates": same-stack (the default), ... */

/* The limits of the gate of that name; STATUS_USAGE with "did you mean" when there is none. */
enum status gate_limits(struct limits *limits, const char *name, struct error *e);

#endif
