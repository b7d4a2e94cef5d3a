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
    const char *directory;
    double start, budget; /* s */
    int repeats;          /* of each run, as long as none is disturbed */
    struct study_point **runs; /* small to large, of all points the first seed, then the second ... */
    size_t count;
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
    for (size_t k = 0; k < s->count; k++) {
        const struct study_point *other = s->runs[k];
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

/* Whether the run is to be made for the `repeat`th time: more than asked only in place of what was disturbed. */
static bool is_wanted(const struct schedule *s, const struct study_point *point, int repeat)
{
    if (repeat == 0)
        return true;
    if (point->outcome != OUTCOME_DONE || point->wall[0] > REPEAT_LONGEST)
        return false;
    return repeat < s->repeats || study_calm(point) < s->repeats;
}

/* Makes a run, or finds it. Nothing is made once a run of the point failed. */
static enum status turn(struct schedule *s, struct study_point *point, int repeat, struct error *e)
{
    double left = time_left(s), limit = fmin(s->study->limit, left), needs = predict(s, point), had = limit;
    if (!is_wanted(s, point, repeat))
        return STATUS_OK;
    if (!record_load(point, s->directory, repeat, limit, &had)) {
        if (left <= 0 || needs > left) {
            if (repeat == 0)
                leave_out(point, needs, left);
            return STATUS_OK;
        }
        had = limit;
        if (record_make(point, s->directory, repeat, limit, e))
            return e->status;
    }
    if (point->outcome == OUTCOME_LATE && had < s->study->limit) { /* that is no fault of the run */
        point->outcome = OUTCOME_LEFT_OUT;
        snprintf(point->cause, sizeof point->cause, "took longer than the %.3g s of the budget that were left", had);
    }
    if (point->outcome == OUTCOME_DONE)
        return record_times(point, s->directory, repeat, e);
    if (repeat == 0) {
        log_info("%s: %s", point->folder, point->cause);
    } else if (point->outcome == OUTCOME_LATE || point->outcome == OUTCOME_LEFT_OUT) { /* the first was not; a repeat less is no failure */
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
static double work_left(const struct schedule *s, size_t next, int repeat)
{
    double sum = 0;
    for (size_t k = 0; k < s->count; k++) {
        double needs = predict(s, s->runs[k]);
        int runs = s->repeats - repeat - (k < next);
        if (s->runs[k]->wall[0] > REPEAT_LONGEST)
            runs = repeat == 0 && k >= next;
        if (!isnan(needs) && runs > 0)
            sum += runs * needs;
    }
    return sum;
}

static void progress(const struct schedule *s, size_t next, int repeat)
{
    char note[160];
    double done = clock_seconds() - s->start;
    const struct study_point *point = s->runs[next];
    if (repeat < s->repeats)
        snprintf(note, sizeof note, "run %d of %d: %s", repeat + 1, s->repeats,
                 point->method ? point->method->name : "reference");
    else
        snprintf(note, sizeof note, "again what was disturbed: %s",
                 point->method ? point->method->name : "reference");
    log_progress(done, fmin(done + work_left(s, next, repeat), s->budget), note);
}

/* What an earlier call knew is forgotten. */
static void add_run(struct schedule *s, struct study_point *run)
{
    run->outcome = OUTCOME_LEFT_OUT;
    run->cause[0] = 0;
    run->repeats = 0;
    s->runs[s->count++] = run;
}

/* The order of the runs; malloc'd for `memory_free`. */
static enum status order_runs(struct schedule *s, struct study_points *points, struct error *e)
{
    size_t seeds = (size_t)s->study->seeds, from;
    s->runs = memory_create("study order", points->count * seeds, sizeof *s->runs, e);
    for (size_t seed = 0; seed < seeds && s->runs; seed++) {
        from = s->count;
        for (size_t k = 0; k < points->count; k++) {
            struct study_point *point = &points->items[k];
            if (point->member_count)
                add_run(s, &point->members[seed]);
            else if (seed == 0)
                add_run(s, point);
        }
        qsort(s->runs + from, s->count - from, sizeof *s->runs, by_size);
    }
    return e->status;
}

enum status study_run(const struct study *study, struct study_points *points, const char *directory,
                      int repeats, double budget, struct error *e)
{
    char folder[PATH_MAX];
    struct schedule s = {study, directory, clock_seconds(), budget, repeats, NULL, 0};
    if (order_runs(&s, points, e))
        return e->status;
    snprintf(folder, sizeof folder, "%s/runs", directory);
    enum status status = output_make_directories(folder, e);
    process_catch_signals();
    for (int repeat = 0; repeat < 2 * repeats && !status; repeat++)
        for (size_t k = 0; k < s.count && !status; k++) {
            if (is_wanted(&s, s.runs[k], repeat))
                progress(&s, k, repeat);
            status = turn(&s, s.runs[k], repeat, e);
        }
    log_progress_end();
    memory_free(s.runs);
    return status;
}
