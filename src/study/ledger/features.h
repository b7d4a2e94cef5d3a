/* What a scene can leave out: each feature, how it is switched on, and how its absence is said. */
#ifndef STUDY_FEATURES_H
#define STUDY_FEATURES_H

#include "base/variant.h"
#include "run/plan.h"

#include <stdio.h>

enum strength {
    STRENGTH_OFF,   /* said explicitly, with the key's neutral value */
    STRENGTH_ON,
    STRENGTH_FAINT, /* switched on, but too weak to change a bit */
    STRENGTHS
};

struct feature_row {
    struct variant variant;   /* the doc says what is computed */
    /* Settings of scene keys, separated by spaces; "*" is each of the scene's fluids; NULL: there is none,
     * and `why` says the reason. */
    const char *settings[STRENGTHS];
    const char *why;
    /* The value of "fluids" instead of settings; or NULL. */
    void (*fluids)(const struct scene *scene, enum strength strength, FILE *out);
    const char *omitted[3];   /* beginnings of what the plan says is left out: one of them */
    enum pass_id passes[4];   /* that it stands for; none of them may be in the plan */
    size_t pass_count;
    bool (*used)(const struct plan *plan);
    const char *output;       /* of frames, not of steps: -o PATH below the ledger's directory, ...; with settings it
                                 is drawn with and without them, into that kind of output */
    const char *color;        /* ... with that color.by, or NULL */
    const char *phases;       /* ... and what the report calls its time: "draw|encode" */
};

extern const struct variant_table feature_table; /* "features" */

#endif
