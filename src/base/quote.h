/* Quotes text as a JSON string, and words for a shell. */
#ifndef BASE_QUOTE_H
#define BASE_QUOTE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Writes text as a JSON string with quotes; returns false (truncated, still terminated) when it
 * needs more than `size` bytes. */
bool json_quote(const char *text, char *out, size_t size);

/* Writes a word so that a POSIX shell reads it as it is: plain, or in single quotes. */
void shell_quote(const char *word, FILE *out);

#endif
