/* "Did you mean": the known word nearest to a mistyped one. */
#ifndef BASE_SUGGEST_H
#define BASE_SUGGEST_H

#include <stddef.h>

/* Collects candidates one by one; start with suggest_start, end with suggest_best. */
struct suggest {
    const char *word;
    char best[128];  /* empty: none yet */
    size_t distance; /* edits between word and best */
};

void suggest_start(struct suggest *s, const char *word);

void suggest_offer(struct suggest *s, const char *candidate);

/* The nearest candidate if it is near enough to be what was meant, else NULL. */
const char *suggest_best(const struct suggest *s);

/* Letters to insert, delete, change or swap with their neighbour to turn a into b; case is
 * ignored. Only the first 63 letters count. */
size_t suggest_distance(const char *a, const char *b);

#endif
