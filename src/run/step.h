/* One try of a time step: the planned passes in order, loops until they are solved. */
#ifndef RUN_STEP_H
#define RUN_STEP_H

#include "run/simulation.h"

/* Tries a step of dt, s, or tries it again (redo). Sets *bad to the smallest id of a particle that must not move so, and then
 * the state is the one before; else to UINT32_MAX. */
enum status step_try(struct simulation *s, double dt, bool redo, uint32_t *bad, struct error *e);

/* The passes between predict and correct, at the present state (explicit solvers). */
enum status step_forces(struct simulation *s, struct step *step, struct error *e);

/* Waits for passes that a back end has queued. */
enum status step_settle(struct simulation *s, struct step *step, struct error *e);

enum status step_pass(struct simulation *s, enum pass_id pass, struct step *step, struct error *e);

#endif
