/* Judges a frame against its accepted versions. */
#ifndef COMPARE_VERDICT_H
#define COMPARE_VERDICT_H

#include "compare/gate.h"

enum { BASELINES_MAX = 16 };

enum verdict_state {
    VERDICT_EQUAL,     /* the same bits */
    VERDICT_SAME,      /* within the limits */
    VERDICT_DIFFERENT,
    VERDICT_SIZE,      /* different: the sizes differ */
    VERDICT_MISSING,   /* different: accepted, but not there */
    VERDICT_EXTRA,     /* different: there, but not accepted */
    VERDICT_STATES
};

struct verdict {
    const char *name;                /* of the frame */
    enum verdict_state state;
    const struct image *frame;       /* NULL when missing */
    const struct image *accepted;    /* the version that it was judged by; NULL when extra */
    size_t baseline;                 /* whose version that is */
    double values[SCORES_MAX];       /* NAN when nothing was measured */
    double excess;                   /* over the limits: the largest of value/limit - 1; up to 0: kept */
};

/* "equal", "same", "different", "size differs", "missing", "extra". */
const char *verdict_word(enum verdict_state state);
static inline bool verdict_passes(enum verdict_state state)
{
    return state <= VERDICT_SAME;
}

/* By the first version that passes, else by the nearest. `frame` is NULL when there is none, and so
 * are members of `accepted`; at least one picture is there. All must outlive the verdict. */
enum status verdict_make(struct verdict *verdict, const char *name, const struct limits *limits,
                         const struct image *frame, const struct image *const *accepted,
                         size_t count, struct error *e);

/* Black where the pictures agree; differences per channel, 16 times amplified. For equal sizes. */
enum status verdict_map(const struct verdict *verdict, struct image *map, struct error *e);

#endif
