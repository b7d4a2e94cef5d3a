/* Whether a plan fits the machine, before a particle is made. */
#ifndef RUN_BUDGET_H
#define RUN_BUDGET_H

#include "run/plan.h"

/* Needs the plan's choice and bytes_per_particle. STATUS_USAGE when there are more particles than
 * can be numbered, STATUS_RUN when their memory is more than the machine has, or the plan's device, which is
 * not asked unless it may be touched (struct run_options). */
enum status budget_check(const struct plan *plan, bool touch, struct error *e);

#endif
