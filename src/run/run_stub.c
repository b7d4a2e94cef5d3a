/* TEMPORARY: stands in for the run and the log until their rooms are merged; then delete. */
#include "base/log.h"
#include "run/run.h"

#include <stdarg.h>

const struct vocabulary run_vocabulary = {NULL, 0};

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
