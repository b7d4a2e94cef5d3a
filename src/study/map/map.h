/* A stability map: what became of each cell of two ladders, by method. */
#ifndef STUDY_MAP_H
#define STUDY_MAP_H

#include "run/limits.h"
#include "study/products/products.h"

enum cell_kind {
    CELL_STABLE,     /* done, every step as long as asked, none rejected, no measured error beyond its bound */
    CELL_SHORTENED,  /* done, but the program took shorter steps than asked, or rejected some */
    CELL_STOPPED,    /* the program ended the run and says why */
    CELL_WRONG,      /* it ended as if all were well, but a measured error is beyond its bound; or crashed */
    CELL_LATE,       /* longer than the study's limit */
    CELL_LEFT_OUT,   /* no time for it */
    CELL_KINDS
};

/* A row of the legend for each kind. */
struct cell_look {
    const char *name, *doc, *color, *mark; /* mark: in the cell; NULL: how much shorter steps are */
};
extern const struct cell_look cell_looks[CELL_KINDS];

struct map_cell {
    const struct study_point *point;
    size_t method, x, y;
    enum cell_kind kind;
    char why[400];            /* the program's cause, or the error that is beyond its bound; else "" */
    double step;              /* asked for, s; NAN: the scene gives none */
    double steps, rejected;   /* taken; NAN without a report */
    double fewest;            /* steps between the run's rows if all were as long as asked; NAN */
    double limits[LIMIT_COUNT]; /* of the step at the start, s; INFINITY: none; NAN: no report */
    double explicit_viscous;  /* what the viscous limit would be if it were not solved for, s; NAN */
    const char *bound;        /* the limit that bound most steps, "acoustic"; "" */
    double bound_part;        /* of all steps */
};

struct map {
    const struct study *study;
    struct map_cell *cells;   /* by method, then y, then x */
    size_t count, columns, rows;
};

/* Judges every cell from what its run left in the directory. STATUS_RUN. Free with map_free, also after
 * failure. */
enum status map_make(struct map *map, const struct study_results *results, struct error *e);
void map_free(struct map *map);

/* The limit of the step at the start that a row of cells has by theory, s; NAN or INFINITY: none. */
double map_limit(const struct map *map, size_t method, size_t row, int limit);

/* stability.csv, stability.json, report.md. STATUS_OUTPUT. */
enum status map_write(const struct map *map, const struct study_results *results, struct error *e);

/* stability.gp with its data, and by gnuplot stability.png and stability.svg; *drawn: gnuplot is there. */
enum status map_plot(const struct map *map, const char *directory, bool *drawn, struct error *e);

#endif
