/* What a study leaves in its directory: tables, figures and pages. */
#ifndef STUDY_PRODUCTS_H
#define STUDY_PRODUCTS_H

#include "study/study.h"

#include <stdio.h>

/* Where and how the runs were made. */
struct study_about {
    const char *command;   /* that makes the study again */
    char date[32];         /* ISO 8601, UTC */
    double speed[2];       /* of a fixed loop before and after, multiply-adds a second */
};

struct study_results {
    const struct study *study;
    struct study_points *points;
    const struct study_about *about;
    const char *directory;
};

struct product_row {
    struct variant variant; /* the name is the file's */
    /* Writes below results->directory; STATUS_OUTPUT, STATUS_RUN. */
    enum status (*write)(const struct study_results *results, struct error *e);
};

extern const struct variant_table product_table; /* "products" */

/* All of them, in the table's order. */
enum status study_write(const struct study_results *results, struct error *e);

/* "done", "stopped" ... */
extern const char *const outcome_names[];

/* The names of the errors that have figures; returns their number, at most `most`. */
size_t study_plots(const struct study_results *results, const char **names, size_t most);

/* "isph, particles.spacing 0.05" */
void study_point_name(const struct study_point *point, char *out, size_t size);

/* The command that makes the point's run again, from the study's directory. */
void study_point_command(const struct study_point *point, FILE *out);

#endif
