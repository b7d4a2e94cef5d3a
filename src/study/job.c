/* Takes a study from its file to what it leaves. */
#include "study/job.h"

#include "base/log.h"
#include "study/map/map.h"
#include "study/record.h"
#include "study/schedule.h"

#include <time.h>

/* Multiply-adds a second of a fixed chain of them: how fast the machine is now. */
static double machine_speed(void)
{
    enum { ROUNDS = 20000000 };
    volatile float seed = 1.0f;
    float x = seed, start_value = x;
    double start = clock_seconds();
    for (int k = 0; k < ROUNDS; k++)
        x = x * 0.999999f + 1e-6f;
    seed = x + start_value;
    return ROUNDS / (clock_seconds() - start);
}

static enum status check_plots(const struct study *study, const struct study_points *points,
                               struct error *e)
{
    bool any = false;
    for (size_t k = 0; k < points->count; k++)
        any = any || points->items[k].errors.count;
    for (size_t k = 0; k < study->plot_count && any; k++)
        if (!study_error_known(points, study->plots[k]))
            return error_set(e, STATUS_USAGE, "%s: \"plot\" names \"%s\", but there is no such error; "
                             "results.csv has their names", study->path, study->plots[k]);
    return STATUS_OK;
}

void about_date(struct study_about *about, time_t when)
{
    struct tm parts;
    strftime(about->date, sizeof about->date, "%Y-%m-%dT%H:%M:%SZ", gmtime_r(&when, &parts));
}

/* The time of the last of the first runs: what is found again was not measured now. */
static void date_runs(struct job *job)
{
    time_t last = 0;
    for (size_t k = 0; k < job->points.count; k++) {
        const struct study_point *point = &job->points.items[k];
        time_t made = record_time(point->member_count ? &point->members[0] : point, job->directory);
        last = made > last ? made : last;
    }
    about_date(&job->about, last ? last : time(NULL));
}

static enum status write_map(const struct study_results *results, struct error *e)
{
    struct map map;
    bool drawn;
    if (map_make(&map, results, e) == STATUS_OK && map_write(&map, results, e) == STATUS_OK)
        map_plot(&map, results->directory, &drawn, e);
    map_free(&map);
    return e->status;
}

struct study_results job_results(struct job *job)
{
    return (struct study_results){&job->study, &job->points, &job->about, job->directory};
}

enum status job_open(struct job *job, const char *study, const char *directory, const char *command,
                     int repeats, struct error *e)
{
    *job = (struct job){.about = {.command = command}, .claim = {NULL, -1}, .directory = directory};
    if (study_read(&job->study, study, e))
        return e->status;
    if (repeats)
        job->study.repeats = repeats;
    return study_points_create(&job->points, &job->study, e);
}

enum status job_run(struct job *job, int repeats, double budget, struct error *e)
{
    if (job->claim.file < 0 && (output_make_directories(job->directory, e) ||
                              output_claim(&job->claim, job->directory, e)))
        return e->status;
    if (!(job->about.speed[0] > 0))
        job->about.speed[0] = machine_speed();
    if (repeats == 0 || repeats > job->study.repeats)
        repeats = job->study.repeats;
    if (study_run(&job->study, &job->points, job->directory, repeats, budget, e))
        return e->status;
    job->about.speed[1] = machine_speed();
    return STATUS_OK;
}

bool job_lacks(const struct job *job)
{
    bool lacks = false;
    for (size_t k = 0; k < job->points.count; k++) {
        const struct study_point *point = &job->points.items[k];
        for (size_t m = 0; m < point->member_count; m++)
            lacks = lacks || point->members[m].outcome == OUTCOME_LEFT_OUT;
        lacks = lacks || (!point->member_count && point->outcome == OUTCOME_LEFT_OUT);
    }
    return lacks;
}

enum status job_write(struct job *job, struct error *e)
{
    struct study_results results = job_results(job);
    if (study_judge(&job->study, &job->points, job->directory, e))
        return e->status;
    date_runs(job);
    if (job->study.is_map)
        return write_map(&results, e);
    if (study_write(&results, e))
        return e->status;
    return check_plots(&job->study, &job->points, e);
}

void job_close(struct job *job)
{
    output_release(&job->claim);
    study_points_free(&job->points);
    study_free(&job->study);
}
