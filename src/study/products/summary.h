/* One file for several studies, short enough for a README: their errors, settings and times. */
#ifndef STUDY_SUMMARY_H
#define STUDY_SUMMARY_H

#include "study/products/products.h"

/* Writes DIRECTORY/summary.md: when and where it was measured; a table of the errors of all studies that have
 * some, a column for each method; for each ladder of times a table of them; and, where studies have several
 * ladders, DIRECTORY/settings.md: a table of what each setting changes. STATUS_OUTPUT. */
enum status study_summary(const struct study_results *all, size_t count, const char *directory,
                          struct error *e);

/* Its parts; each writes nothing where there is nothing. Values are of the rung that changes nothing of the
 * scene, else of the finest; bold is more than asked. */
void summary_errors(const struct study_results *all, size_t count, FILE *out);
void summary_limits(const struct study_results *all, size_t count, FILE *out);
void summary_settings(const struct study_results *all, size_t count, FILE *out);
void summary_times(const struct study_results *results, FILE *out);

/* "Measured 2026-11-26 on AMD EPYC, 2 processors": all their dates. */
void summary_about(const struct study_results *all, size_t count, FILE *out);

/* Whether a point has an error. */
bool summary_has_errors(const struct study_results *results);

/* Whether it varies settings: more than one ladder, with errors. */
bool summary_has_settings(const struct study_results *results);

/* The point of the method that stands for the scene: in the first ladder the rung as shipped, else the
 * last; NULL when the study does not have the method. */
const struct study_point *summary_point(const struct study_results *results, const char *method);

#endif
