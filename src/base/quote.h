/* Quotes text as a JSON string. */
#ifndef BASE_QUOTE_H
#define BASE_QUOTE_H

#include <stdbool.h>
#include <stddef.h>

/* Writes text as a JSON string with quotes; returns false (truncated, still terminated) when it
 * needs more than `size` bytes. */
bool json_quote(const char *text, char *out, size_t size);

#endif
