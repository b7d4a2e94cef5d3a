/* Columns of numbers by name, as csv outputs and data files have them. */
#ifndef STUDY_COLUMNS_H
#define STUDY_COLUMNS_H

#include "base/error.h"

#include <stddef.h>

struct columns {
    char **names;    /* "energy.kinetic (J)"; of a data file as it says */
    double **values; /* values[column][row] */
    size_t count, rows;
};

/* Reads a csv file: a line of names, then rows of as many numbers; lines that begin with # are notes.
 * STATUS_USAGE with file and line. Free with columns_free, also after failure. */
enum status columns_read(struct columns *columns, const char *path, struct error *e);
void columns_free(struct columns *columns);

/* The values of the column of that name, with or without the unit in brackets behind it; NULL when
 * there is none. */
const double *columns_find(const struct columns *columns, const char *name);

/* The same, with STATUS_USAGE and the nearest name in `e` when there is none. */
const double *columns_need(const struct columns *columns, const char *name, struct error *e);

/* The first column, the time, s. */
const double *columns_time(const struct columns *columns);

/* The row of that time to a millionth of the last one's, or -1. */
long columns_row(const struct columns *columns, double time);

/* Value in that row of the columns NAME.0.PART, NAME.1.PART ..., as profiles and layers have them;
 * writes at most `most` and gives their number. */
size_t columns_line(const struct columns *columns, const char *name, const char *part, size_t row,
                    double *out, size_t most);

/* y at x of a piecewise linear curve with rising xs; NAN outside. */
double columns_interpolate(const double *xs, const double *ys, size_t count, double x);

#endif
