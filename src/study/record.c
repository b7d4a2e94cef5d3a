/* Makes one run of a point, and finds it again. */
#include "study/record.h"

#include "base/output.h"
#include "run/run.h"
#include "study/process.h"
#include "study/report_read.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

char *record_path(const struct study_point *point, const char *directory, int repeat,
                  const char *suffix)
{
    char *path = NULL;
    if (asprintf(&path, "%s/%s/r%d.%s", directory, point->folder, repeat, suffix) < 0)
        return NULL;
    return path;
}

bool record_load(struct study_point *point, const char *directory, int repeat, double limit, double *had)
{
    int outcome, length = 0;
    char line[sizeof point->cause + 64] = "";
    char *path = record_path(point, directory, repeat, "end");
    FILE *file = path ? fopen(path, "r") : NULL;
    free(path);
    if (!file)
        return false;
    size_t size = fread(line, 1, sizeof line - 1, file);
    line[size] = 0;
    fclose(file);
    if (sscanf(line, "%d %lf %n", &outcome, had, &length) < 2 ||
        (outcome == OUTCOME_LATE && *had < limit))
        return false;
    point->outcome = (enum outcome)outcome;
    snprintf(point->cause, sizeof point->cause, "%s", line + length);
    point->cause[strcspn(point->cause, "\n")] = 0;
    return true;
}

time_t record_time(const struct study_point *point, const char *directory)
{
    struct stat about = {.st_mtime = 0};
    char *path = record_path(point, directory, 0, "end");
    if (path && stat(path, &about))
        about.st_mtime = 0;
    free(path);
    return about.st_mtime;
}

/* The last line that the run said, without the program's name. */
static void last_message(const char *path, char *out, size_t size)
{
    char line[1024], *colon;
    FILE *file = fopen(path, "r");
    while (file && fgets(line, sizeof line, file)) {
        line[strcspn(line, "\n")] = 0;
        colon = strstr(line, "error: ");
        if (line[0])
            snprintf(out, size, "%.390s", colon ? colon + 7 : line);
    }
    if (file)
        fclose(file);
}

static void judge_end(struct study_point *point, const struct process_end *end, double limit,
                      const char *log)
{
    point->cause[0] = 0;
    point->outcome = end->late                 ? OUTCOME_LATE
                     : end->code == STATUS_OK  ? OUTCOME_DONE
                     : end->code < 128         ? OUTCOME_STOPPED
                                               : OUTCOME_CRASHED; /* by a signal */
    if (point->outcome == OUTCOME_LATE)
        snprintf(point->cause, sizeof point->cause, "took longer than %.4g s", limit);
    else if (point->outcome != OUTCOME_DONE) {
        snprintf(point->cause, sizeof point->cause, "exit code %d", end->code);
        last_message(log, point->cause, sizeof point->cause);
    }
}

static enum status write_end(const struct study_point *point, const char *path, double limit,
                             struct error *e)
{
    struct output_file file;
    if (output_open(&file, path, e))
        return e->status;
    fprintf(file.stream, "%d %.17g %s\n", point->outcome, limit, point->cause);
    return output_close(&file, true, e);
}

/* Folder and scene of the point, unless they are there. */
static enum status prepare(const struct study_point *point, const char *directory, char **scene,
                           struct error *e)
{
    char folder[4096];
    snprintf(folder, sizeof folder, "%s/%s", directory, point->folder);
    if (mkdir(folder, 0777) && errno != EEXIST)
        return error_set(e, STATUS_OUTPUT, "%s: %s", folder, strerror(errno));
    if (asprintf(scene, "%s/scene.json", folder) < 0) {
        *scene = NULL;
        return error_set(e, STATUS_RUN, "memory is short");
    }
    return scene_save(point->scene, &run_vocabulary, *scene, e);
}

enum status record_make(struct study_point *point, const char *directory, int repeat, double limit,
                        struct error *e)
{
    char *scene = NULL, threads[16], *picture = NULL;
    char *rows = record_path(point, directory, repeat, "csv");
    char *report = record_path(point, directory, repeat, "json");
    char *log = record_path(point, directory, repeat, "log");
    char *ended = record_path(point, directory, repeat, "end");
    struct process_end end;
    enum status status = prepare(point, directory, &scene, e);
    snprintf(threads, sizeof threads, "%d", point->threads);
    if (asprintf(&picture, "%s/%s/frame-%%04d.png", directory, point->folder) < 0)
        picture = NULL;
    if (!status && !(rows && report && log && ended && picture))
        status = error_set(e, STATUS_RUN, "memory is short");
    const char *argv[] = {"sph-render", scene, "-q", "-o", rows, "-o", repeat ? "null" : picture,
                          "--report", report, "--threads", threads, "--isa", point->isa,
                          "--backend", point->backend, NULL};
    if (!status)
        status = process_run(argv, log, limit, &end, e);
    if (!status) {
        judge_end(point, &end, limit, log);
        if (repeat > 0)
            remove(rows);
        status = write_end(point, ended, limit, e);
    }
    free(scene);
    free(picture);
    free(rows);
    free(report);
    free(log);
    free(ended);
    return status;
}

enum status record_times(struct study_point *point, const char *directory, int repeat,
                         struct error *e)
{
    struct json report = {0};
    char hash[17];
    char *path = record_path(point, directory, repeat, "json");
    if (!path)
        return error_set(e, STATUS_RUN, "memory is short");
    enum status status = json_read_file(&report, path, e);
    if (!status) {
        report_last_hash(&report, hash);
        if (point->repeats == 0)
            strcpy(point->hash, hash);
        else if (strcmp(point->hash, hash) != 0)
            status = error_set(e, STATUS_RUN, "%s: the last state is %s, but that of another run of the "
                               "same scene was %s; this is a defect of the program or the machine",
                               path, hash, point->hash);
        point->wall[point->repeats] = report_number(&report, "seconds.solve");
        point->cpu[point->repeats++] = report_number(&report, "seconds.cpu");
    }
    json_free(&report);
    free(path);
    return status;
}
