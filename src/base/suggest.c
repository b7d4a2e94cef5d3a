/* Finds the known word nearest to a mistyped one by edit distance. */
#include "base/suggest.h"

#include <ctype.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { LONGEST = 63 };

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

static int same(char a, char b)
{
    return tolower((unsigned char)a) == tolower((unsigned char)b);
}

/* Optimal string alignment: three rolling rows of the usual table. */
size_t suggest_distance(const char *a, const char *b)
{
    size_t rows[3][LONGEST + 1];
    size_t la = least(strlen(a), LONGEST), lb = least(strlen(b), LONGEST);
    for (size_t j = 0; j <= lb; j++)
        rows[0][j] = j;
    for (size_t i = 1; i <= la; i++) {
        size_t *now = rows[i % 3], *above = rows[(i + 2) % 3], *two = rows[(i + 1) % 3];
        now[0] = i;
        for (size_t j = 1; j <= lb; j++) {
            size_t change = above[j - 1] + !same(a[i - 1], b[j - 1]);
            now[j] = least(change, least(above[j], now[j - 1]) + 1);
            if (i > 1 && j > 1 && same(a[i - 1], b[j - 2]) && same(a[i - 2], b[j - 1]))
                now[j] = least(now[j], two[j - 2] + 1);
        }
    }
    return rows[la % 3][lb];
}

void suggest_start(struct suggest *s, const char *word)
{
    *s = (struct suggest){.word = word, .distance = SIZE_MAX};
}

void suggest_offer(struct suggest *s, const char *candidate)
{
    size_t length = strlen(s->word);
    size_t distance = suggest_distance(s->word, candidate);
    /* A word cut short, or one with an ending added, is a near miss whatever its length. */
    if (length >= 3 && (strncmp(candidate, s->word, length) == 0 ||
                        (strlen(candidate) >= 3 &&
                         strncmp(candidate, s->word, strlen(candidate)) == 0)))
        distance = least(distance, 1);
    if (distance < s->distance) {
        s->distance = distance;
        snprintf(s->best, sizeof s->best, "%s", candidate);
    }
}

const char *suggest_best(const struct suggest *s)
{
    size_t allowed = least(1 + strlen(s->word) / 4, 3);
    if (strlen(s->word) < 3)
        allowed = strlen(s->word) ? 1 : 0;
    return s->best[0] && s->distance <= allowed ? s->best : NULL;
}
