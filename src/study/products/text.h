/* Numbers and words as reports say them. */
#ifndef STUDY_TEXT_H
#define STUDY_TEXT_H

#include "study/cases/case.h"

#include <stddef.h>
#include <stdio.h>

extern const char text_none[]; /* where there is no number */

/* Four digits; counts below a hundred million whole. */
void text_number(double value, char *out, size_t size);

/* Three digits and the unit: "1.23 %" of 0.0123, "0.0012 m". */
void text_error(double value, const char *unit, char *out, size_t size);

/* The same of a point's error; of several runs their mean and standard deviation, "1.23 ± 0.4 %", and
 * how many there are where seeds are missing. */
void text_found(const struct study_error *error, char *out, size_t size);

/* A rung's value, of a number four digits. */
void text_value(const char *value, char *out, size_t size);

/* What Markdown would take for its own is said literally. */
void text_markdown(const char *text, FILE *out);

/* How many of the unit a value of 1 is: 100 percents, else 1. */
double text_scale(const char *unit);

#endif
