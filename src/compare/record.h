/* Records of a comparison: each verdict goes to text, JSON, a page or pictures, as it is made. */
#ifndef COMPARE_RECORD_H
#define COMPARE_RECORD_H

#include "compare/verdict.h"

#include <stdio.h>

enum { SINKS_MAX = 5 };

/* What was compared, and how; must outlive the record. */
struct comparison {
    const char *frames;           /* as named by the user */
    const char *const *baselines; /* the accepted versions */
    size_t baseline_count;
    FILE *text;                   /* for sink_text */
    const char *gate;
    struct limits limits;
    bool single;                  /* one picture, not a set */
};

struct tally {
    size_t count[VERDICT_STATES]; /* frames */
    size_t frames, failed;
};

struct sink; /* each sink's own state */

/* One way to record. */
struct sink_row {
    enum status (*open)(struct sink **, const struct comparison *, const char *path,
                        struct error *);
    enum status (*frame)(struct sink *, const struct verdict *, struct error *);
    /* keep: complete the file; else leave no trace of it. Always frees. */
    enum status (*close)(struct sink *, const struct tally *, bool keep, struct error *);
};

extern const struct sink_row sink_text; /* to comparison.text; the path is not used */
extern const struct sink_row sink_json; /* "-" is standard output */
extern const struct sink_row sink_page; /* HTML; a directory stands for its index.html */
extern const struct sink_row sink_map, sink_side; /* PNG: the differences; both and those */

struct record {
    const struct comparison *comparison;
    struct tally tally;
    struct {
        const struct sink_row *row;
        struct sink *sink;
    } sinks[SINKS_MAX];
    size_t sink_count;
};

/* STATUS_OUTPUT, STATUS_USAGE, STATUS_RUN; the record stays usable. */
enum status record_add(struct record *record, const struct sink_row *row, const char *path,
                       struct error *e);
enum status record_frame(struct record *record, const struct verdict *verdict, struct error *e);
/* Closes every sink; the first error when keep. */
enum status record_close(struct record *record, bool keep, struct error *e);

#endif
