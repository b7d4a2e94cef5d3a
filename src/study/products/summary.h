/* One table of the errors of several studies, as their scenes are shipped. */
#ifndef STUDY_SUMMARY_H
#define STUDY_SUMMARY_H

#include "study/products/products.h"

/* Writes DIRECTORY/summary.md: a line for each study and error, a column for each method. Values are of
 * the rung that changes nothing of the scene, else of the finest; bold is more than asked. STATUS_OUTPUT. */
enum status study_summary(const struct study_results *all, size_t count, const char *directory,
                          struct error *e);

#endif
