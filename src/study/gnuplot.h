/* Figures of studies by gnuplot, where it is there. */
#ifndef STUDY_GNUPLOT_H
#define STUDY_GNUPLOT_H

#include "study/process.h"

/* Whether it can be started. */
bool gnuplot_found(void);

/* Runs a script in a directory; what gnuplot says goes to the file `log`. */
enum status gnuplot_run(const char *script, const char *directory, const char *log, struct process_end *end,
                        struct error *e);

#endif
