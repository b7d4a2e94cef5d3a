/* Numbers out of a run's report. */
#ifndef STUDY_REPORT_READ_H
#define STUDY_REPORT_READ_H

#include "scene/json.h"

/* The number at a path of keys, "dt.mean"; NAN where there is none. */
double report_number(const struct json *report, const char *path);

/* The state hash of the last frame, 16 hex digits; "" without frames. */
void report_last_hash(const struct json *report, char hash[17]);

#endif
