/* The ledger of a scene: what each feature that it leaves out would cost, and that absence changes no bit. */
#ifndef STUDY_LEDGER_H
#define STUDY_LEDGER_H

#include "study/ledger/features.h"
#include "study/products/products.h"

enum { LEDGER_SETS_MAX = 64, LEDGER_FRAMES = 10 };

struct ledger_options {
    const char *scene, *directory;
    const char *sets[LEDGER_SETS_MAX]; /* "KEY=VALUE" */
    size_t set_count;
    long steps;
    int repeats, threads;
};

enum answer { ANSWER_NONE, ANSWER_SAME, ANSWER_DIFFERENT }; /* state hashes against the scene's */

struct ledger_row {
    const struct feature_row *feature;
    bool used;               /* by the scene; nothing else is filled then */
    char reason[400];        /* why it cannot be switched on; "" */
    char said[160];          /* what the plan says of its absence; "": nothing */
    bool absent;             /* none of its passes is in the plan */
    enum answer states[STRENGTHS]; /* of looks STRENGTH_OFF: the pictures' hashes */
    bool changes_pictures;   /* of looks */
    double without, with;    /* processor ns per particle and step; wall ns per particle and frame; NAN */
    double neutral;          /* the scene with the feature's key said to be off, ns; NAN */
    double steps;            /* as many as without, for the same time; NAN */
    double planned, bytes;   /* more a particle: fields of the plan, and all memory; NAN */
};

struct ledger {
    const struct ledger_options *options;
    char title[KEY_TEXT_SIZE], method[KEY_TEXT_SIZE];
    struct ledger_row *rows; /* by feature_table */
    size_t count;
    double particles, ns, bytes, step; /* of the scene as it is; step: s */
    size_t planned;          /* bytes of a particle by the plan */
    uint64_t hash;
    double noise;            /* ns: largest difference between the scene and the scene said otherwise */
};

/* Whether the scene with its settings can be run; STATUS_USAGE. */
enum status ledger_check(const struct ledger_options *options, struct error *e);

/* Measures all rows. STATUS_USAGE when the scene cannot be run, STATUS_RUN, STATUS_OUTPUT,
 * STATUS_INTERRUPTED. Free with ledger_free, also after failure. */
enum status ledger_make(struct ledger *ledger, const struct ledger_options *options, struct error *e);
void ledger_free(struct ledger *ledger);

/* Rows whose absence is not proved. */
size_t ledger_failures(const struct ledger *ledger);
bool ledger_proved(const struct ledger_row *row);

/* The Markdown table and what it means. */
void ledger_print(const struct ledger *ledger, const struct study_about *about, FILE *out);

/* ledger.csv, ledger.json, ledger.md. STATUS_OUTPUT. */
enum status ledger_write(const struct ledger *ledger, const struct study_about *about, struct error *e);

/* Fills the row of a feature of frames by runs of this program; `end`: s. */
enum status ledger_frames(const struct ledger *ledger, struct ledger_row *row, double end,
                          struct error *e);

#endif
