/* Validation cases: what each measures of its scene, and its errors against what is known. */
#ifndef STUDY_CASE_H
#define STUDY_CASE_H

#include "base/variant.h"
#include "scene/scene.h"
#include "study/reference/columns.h"

#include <stdio.h>

enum { ERRORS_MAX = 32 };

/* One error of a run against a reference. */
struct study_error {
    char name[96];    /* "kinetic energy at t = 1 s" */
    double value;     /* with its sign where it has one */
    const char *unit; /* "%": a part of the reference, printed times 100; "m" ...; "" for none */
    double asked;     /* bound of |value| that is aimed at; NAN: none */
    double spread;    /* of the reference by experiments, as |value| would be; NAN: none */
    int runs, seeds;  /* from different seeds, that `value` is the mean of, of so many; 0: it is of one run */
    double size, deviation, least, most; /* of those: mean |value|, standard deviation, least and most |value| */
};

/* What counts as the error's size: |value|, of several runs the mean of theirs. */
double study_error_amount(const struct study_error *error);

struct study_errors {
    struct study_error items[ERRORS_MAX];
    size_t count;
};

struct case_row {
    struct variant variant; /* the doc says what is compared, and the source of the reference */
    double (*interval)(const struct scene *scene); /* s between rows */
    /* What a scene with a body must have and this one has not, "a viscosity"; NULL: nothing. */
    const char *(*lacks)(const struct scene *scene);
    /* Writes the elements of the scene's list "measure" as JSON, without brackets. */
    void (*measure)(const struct scene *scene, FILE *out);
    /* STATUS_RUN with the reason when the run did not reach what is compared. */
    enum status (*compare)(const struct columns *columns, const struct scene *scene,
                           struct study_errors *errors, struct error *e);
};

extern const struct variant_table case_table; /* "cases" */

/* STATUS_USAGE with the reason when the case is not for such a scene. The functions of a row are only
 * for scenes that pass. */
enum status case_check(const struct case_row *row, const struct scene *scene, struct error *e);

/* Appends an error; what a table cannot hold is a programming mistake and left out. */
void study_error_add(struct study_errors *errors, double value, const char *unit, double asked,
                     const char *format, ...) __attribute__((format(printf, 5, 6)));

/* Sets the spread of the last one that was added. */
void study_error_spread(struct study_errors *errors, double spread);

#endif
