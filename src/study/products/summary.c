/* Writes one file for several studies: their errors, settings and times. */
#include "study/products/summary.h"

#include "base/output.h"
#include "run/report.h"
#include "study/products/figure.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

bool summary_has_errors(const struct study_results *results)
{
    return study_most_errors(results->points, NULL);
}

void summary_about(const struct study_results *all, size_t count, FILE *out)
{
    const char *first = all[0].about->date, *last = first;
    for (size_t k = 1; k < count; k++) {
        const char *date = all[k].about->date;
        first = strcmp(date, first) < 0 ? date : first;
        last = strcmp(date, last) > 0 ? date : last;
    }
    fprintf(out, "Measured %.10s", first);
    if (strncmp(first, last, 10) != 0)
        fprintf(out, " to %.10s", last);
    fprintf(out, " on %s, %ld processors, by sph-render " SPH_VERSION, report_processor(),
            sysconf(_SC_NPROCESSORS_ONLN));
}

/* Runs of all studies: done, failed, left out. */
static void write_outcomes(const struct study_results *all, size_t count, FILE *out)
{
    size_t done = 0, failed = 0, left_out = 0;
    for (size_t k = 0; k < count; k++)
        for (size_t i = 0; i < all[k].points->count; i++) {
            enum outcome outcome = all[k].points->items[i].outcome;
            *(outcome == OUTCOME_DONE ? &done : outcome == OUTCOME_LEFT_OUT ? &left_out : &failed) += 1;
        }
    fprintf(out, ": %zu points, %zu stopped or late, %zu left out by the budget (–).\n", done + failed + left_out,
            failed, left_out);
}

static void write_tables(const struct study_results *all, size_t count, FILE *out)
{
    summary_about(all, count, out);
    write_outcomes(all, count, out);
    fputs("Bold: more than asked. ~: every run waited for others on the machine.\n\n", out);
    summary_errors(all, count, out);
    summary_limits(all, count, out);
    for (size_t k = 0; k < count; k++)
        summary_times(&all[k], out);
}

static void write_settings(const struct study_results *all, size_t count, FILE *out)
{
    summary_about(all, count, out);
    write_outcomes(all, count, out);
    summary_settings(all, count, out);
}

static enum status write_file(const struct study_results *all, size_t count, const char *directory,
                              const char *name, void (*write)(const struct study_results *, size_t, FILE *),
                              struct error *e)
{
    char path[4096];
    struct output_file file;
    snprintf(path, sizeof path, "%s/%s", directory, name);
    if (output_open(&file, path, e))
        return e->status;
    write(all, count, file.stream);
    return output_close(&file, true, e);
}

enum status study_summary(const struct study_results *all, size_t count, const char *directory,
                          struct error *e)
{
    bool settings = false;
    for (size_t k = 0; k < count; k++)
        settings = settings || summary_has_settings(&all[k]);
    if (write_file(all, count, directory, "summary.md", write_tables, e))
        return e->status;
    return settings ? write_file(all, count, directory, "settings.md", write_settings, e) : STATUS_OK;
}
