/* Runs the points of a study in turns, as far as the time goes, and keeps what is done on the disk. */
#ifndef STUDY_SCHEDULE_H
#define STUDY_SCHEDULE_H

#include "study/study.h"

/* Runs every point, or each of its seeds, that the directory does not have yet: the first of all, small to
 * large, then the repeats in turns, then again what was disturbed, at most once more for each repeat. A point
 * is left out when what is left of the budget (s, INFINITY for none) would not do. Fills outcomes, causes and
 * times of all points, anew at each call. STATUS_OUTPUT, STATUS_INTERRUPTED. */
enum status study_run(const struct study *study, struct study_points *points, const char *directory,
                      int repeats, double budget, struct error *e);

#endif
