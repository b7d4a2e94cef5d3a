/* A validation case on a scene of scenes/validation, with the columns that its run would have. */
#ifndef TESTS_CASE_FIXTURE_H
#define TESTS_CASE_FIXTURE_H

#include "run/measure.h"
#include "run/run.h"
#include "study/cases/case.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

struct fixture {
    const struct case_row *row;
    struct scene *scene;
    struct columns columns;
    struct study_errors errors;
    struct error error;
};

static inline struct scene *scene_of(const char *name, const char *const *set, size_t count)
{
    struct scene_overrides overrides = {set, NULL, count};
    struct scene *scene;
    struct error e;
    char path[256];
    snprintf(path, sizeof path, "scenes/validation/%s.json", name);
    if (scene_load(&scene, path, &overrides, &run_vocabulary, &e))
        fail_msg("%s", e.text);
    return scene;
}

/* Loads the scene a second time, with what the case measures of it. */
static inline void load(struct fixture *f, const char *name, const char *const *set, size_t count)
{
    char *list;
    const char *all[8];
    size_t size;
    FILE *out = open_memstream(&list, &size);
    struct scene *bare = scene_of(name, set, count);
    if (case_check(f->row, bare, &f->error))
        fail_msg("%s", f->error.text);
    fputs("measure=[", out);
    f->row->measure(bare, out);
    fputs("]", out);
    fclose(out);
    for (size_t k = 0; k < count; k++)
        all[k] = set[k];
    all[count] = list;
    f->scene = scene_of(name, all, count + 1);
    scene_free(bare);
    free(list);
}

/* Names from the run's own measures, zeros; a row for each interval and one at the end. */
static inline void make_columns(struct fixture *f)
{
    struct measures measures;
    struct columns *c = &f->columns;
    double apart = f->row->interval(f->scene), end = f->scene->time.end;
    if (measures_create(&measures, f->scene, 1, &f->error))
        fail_msg("%s", f->error.text);
    c->count = measures.column_count;
    c->rows = (size_t)ceil(end / apart - 1e-9) + 1;
    c->names = calloc(c->count, sizeof *c->names);
    c->values = calloc(c->count, sizeof *c->values);
    for (size_t k = 0; k < c->count; k++) {
        c->names[k] = strdup(measures.columns[k]);
        c->values[k] = calloc(c->rows, sizeof **c->values);
    }
    for (size_t row = 0; row < c->rows; row++)
        c->values[0][row] = fmin((double)row * apart, end);
    measures_free(&measures);
}

/* Opens a case on a scene of scenes/validation with settings. */
static inline void open_with(struct fixture *f, const char *name, const char *scene,
                      const char *const *set, size_t count)
{
    *f = (struct fixture){.row = (const void *)variant_find(&case_table, name)};
    assert_non_null(f->row);
    load(f, scene, set, count);
    make_columns(f);
}

static inline void open_case(struct fixture *f, const char *name, const char *scene)
{
    open_with(f, name, scene, NULL, 0);
}

static inline void close_case(struct fixture *f)
{
    columns_free(&f->columns);
    scene_free(f->scene);
}

static inline double *values(struct fixture *f, const char *name)
{
    const double *found = columns_need(&f->columns, name, &f->error);
    if (!found)
        fail_msg("%s", f->error.text);
    return (double *)found;
}

/* Of NAME.k.PART */
static inline double *point(struct fixture *f, const char *name, int k, const char *part)
{
    char text[64];
    snprintf(text, sizeof text, "%s.%d.%s", name, k, part);
    return values(f, text);
}

static inline void scale(double *column, const struct fixture *f, double factor)
{
    for (size_t row = 0; row < f->columns.rows; row++)
        column[row] *= factor;
}

static inline void fill(double *column, const struct fixture *f, double value)
{
    for (size_t row = 0; row < f->columns.rows; row++)
        column[row] = value;
}

static inline void compare(struct fixture *f)
{
    f->errors.count = 0;
    if (f->row->compare(&f->columns, f->scene, &f->errors, &f->error))
        fail_msg("%s", f->error.text);
    assert_in_range(f->errors.count, 1, ERRORS_MAX - 1);
}

/* The error of that name. */
static inline void near(const struct fixture *f, const char *name, double wanted, double slack)
{
    for (size_t k = 0; k < f->errors.count; k++)
        if (strcmp(f->errors.items[k].name, name) == 0) {
            double got = f->errors.items[k].value;
            if (!(fabs(got - wanted) <= slack))
                fail_msg("%s: %s: %.12g is not %.12g to %g", f->row->variant.name, name, got,
                         wanted, slack);
            return;
        }
    fail_msg("%s has no error \"%s\"", f->row->variant.name, name);
}

/* Compares; no error is larger. */
static inline void all_below(struct fixture *f, double slack)
{
    compare(f);
    for (size_t k = 0; k < f->errors.count; k++)
        near(f, f->errors.items[k].name, 0, slack);
}

/* The comparison fails as a run that did not reach it. */
static inline void stops(struct fixture *f)
{
    assert_int_equal(f->row->compare(&f->columns, f->scene, &f->errors,
                                         &f->error), STATUS_RUN);
    assert_true(strlen(f->error.text) > 10);
}

#endif
