/* Plans what frames show: colour, its scale and map, and the pass that computes it. */
#ifndef RUN_PLAN_COLOR_H
#define RUN_PLAN_COLOR_H

#include "run/plan.h"

/* After the solver's choice. STATUS_USAGE when color.map_file is no map. */
enum status plan_color(struct plan *plan, const struct run_options *options, struct error *e);

/* Computes values that never change, once there are particles. STATUS_RUN when memory is short. */
enum status plan_color_values(struct plan *plan, struct error *e);

/* Writes the plan's line of it. */
void plan_color_write(const struct plan *plan, FILE *out);

#endif
