/* The common head of every descriptor: a variant is one file ending in one, plus one table row. */
#ifndef BASE_VARIANT_H
#define BASE_VARIANT_H

#include <stddef.h>

struct key; /* scene/key.h: a scene-file key */

/* First member of each descriptor (solver, kernel, neighbour search, context, encoder ...). */
struct variant {
    const char *name;       /* as written in scene files and options */
    const char *doc;        /* one line for `list` and --help */
    const struct key *keys; /* scene keys that only this variant reads; NULL if none */
    size_t key_count;
    const char *missing;    /* NULL: in this build; else how to build it */
};

/* A visible table in preference order. */
struct variant_table {
    const char *name; /* "solvers" */
    const char *doc;
    const struct variant *const *rows;
    size_t count;
};

/* The row of that name, or NULL. */
const struct variant *variant_find(const struct variant_table *table, const char *name);

/* The first row that is in this build, or NULL. */
const struct variant *variant_first(const struct variant_table *table);

#endif
