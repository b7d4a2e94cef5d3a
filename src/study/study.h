/* A study: one scene over methods and ladders of settings, and what each run errs and takes.
 *
 * read (study_read.c, read_*.c) -> points, each with its scene (points.c) -> runs by child processes, in turns
 * (schedule.c) -> errors (judge.c), joined over seeds (ensemble.c) -> orders, fronts (analyse.c) -> tables and
 * figures (products/); job.c does it all */
#ifndef STUDY_STUDY_H
#define STUDY_STUDY_H

#include "study/cases/case.h"
#include "study/reference/norm.h"

#include <stdbool.h>
#include <stdint.h>

/* A run that takes longer is not made again, s: the machine's noise has averaged out in it. */
#define REPEAT_LONGEST 20.0

/* Disturbed repeats are made again, so there may be twice as many runs. */
enum { STUDY_REPEATS_MAX = 64, STUDY_RUNS_MAX = 128, STUDY_SEEDS_MAX = 64, STUDY_NAME_SIZE = 96 };

/* Settings of scene keys, as scene_overrides has them; labels say where the study has them. */
struct study_set {
    char **items, **labels; /* "time.cfl=0.5"; "FILE:LINE:COLUMN: time.cfl" */
    size_t count;
};

/* A curve: what is compared with what. In sets "threads", "isa" and "backend" are those of the run. */
struct study_method {
    char name[STUDY_NAME_SIZE];
    struct study_set set;
};

/* What its figures show. */
enum ladder_figure {
    LADDER_BY_RULE, /* LADDER_TIME by threads or isa, or when no error differs; else LADDER_WORK */
    LADDER_WORK,    /* error, and time */
    LADDER_TIME     /* the key's value, and time */
};

/* Times of another program, as published or measured before: what to compare with. */
struct study_other {
    char name[STUDY_NAME_SIZE];
    double *seconds;             /* at each rung; NAN: not known */
};

/* A family of points along each curve; never mixed with another in a figure. */
struct study_ladder {
    char name[STUDY_NAME_SIZE];  /* "resolution" */
    char key[KEY_TEXT_SIZE];     /* the first that is set: what the rungs are called by */
    struct study_set *rungs;     /* coarse to fine */
    char (*labels)[32];          /* of the rungs: the key's values */
    size_t count;
    enum ladder_figure figure;
    double steps;                /* times in its table are for so many steps; NAN: for the whole run */
    struct study_other *others;
    size_t other_count;
};

enum reference_kind {
    REFERENCE_VALUE,   /* a number */
    REFERENCE_FIRST,   /* the column's own first value: drift */
    REFERENCE_FORMULA, /* of t, s */
    REFERENCE_DATA,    /* a column of a csv file, its first column the time, s */
    REFERENCE_RUN      /* the same column of a finer run that all methods share */
};

/* An error that a study defines itself: a norm of a measured column against a reference. */
struct study_asked {
    char name[STUDY_NAME_SIZE];
    char column[KEY_TEXT_SIZE];
    int line, character;          /* where the study names the column */
    const struct norm_row *norm;
    enum reference_kind kind;
    double value;
    char *formula;                /* or NULL */
    char *path;                   /* of the data, or NULL */
    char reference_column[KEY_TEXT_SIZE], low[KEY_TEXT_SIZE], high[KEY_TEXT_SIZE]; /* of the data; "": none */
    double asked;                 /* bound; NAN: none */
};

struct study {
    char *path;                   /* of the file */
    char title[KEY_TEXT_SIZE];
    char *scene;                  /* path of the scene's file */
    const struct case_row *known; /* "case", or NULL */
    char *measure;                /* of own errors: elements of the scene's list, JSON, or NULL */
    double interval;              /* s between rows; NAN: the case's, or the scene's frames */
    struct study_asked *asked;
    size_t asked_count;
    char (*plots)[STUDY_NAME_SIZE]; /* errors that have a figure; none: the first */
    size_t plot_count;
    double floor;                 /* of errors, by float32 arithmetic; NAN: not known */
    struct study_set set;         /* of all runs */
    struct study_set reference;   /* of the run that REFERENCE_RUN is about; none: no such run */
    struct study_method *methods;
    size_t method_count;
    struct study_ladder *ladders;
    size_t ladder_count;
    struct study_ladder map[2];   /* x and y of a stability map; then there is one ladder, of its cells, */
    bool is_map;                  /* rung y * map[0].count + x */
    int repeats;                  /* runs of each point, but for those longer than REPEAT_LONGEST */
    int seeds;                    /* 1; more: each point is the mean of runs from so many seeds */
    double limit;                 /* s, of one run; INFINITY */
};

/* Reads and checks a study file; STATUS_USAGE with file, line, column and what to do, STATUS_RUN.
 * Free with study_free, also after failure. */
enum status study_read(struct study *study, const char *path, struct error *e);
void study_free(struct study *study);

enum outcome {
    OUTCOME_LEFT_OUT, /* no time for it */
    OUTCOME_DONE,
    OUTCOME_STOPPED,  /* the program ended the run, and says why */
    OUTCOME_LATE,     /* longer than the limit */
    OUTCOME_CRASHED
};

/* What one run was and did. */
struct study_point {
    const struct study_ladder *ladder; /* NULL: the reference run */
    const struct study_method *method;
    size_t rung;
    char *folder;                 /* of its files, below the study's: "runs/isph-0.05-1f3a..." */
    struct scene *scene;          /* as it runs */
    int threads;                  /* 0: all processors */
    char isa[16];                 /* row of "isas", or "auto" */
    char backend[16];             /* "cpu" unless the study says otherwise */
    double guess;                 /* particles, estimated */
    bool shipped;                 /* the rung changes nothing of the scene */

    enum outcome outcome;
    char cause[400];              /* of what is not done */
    int repeats;                  /* made */
    double wall[STUDY_RUNS_MAX], cpu[STUDY_RUNS_MAX]; /* s, of solving; of the process */
    double particles, steps, rejected, dt, pairs, iterations, bytes; /* dt: mean, s; iterations: a step */
    double energy_drift, momentum_drift; /* parts; NAN: not measured, or not kept by nature */
    double leak;                  /* m that a particle was outside of the domain at a row, at most */
    char hash[17];                /* of the last state */
    struct study_errors errors;
    struct study_point *members;  /* the same from each seed, which are run instead of it; it joins them: */
    size_t member_count;          /* counts and last state are the first member's; 0: it is run itself */
};

struct study_points {
    struct study_point *items;    /* the reference run first if there is one, then by ladder, rung, method */
    size_t count;
};

/* Makes the points and loads their scenes; STATUS_USAGE when one cannot be run. */
enum status study_points_create(struct study_points *points, const struct study *study,
                                struct error *e);
void study_points_free(struct study_points *points);

/* Whether that repeat's time is more than a tenth above what the others, or its processor time, say. */
bool study_is_disturbed(const struct study_point *point, int repeat);
int study_calm(const struct study_point *point); /* repeats that are not */

/* The least of the repeats' times, and the median without the disturbed ones, s; NAN without. With seeds the
 * mean of theirs. */
double study_wall(const struct study_point *point);
double study_cpu(const struct study_point *point);
double study_wall_median(const struct study_point *point);

/* Pairs that were evaluated, the cost that no noise is in, with seeds the mean; NAN without. */
double study_pairs(const struct study_point *point);

/* The method whose settings are the scene's own, else the first; *own says which of the two. */
enum status study_default(const struct study *study, const struct study_method **method, bool *own,
                          struct error *e);

/* Reads what the first repeat of each point left, and fills what it did and its errors; one that did not
 * reach what is compared is stopped. STATUS_RUN when the files cannot be read. */
enum status study_judge(const struct study *study, struct study_points *points,
                        const char *directory, struct error *e);

/* The point's error of that name, or NULL; a NULL name has none. Errors are told by their names: a point
 * that stopped early has fewer, and not in the same places. */
const struct study_error *study_error(const struct study_point *point, const char *name);

/* |error| of a point that is done; else NAN. */
double study_error_size(const struct study_point *point, const char *error);

/* p of error ~ d^p from the rung before to this one; NAN where the spacing does not change. */
double study_order(const struct study_points *points, const struct study_point *point,
                   const char *error);

/* Whether no other point of the ladder has less error for no more cost, or no more error for less. */
bool study_is_front(const struct study_points *points, const struct study_point *point,
                    const char *error, double (*cost)(const struct study_point *));

/* The errors of the point of the ladder (NULL: of any) that has the most of them, for their names; NULL
 * when none has one. */
const struct study_errors *study_most_errors(const struct study_points *points,
                                             const struct study_ladder *ladder);

/* The error of that name of some point, or NULL. */
const struct study_error *study_error_known(const struct study_points *points, const char *name);

#endif
