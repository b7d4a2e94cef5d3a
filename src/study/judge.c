/* What a run did and how far it is from its references. */
#include "base/log.h"
#include "study/ensemble.h"
#include "study/reference/formula.h"
#include "study/record.h"
#include "study/report_read.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static enum status memory_short(struct error *e)
{
    return error_set(e, STATUS_RUN, "memory is short");
}

/* Change from first to last row over the scale; NAN without the column. */
static double drift(const struct columns *c, const char *name, double scale)
{
    const double *values = columns_find(c, name);
    return values && scale > 0 ? (values[c->rows - 1] - values[0]) / scale : (double)NAN;
}

static double largest(const struct columns *c, const char *name)
{
    const double *values = columns_find(c, name);
    double most = 0;
    for (size_t k = 0; values && k < c->rows; k++)
        most = fmax(most, fabs(values[k]));
    return most;
}

/* How far beyond a face of the domain a particle was; periodic faces have none beyond. */
static double largest_leak(const struct scene *scene, const struct columns *c)
{
    double leak = 0;
    for (int axis = 0; axis < 3; axis++) {
        char name[] = "kept-extent.x.min", other[] = "kept-extent.x.max";
        name[12] = other[12] = (char)('x' + axis);
        const double *low = columns_find(c, name), *high = columns_find(c, other);
        for (size_t k = 0; low && high && k < c->rows; k++)
            leak = fmax(leak, fmax(scene->domain.min[axis] - low[k],
                                   high[k] - scene->domain.max[axis]));
    }
    return leak;
}

/* Whether nothing outside pushes the fluid. */
static bool is_free(const struct scene *scene)
{
    bool is = scene->central_force.frequency == 0;
    for (int axis = 0; axis < 3; axis++)
        is = is && scene->gravity[axis] == 0;
    for (int face = 0; face < FACE_COUNT; face++)
        is = is && scene->domain.walls[face] == WALL_PERIODIC;
    return is;
}

/* Energy: of its largest part. Momentum: of all mass at the speed of the largest kinetic energy. */
static void judge_conservation(struct study_point *point, const struct columns *c)
{
    double kinetic = largest(c, "kept-energy.kinetic"), squares = 0, mass = 0;
    double scale = fmax(kinetic, fabs(drift(c, "kept-energy.potential", 1)));
    point->energy_drift = drift(c, "kept-energy.total", scale);
    point->leak = largest_leak(point->scene, c);
    for (size_t k = 0; k < point->scene->fluid_count; k++)
        mass = fmax(mass, point->scene->fluids[k].density);
    mass *= point->particles * pow(point->scene->particles.spacing, 3);
    for (int axis = 0; axis < 3; axis++) {
        static const char *const names[] = {"kept-momentum.x", "kept-momentum.y",
                                            "kept-momentum.z"};
        double change = drift(c, names[axis], 1);
        squares += change * change;
    }
    point->momentum_drift = kinetic > 0 && is_free(point->scene) ? sqrt(squares / (2 * mass * kinetic))
                                                                : (double)NAN;
}

/* The reference's values at the times of the run's rows. */
static enum status data_values(const struct columns *data, const char *name, const double *times,
                               size_t count, double *out, struct error *e)
{
    const double *values = columns_need(data, name, e);
    if (!values)
        return e->status;
    for (size_t k = 0; k < count; k++)
        out[k] = data->rows == 1 ? values[0]
                                 : columns_interpolate(columns_time(data), values, data->rows,
                                                       times[k]);
    return STATUS_OK;
}

static enum status reference_values(const struct study_asked *asked, const struct columns *c,
                                    const double *values, const struct columns *run, double *out,
                                    struct error *e)
{
    const double *times = columns_time(c);
    struct columns data;
    enum status status;
    switch (asked->kind) {
    case REFERENCE_VALUE:
    case REFERENCE_FIRST:
        for (size_t k = 0; k < c->rows; k++)
            out[k] = asked->kind == REFERENCE_FIRST ? values[0] : asked->value;
        return STATUS_OK;
    case REFERENCE_FORMULA: return formula_values(asked->formula, times, c->rows, out, e);
    case REFERENCE_RUN:
        return run ? data_values(run, asked->column, times, c->rows, out, e)
                   : error_set(e, STATUS_RUN, "the reference run is missing");
    case REFERENCE_DATA:
        status = columns_read(&data, asked->path, e);
        if (!status)
            status = data_values(&data, asked->reference_column, times, c->rows, out, e);
        columns_free(&data);
        return status;
    }
    return STATUS_OK;
}

/* Half the band of the data in the error's norm, at its own times; NAN without a band. */
static enum status data_spread(const struct study_asked *asked, double *spread, struct error *e)
{
    struct columns data = {0};
    const double *exact = NULL, *low = NULL, *high = NULL;
    double *shifted = NULL;
    *spread = (double)NAN;
    if (asked->kind != REFERENCE_DATA || !asked->low[0] || !asked->high[0])
        return STATUS_OK;
    enum status status = columns_read(&data, asked->path, e);
    if (!status && (!(exact = columns_need(&data, asked->reference_column, e)) ||
                    !(low = columns_need(&data, asked->low, e)) ||
                    !(high = columns_need(&data, asked->high, e))))
        status = e->status;
    if (!status && !(shifted = calloc(data.rows, sizeof *shifted)))
        status = memory_short(e);
    for (size_t k = 0; k < data.rows && !status; k++)
        shifted[k] = exact[k] + (high[k] - low[k]) / 2;
    if (!status)
        *spread = fabs(asked->norm->of(shifted, exact, data.rows));
    free(shifted);
    columns_free(&data);
    return status;
}

/* Compares where there is a reference: data need not reach over the whole run. */
static enum status judge_asked(const struct study_asked *asked, const struct columns *c,
                               const struct columns *run, struct study_errors *errors,
                               struct error *e)
{
    const double *values = columns_need(c, asked->column, e);
    size_t count = 0;
    double *exact = calloc(2 * c->rows, sizeof *exact), *found = exact ? exact + c->rows : NULL;
    if (!values || !exact) {
        free(exact);
        return values ? memory_short(e) : e->status;
    }
    double spread;
    enum status status = reference_values(asked, c, values, run, exact, e);
    if (!status)
        status = data_spread(asked, &spread, e);
    for (size_t k = 0; k < c->rows && !status; k++)
        if (!isnan(exact[k])) {
            exact[count] = exact[k];
            found[count++] = values[k];
        }
    if (!status && !count)
        status = error_set(e, STATUS_RUN, "%s: the reference has no value in the run's time",
                           asked->name);
    double error = status ? 0 : asked->norm->of(found, exact, count);
    if (!isfinite(error))
        status = error_set(e, STATUS_RUN, "%s: the reference is 0 or no number, and the error would be a part of it",
                           asked->name);
    if (!status) {
        study_error_add(errors, error, "%", asked->asked, "%s", asked->name);
        study_error_spread(errors, spread);
    }
    free(exact);
    return status;
}

static void read_counts(struct study_point *point, const struct json *report)
{
    point->particles = report_number(report, "particles");
    point->steps = report_number(report, "steps");
    point->rejected = report_number(report, "rejected");
    point->dt = report_number(report, "dt.mean");
    point->pairs = report_number(report, "pairs");
    point->bytes = report_number(report, "bytes.peak");
    point->iterations = report_number(report, "solves.velocity.mean");
}

/* That a run did not reach what is compared makes it stopped, not the study. */
static enum status judge_errors(const struct study *study, struct study_point *point,
                                const struct columns *c, const struct columns *run,
                                struct error *e)
{
    enum status status = STATUS_OK;
    if (study->known)
        status = study->known->compare(c, point->scene, &point->errors, e);
    for (size_t k = 0; k < study->asked_count && !status; k++)
        status = judge_asked(&study->asked[k], c, run, &point->errors, e);
    if (status != STATUS_RUN)
        return status;
    point->outcome = OUTCOME_STOPPED;
    snprintf(point->cause, sizeof point->cause, "%.390s", e->text);
    log_info("%s: %s", point->folder, point->cause);
    return e->status = STATUS_OK;
}

static enum status judge_point(const struct study *study, struct study_point *point,
                               const char *directory, const struct columns *reference,
                               struct error *e)
{
    struct json report = {0};
    struct columns columns = {0};
    char *path = record_path(point, directory, 0, "json");
    char *rows = record_path(point, directory, 0, "csv");
    enum status status = path && rows ? json_read_file(&report, path, e) : memory_short(e);
    if (!status)
        status = columns_read(&columns, rows, e);
    point->errors.count = 0;
    if (!status) {
        read_counts(point, &report);
        judge_conservation(point, &columns);
        if (point->ladder) /* the reference run is not compared */
            status = judge_errors(study, point, &columns, reference, e);
    }
    json_free(&report);
    columns_free(&columns);
    free(path);
    free(rows);
    return status;
}

enum status study_judge(const struct study *study, struct study_points *points,
                        const char *directory, struct error *e)
{
    struct columns reference = {0};
    bool has = false;
    enum status status = STATUS_OK;
    if (points->count && !points->items[0].ladder &&
        points->items[0].outcome == OUTCOME_DONE) {
        char *path = record_path(&points->items[0], directory, 0, "csv");
        status = path ? columns_read(&reference, path, e)
                      : error_set(e, STATUS_RUN, "memory is short");
        has = !status;
        free(path);
    }
    for (size_t k = 0; k < points->count && !status; k++) {
        struct study_point *point = &points->items[k], *members = point->members;
        size_t count = members ? point->member_count : 1;
        for (size_t m = 0; m < count && !status; m++) {
            struct study_point *run = members ? &members[m] : point;
            if (run->repeats > 0)
                status = judge_point(study, run, directory, has ? &reference : NULL, e);
        }
        ensemble_join(point);
    }
    columns_free(&reference);
    return status;
}
