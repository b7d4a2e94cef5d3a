/* Which figures a study has, and where their marks are. */
#ifndef STUDY_FIGURE_H
#define STUDY_FIGURE_H

#include "study/products/products.h"

enum { FIGURES_MOST = 64 };

enum figure_kind {
    FIGURE_TIME,  /* wall time against an error */
    FIGURE_PAIRS, /* evaluated pairs against an error: the same at every repeat */
    FIGURE_VALUE  /* wall time against the ladder's value */
};

struct figure {
    const struct study_ladder *ladder;
    enum figure_kind kind;
    const char *error;            /* its name; NULL: none is known */
    const struct study_error *of; /* it in some point: name, unit, asked, spread; or NULL */
    char stem[160];               /* of its files, in "plots" */
};

/* Gives their number, at most FIGURES_MOST. */
size_t study_figures(const struct study_results *results, struct figure *figures);

/* Whether the ladder shows time against its value, for the rule see enum ladder_figure. */
bool figure_is_time(const struct study_results *results, const struct study_ladder *ladder);

/* The error of that name in some point of the ladder, or NULL. */
const struct study_error *figure_error(const struct study_points *points,
                                       const struct study_ladder *ladder, const char *name);

/* What a ladder's values are called: its key, or its name where that says more. */
const char *figure_key(const struct study_ladder *ladder);

/* One line of words below it. */
void figure_caption(const struct figure *figure, char *out, size_t size);

/* Wall time, s; where the ladder says a number of steps, of so many. */
double figure_wall_of_steps(const struct study_point *point);

/* What a point costs in this figure. */
double (*figure_cost(const struct figure *figure))(const struct study_point *);

/* Positive x or y of a logarithmic axis, and what lies beside. */
struct figure_axis {
    double from, to;
    double zero; /* place of errors of 0; NAN: there are none */
    bool rungs;  /* not logarithmic: places 1, 2 ... of the ladder's rungs */
};

struct figure_mark {
    const struct study_point *point;
    double x, y;
    double low, high; /* x of the least and the most of its seeds; NAN: none */
    bool failed, front;
};

struct figure_view {
    struct figure_axis x, y;
    struct figure_mark *marks; /* by method, then rung */
    size_t count;
    bool failures;             /* some are marked above the others */
};

/* STATUS_RUN when memory is short; free with figure_view_free. No marks: there is nothing to see. */
enum status figure_view(const struct study_results *results, const struct figure *figure,
                        struct figure_view *view, struct error *e);
void figure_view_free(struct figure_view *view);

/* Place of a value on the axis, 0 to 1. */
double figure_part(const struct figure_axis *axis, double value);

/* Sides of a mark where its rung is written. */
enum label_side { LABEL_NONE, LABEL_ABOVE, LABEL_BELOW, LABEL_RIGHT, LABEL_LEFT };

/* Chooses for each mark a side where its label covers no mark, line or other label,
 * or LABEL_NONE. */
void figure_labels(const struct figure_view *view, enum label_side *sides);

/* Writes gnuplot's "set xtics (...)" of that axis, 'x' or 'y'. */
void figure_tics(const struct figure *figure, const struct figure_axis *axis, char letter, FILE *out);

#endif
