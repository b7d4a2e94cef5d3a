/* TEMPORARY: stands in for the run and the log until their rooms are merged; then delete. */
#include "base/log.h"
#include "run/run.h"

#include <math.h>
#include <stdarg.h>

static const struct key wcsph_keys[] = {
    {"solver.sound_speed", KEY_REAL, KEY_AUTO | KEY_ABOVE_MIN, "\"auto\"", 0, INFINITY, "m/s", NULL,
     "numerical speed of sound", KEY_OPTION}};
static const struct variant wcsph = {"wcsph", "weakly compressible", wcsph_keys, 1, NULL};
static const struct variant muller = {"muller", "Mueller et al. 2003", NULL, 0, NULL};
static const struct variant *const solver_rows[] = {&wcsph, &muller};
static const struct variant_table solvers = {"solvers", "pressure solvers", solver_rows, 2};
static const struct variant_table *const tables[] = {&solvers};
const struct vocabulary run_vocabulary = {tables, 1};

enum status run_plan(const struct scene *scene, const struct run_options *options, FILE *out,
                     struct error *e)
{
    (void)scene, (void)options, (void)out;
    return error_set(e, STATUS_RUN, "the run is not merged yet");
}

enum status run_scene(const struct scene *scene, const struct run_options *options,
                      struct error *e)
{
    (void)scene, (void)options;
    return error_set(e, STATUS_RUN, "the run is not merged yet");
}

#pragma weak log_error
#pragma weak log_set_level
void log_set_level(enum log_level level)
{
    (void)level;
}

void log_error(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    fputs("sph-render: ", stderr);
    vfprintf(stderr, format, args);
    fputc('\n', stderr);
    va_end(args);
}
