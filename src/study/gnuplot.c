/* Starts gnuplot. */
#include "study/gnuplot.h"

#include <stddef.h>

bool gnuplot_found(void)
{
    return process_found("gnuplot");
}

/* Scripts are UTF-8, which gnuplot warns about where the locale is not. */
enum status gnuplot_run(const char *script, const char *directory, const char *log, struct process_end *end,
                        struct error *e)
{
    const char *const argv[] = {"env", "LC_ALL=C.UTF-8", "gnuplot", script, NULL};
    return process_run_other(argv, directory, log, end, e);
}
