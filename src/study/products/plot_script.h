/* A figure as numbers and as a script for gnuplot, in "plots". */
#ifndef STUDY_PLOT_SCRIPT_H
#define STUDY_PLOT_SCRIPT_H

#include "study/products/figure.h"

/* Writes STEM.dat: a block for each method that has marks, then failures, then the front. */
enum status plot_data(const struct study_results *results, const struct figure *figure,
                      const struct figure_view *view, struct error *e);

/* Writes STEM.gp, which makes STEM.png and STEM.svg of it. STATUS_OUTPUT, STATUS_RUN. */
enum status plot_script(const struct study_results *results, const struct figure *figure,
                        const struct figure_view *view, struct error *e);

/* "DIRECTORY/plots/STEM.SUFFIX" */
void plot_path(const struct study_results *results, const struct figure *figure, const char *suffix,
               char *out, size_t size);

#endif
