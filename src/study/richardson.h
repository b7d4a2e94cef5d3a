/* How far a ladder's values are from their limit, told from three rungs without knowing it. */
#ifndef STUDY_RICHARDSON_H
#define STUDY_RICHARDSON_H

#include "study/study.h"

enum richardson_kind {
    RICHARDSON_KNOWN,
    RICHARDSON_FEW,        /* fewer than three rungs of different spacing are done */
    RICHARDSON_NORM,       /* the norm is of sizes: differences of it are none of the value's */
    RICHARDSON_SAME,       /* rungs do not differ */
    RICHARDSON_OSCILLATES, /* the differences of rungs have different signs */
    RICHARDSON_DIVERGES,   /* they do not shrink */
    RICHARDSON_NOISE       /* they are within the spread of the seeds */
};
extern const char *const richardson_words[];

/* Values and limits are parts of the reference, as errors are: an extrapolated error of 1 % says that the limit is
 * 1 % above the reference run. */
struct richardson {
    enum richardson_kind kind;
    double order;        /* p of value - limit ~ spacing^p */
    double extrapolated; /* error of the limit: what the reference run lacks */
    double gci;          /* grid convergence index of the finest rung (Roache 1994), a part of the reference */
    double factor;       /* the safety factor in it: 1.25, or 3 where the order is not in 0.5 to 3 */
};

/* Of three values at falling spacings d[0] > d[1] > d[2] > 0. */
struct richardson richardson_of(const double d[3], const double values[3]);

/* Of the method's three finest rungs that are done. */
struct richardson richardson_ladder(const struct study_points *points, const struct study_ladder *ladder,
                                    const struct study_method *method, const struct study_asked *asked);

/* Whether the error is against a finer run, and the ladder is one of spacings. */
bool richardson_applies(const struct study_points *points, const struct study_ladder *ladder,
                        const struct study_asked *asked);

#endif
