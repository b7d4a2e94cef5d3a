/* Says what stopped a run, in terms of the scene. */
#ifndef RUN_GIVE_UP_H
#define RUN_GIVE_UP_H

#include "run/simulation.h"

/* Part of the speed of sound beyond which density, hence pressure, is wrong: a run ends. */
#define MACH_MAX 0.5

/* STATUS_RUN with particle, place, cause and what to change, for a step of dt that particle `bad`
 * could not take after some halvings; or, with none, for a state that is no fluid. The rejected try
 * still lies in what the back end keeps of the step. */
enum status give_up(struct simulation *s, double dt, int halvings, uint32_t bad, struct error *e);

/* With --strict: STATUS_RUN when a step must be shorter than time.step; `rejected` is INFINITY, or
 * the step that particle `bad` could not take. */
enum status strict_check(const struct simulation *s, double rejected, uint32_t bad,
                         struct error *e);

#endif
