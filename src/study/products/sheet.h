/* A report as headings, paragraphs and tables, in whatever form it is written. */
#ifndef STUDY_SHEET_H
#define STUDY_SHEET_H

#include "study/products/figure.h"

enum cell_style { CELL_PLAIN, CELL_BOLD };

struct sheet_format; /* the functions below, for a kind of file */

struct sheet {
    const struct sheet_format *format;
    FILE *out;
    const struct study_results *results;
};

struct sheet_format {
    void (*heading)(struct sheet *sheet, int level, const char *text);
    void (*paragraph)(struct sheet *sheet, const char *text, bool warning);
    void (*item)(struct sheet *sheet, const char *text); /* of a list */
    void (*list)(struct sheet *sheet, bool open);
    void (*head)(struct sheet *sheet, const char *text); /* of the first row of a table */
    void (*cell)(struct sheet *sheet, const char *text, enum cell_style style);
    void (*table)(struct sheet *sheet, bool open);
    void (*row)(struct sheet *sheet, bool open);
    void (*head_end)(struct sheet *sheet, size_t columns);
    /* `command` makes again what `name` says. */
    void (*command)(struct sheet *sheet, const char *name, const char *command);
    enum status (*figure)(struct sheet *sheet, const struct figure *figure, struct error *e);
    /* Pictures of the ladder's last states, or nothing. */
    enum status (*frames)(struct sheet *sheet, const struct study_ladder *ladder, struct error *e);
};

/* The whole report. STATUS_RUN, STATUS_OUTPUT. */
enum status sheet_write(struct sheet *sheet, struct error *e);

/* Its parts. */
enum status sheet_ladders(struct sheet *sheet, struct error *e);  /* tables and figures */
void sheet_efforts(struct sheet *sheet, const struct study_ladder *ladder); /* time to an error */
void sheet_convergence(struct sheet *sheet, const struct study_ladder *ladder); /* against finer runs */
enum status sheet_verdicts(struct sheet *sheet, struct error *e); /* asked bounds, default, failures */

void sheet_paragraph(struct sheet *sheet, bool warning, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
void sheet_item(struct sheet *sheet, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* A row of texts in plain cells, of `count`. */
void sheet_heads(struct sheet *sheet, const char *const *texts, size_t count);

#endif
