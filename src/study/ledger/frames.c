/* Rows of a ledger that are about frames: runs of this program with and without an output. */
#include "base/fnv.h"
#include "study/ledger/ledger.h"
#include "study/ledger/looks.h"
#include "study/process.h"
#include "study/report_read.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* What a run's report says. */
struct frames_run {
    double phases;     /* s, of the feature */
    double bytes;      /* at the most */
    double particles, frames;
    char hash[17];     /* of the last state */
    uint64_t pictures; /* of what was said of all frames */
};

/* Sum of the report's times of the words "a|b". */
static double phase_seconds(const struct json *report, const char *words)
{
    double sum = 0;
    for (size_t n; *words; words += n + (words[n] == '|')) {
        char path[64];
        n = strcspn(words, "|");
        snprintf(path, sizeof path, "seconds.%.*s", (int)n, words);
        double seconds = report_number(report, path);
        sum += isnan(seconds) ? 0 : seconds;
    }
    return sum;
}

static enum status read_run(const char *path, const char *phases, struct frames_run *run,
                            struct error *e)
{
    struct json report = {0};
    enum status status = json_read_file(&report, path, e);
    if (!status) {
        int frames = json_member(&report, 0, "frames");
        run->phases = phase_seconds(&report, phases);
        run->bytes = report_number(&report, "bytes.peak");
        run->particles = report_number(&report, "particles");
        run->frames = frames < 0 ? 0 : report.nodes[frames].size;
        report_last_hash(&report, run->hash);
    }
    json_free(&report);
    return status;
}

/* The last line of the program's own messages. */
static void read_reason(const char *log, char *out, size_t size)
{
    char line[1024];
    FILE *file = fopen(log, "r");
    while (file && fgets(line, sizeof line, file)) {
        char *text = strstr(line, "error: ");
        line[strcspn(line, "\n")] = 0;
        snprintf(out, size, "%.390s", text ? text + 7 : line);
    }
    if (file)
        fclose(file);
}

/* Of a file's bytes; 0 when it cannot be read. */
static uint64_t file_hash(const char *path)
{
    char block[4096];
    uint64_t hash = FNV_START;
    size_t size;
    FILE *file = fopen(path, "r");
    while (file && (size = fread(block, 1, sizeof block, file)) > 0)
        hash = fnv_bytes(hash, block, size);
    if (file)
        fclose(file);
    return file ? hash : 0;
}

/* "KEY=VALUE KEY=VALUE" into arguments; copy holds them. */
static void add_arguments(const char **argv, size_t *n, const char *settings, char *copy, size_t size)
{
    char *rest = copy, *item;
    snprintf(copy, size, "%s", settings ? settings : "");
    while ((item = strtok_r(rest, " ", &rest))) {
        argv[(*n)++] = "--set";
        argv[(*n)++] = item;
    }
}

/* A run of the scene to `end` with LEDGER_FRAMES frames after the first into the output. */
static enum status make_run(const struct ledger *ledger, const char *output, const char *color,
                            const char *settings, const char *phases, double end, char *reason, size_t size,
                            struct frames_run *run, struct error *e)
{
    const struct ledger_options *o = ledger->options;
    char copy[KEY_TEXT_SIZE];
    const char *argv[2 * LEDGER_SETS_MAX + 32] = {"sph-render", o->scene, "-q"};
    char report[4096], log[4096], ends[64], speed[64], threads[16];
    struct process_end ended;
    size_t n = 3;
    for (size_t k = 0; k < o->set_count; k++) {
        argv[n++] = "--set";
        argv[n++] = o->sets[k];
    }
    snprintf(report, sizeof report, "%s/frames/report.json", o->directory);
    snprintf(log, sizeof log, "%s/frames/log", o->directory);
    snprintf(ends, sizeof ends, "time.end=%.17g", end);
    snprintf(speed, sizeof speed, "movie.speed=%.17g", end / LEDGER_FRAMES * 30 * (1 - 1e-12));
    snprintf(threads, sizeof threads, "%d", o->threads);
    const char *const more[] = {"--set", ends, "--set", speed, "--set", "movie.fps=30", "--set",
                                "movie.start=0", "-o", output, "--report", report, "--threads", threads};
    for (size_t k = 0; k < sizeof more / sizeof *more; k++)
        argv[n++] = more[k];
    add_arguments(argv, &n, settings, copy, sizeof copy);
    if (color) {
        argv[n++] = "--color";
        argv[n++] = color;
    }
    argv[n] = NULL;
    if (process_run(argv, log, INFINITY, &ended, e))
        return e->status;
    run->pictures = file_hash(log); /* that of -o hash */
    if (!ended.code)
        return read_run(report, phases, run, e);
    snprintf(reason, size, "exit code %d", ended.code);
    read_reason(log, reason, size);
    return STATUS_OK;
}

/* Drawn as the scene says, with the neutral value said, and with the feature. */
static enum status measure_look(const struct ledger *ledger, struct ledger_row *row, double end, struct error *e)
{
    const struct feature_row *feature = row->feature;
    struct frames_run plain, runs[2];
    if (make_run(ledger, feature->output, NULL, NULL, feature->phases, end, row->reason, sizeof row->reason, &plain,
                 e) || row->reason[0])
        return e->status;
    for (int k = 0; k < ledger->options->repeats; k++) {
        for (int on = 0; on < 2; on++)
            if (make_run(ledger, feature->output, NULL, feature->settings[on ? STRENGTH_ON : STRENGTH_OFF],
                         feature->phases, end, row->reason, sizeof row->reason, &runs[on], e) || row->reason[0])
                return e->status;
        row->without = fmin(row->without, 1e9 / runs[0].particles / runs[0].frames * runs[0].phases);
        row->with = fmin(row->with, 1e9 / runs[1].particles / runs[1].frames * runs[1].phases);
    }
    row->bytes = (runs[1].bytes - runs[0].bytes) / runs[1].particles;
    row->states[STRENGTH_OFF] = plain.pictures == runs[0].pictures ? ANSWER_SAME : ANSWER_DIFFERENT;
    row->states[STRENGTH_ON] = strcmp(plain.hash, runs[1].hash) == 0 ? ANSWER_SAME : ANSWER_DIFFERENT;
    row->changes_pictures = plain.pictures != runs[1].pictures;
    return STATUS_OK;
}

enum status ledger_frames(const struct ledger *ledger, struct ledger_row *row, double end,
                          struct error *e)
{
    const struct feature_row *feature = row->feature;
    struct frames_run off, on;
    char output[4096], folder[4096];
    snprintf(folder, sizeof folder, "%s/frames", ledger->options->directory);
    snprintf(output, sizeof output, "%.4000s/%s", folder, feature->output);
    mkdir(folder, 0777); /* that it is not there is an error of the run */
    if (feature_is_look(feature))
        return measure_look(ledger, row, end, e);
    for (int k = 0; k < ledger->options->repeats; k++) {
        if (make_run(ledger, "null", NULL, NULL, feature->phases, end, row->reason, sizeof row->reason, &off, e) ||
            row->reason[0] ||
            make_run(ledger, output, feature->color, NULL, feature->phases, end, row->reason,
                     sizeof row->reason, &on, e) || row->reason[0])
            return e->status;
        double unit = 1e9 / on.particles / on.frames;
        row->without = fmin(row->without, unit * off.phases);
        row->with = fmin(row->with, unit * on.phases);
    }
    row->bytes = (on.bytes - off.bytes) / on.particles;
    row->states[STRENGTH_ON] = strcmp(off.hash, on.hash) == 0 ? ANSWER_SAME : ANSWER_DIFFERENT;
    return STATUS_OK;
}
