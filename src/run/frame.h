/* Hands what is drawn of the present state to a snapshot. */
#ifndef RUN_FRAME_H
#define RUN_FRAME_H

#include "run/film.h"
#include "run/simulation.h"

/* Particles a snapshot of this plan holds. */
size_t frame_count(const struct plan *plan);

/* How this plan's frames are drawn; its back end is chosen. */
struct render_setup frame_setup(const struct plan *plan, const struct run_options *options);

/* Where those frames are that the plan's back end `row` makes, for the renderer. */
struct render_source frame_source(const struct plan *plan, const struct backend_row *row);

/* Fills positions and colours in ascending id; wall particles follow when they are drawn. A device may still be
 * at it afterwards. STATUS_RUN when the colour's pass has no memory. */
enum status frame_fill(struct simulation *s, struct film_snapshot *snapshot, struct error *e);

#endif
