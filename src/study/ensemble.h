/* Chaotic cases: a point as the mean of runs from several seeds of disorder. */
#ifndef STUDY_ENSEMBLE_H
#define STUDY_ENSEMBLE_H

#include "study/study.h"

/* Appends the seeds of that member of the ensemble (0: the scene's own) to the settings. STATUS_USAGE when
 * nothing in the scene is random, so that all members would be alike. */
enum status ensemble_seed(struct study_set *set, const struct scene *scene, size_t member,
                          struct error *e);

/* Fills outcome, counts and errors of the point from its members, each judged. Without members it stays. */
void ensemble_join(struct study_point *point);

#endif
