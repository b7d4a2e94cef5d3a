/* Several sources of frames side by side, read in step. */
#ifndef COMPARE_LINEUP_H
#define COMPARE_LINEUP_H

#include "compare/source.h"
#include "compare/verdict.h"

enum { LINEUP_MAX = 1 + BASELINES_MAX };

struct lineup {
    enum source_order order;
    struct source sources[LINEUP_MAX];
    struct image images[LINEUP_MAX];
    size_t count;
};

/* Paths must outlive the lineup; at most LINEUP_MAX. Close it also on failure. */
enum status lineup_open(struct lineup *lineup, const char *const *paths, size_t count,
                        struct error *e);
void lineup_close(struct lineup *lineup); /* accepts a zeroed one */

/* The source whose next frame comes first of all; `ended` when none has one. */
const struct source *lineup_first(const struct lineup *lineup);

/* Reads the frames at that place, NULL where a source lacks it, and moves those sources on. */
enum status lineup_read(struct lineup *lineup, const struct source *place,
                        const struct image *frames[LINEUP_MAX], struct error *e);

#endif
