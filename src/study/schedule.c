/* Runs the points of a study in turns. */
#include "study/schedule.h"

#include "base/log.h"
#include "base/memory.h"
#include "base/output.h"
#include "study/process.h"
#include "study/record.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct schedule {
    const struct study *study;
    struct study_points *points;
    const char *directory;
    double start, budget; /* s */
};

static double time_left(const struct schedule *s)
{
    return s->budget - (clock_seconds() - s->start);
}

/* A run as long as that one with as many more particles: steps shrink with the spacing. */
static double scaled(double seconds, double from, double to)
{
    return from > 0 ? seconds * pow(to / from, 4.0 / 3) : seconds;
}

/* Seconds that a point may take, from the nearest smaller one of its method; NAN when unknown. */
static double predict(const struct schedule *s, const struct study_point *point)
{
    const struct study_point *nearest = NULL;
    for (size_t k = 0; k < s->points->count; k++) {
        const struct study_point *other = &s->points->items[k];
        if (other->method == point->method && other->repeats > 0 &&
            other->guess <= point->guess * 1.001 && (!nearest || other->guess > nearest->guess))
            nearest = other;
    }
    return point->repeats > 0 ? point->wall[0]
           : nearest          ? scaled(nearest->wall[0], nearest->guess, point->guess)
                              : (double)NAN;
}

static void leave_out(struct study_point *point, double needs, double left)
{
    point->outcome = OUTCOME_LEFT_OUT;
    if (left <= 0)
        snprintf(point->cause, sizeof point->cause, "the budget is used up");
    else
        snprintf(point->cause, sizeof point->cause,
                 "needs about %.3g s, and %.3g s of the budget are left", needs, left);
}

/* Makes a run, or finds it. Nothing is made once a run of the point failed. */
static enum status turn(struct schedule *s, struct study_point *point, int repeat, struct error *e)
{
    double left = time_left(s), limit = fmin(s->study->limit, left), needs = predict(s, point);
    if (repeat > 0 && (point->outcome != OUTCOME_DONE || point->wall[0] > REPEAT_LONGEST))
        return STATUS_OK;
    if (!record_load(point, s->directory, repeat, limit)) {
        if (left <= 0 || needs > left) {
            if (repeat == 0)
                leave_out(point, needs, left);
            return STATUS_OK;
        }
        if (record_make(point, s->directory, repeat, limit, e))
            return e->status;
        if (point->outcome == OUTCOME_LATE && limit < s->study->limit)
            snprintf(point->cause, sizeof point->cause,
                     "took longer than the %.3g s of the budget that were left", limit);
    }
    if (point->outcome == OUTCOME_DONE)
        return record_times(point, s->directory, repeat, e);
    if (repeat == 0) {
        log_info("%s: %s", point->folder, point->cause);
    } else if (point->outcome == OUTCOME_LATE) { /* the first was not; a repeat less is no failure */
        point->outcome = OUTCOME_DONE;
        point->cause[0] = 0;
    }
    return STATUS_OK;
}

static int by_size(const void *a, const void *b)
{
    const struct study_point *p = *(struct study_point *const *)a, *q = *(struct study_point *const *)b;
    if (!p->ladder != !q->ladder) /* the reference, which all need, first */
        return p->ladder ? 1 : -1;
    return p->guess != q->guess ? (p->guess > q->guess) - (p->guess < q->guess) : (p > q) - (p < q);
}

/* What is still to do, s, as far as it can be told. */
static double work_left(const struct schedule *s, struct study_point *const *order, size_t next,
                        int repeat)
{
    double sum = 0;
    for (size_t k = 0; k < s->points->count; k++) {
        double needs = predict(s, order[k]);
        int runs = s->study->repeats - repeat - (k < next);
        if (order[k]->wall[0] > REPEAT_LONGEST)
            runs = repeat == 0 && k >= next;
        if (!isnan(needs) && runs > 0)
            sum += runs * needs;
    }
    return sum;
}

static void progress(const struct schedule *s, struct study_point *const *order, size_t next,
                     int repeat)
{
    char note[160];
    double done = clock_seconds() - s->start;
    snprintf(note, sizeof note, "run %d of %d: %s", repeat + 1, s->study->repeats,
             order[next]->method ? order[next]->method->name : "reference");
    log_progress(done, fmin(done + work_left(s, order, next, repeat), s->budget), note);
}

enum status study_run(const struct study *study, struct study_points *points,
                      const char *directory, double budget, struct error *e)
{
    char runs[PATH_MAX];
    struct schedule s = {study, points, directory, clock_seconds(), budget};
    struct study_point **order = memory_create("study order", points->count, sizeof *order, e);
    if (!order)
        return e->status;
    for (size_t k = 0; k < points->count; k++)
        order[k] = &points->items[k];
    qsort(order, points->count, sizeof *order, by_size);
    snprintf(runs, sizeof runs, "%s/runs", directory);
    enum status status = output_make_directories(runs, e);
    process_catch_signals();
    for (int repeat = 0; repeat < study->repeats && !status; repeat++)
        for (size_t k = 0; k < points->count && !status; k++) {
            progress(&s, order, k, repeat);
            status = turn(&s, order[k], repeat, e);
        }
    log_progress_end();
    memory_free(order);
    return status;
}
