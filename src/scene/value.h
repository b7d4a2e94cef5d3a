/* Single values: from JSON nodes to typed memory with every check, and back to JSON text. */
#ifndef SCENE_VALUE_H
#define SCENE_VALUE_H

#include "scene/json.h"
#include "scene/keys.h"

#include <stdio.h>

/* Bytes that a value of the type takes in memory. */
size_t value_size(enum key_type type);

/* Reads the node into memory as the key says. `path` is what messages call the key. STATUS_USAGE
 * with the place, what is wrong, and the nearest valid word. */
enum status value_read(const struct json *doc, int node, const struct key *key, const char *path,
                       const struct vocabulary *vocabulary, void *memory, struct error *e);

/* The key's default; its text is the program's own, so an error is a programming mistake. */
enum status value_default(const struct key *key, const struct vocabulary *vocabulary, void *memory,
                          struct error *e);

/* JSON text that reads back to the same value. */
void value_write(const struct key *key, const void *memory, FILE *out);

/* Shortest decimal that reads back to the same double; "null" for what is not finite. */
void value_number(double number, char out[32]);

/* "a number from 0 to 1", as the key's type and range say. */
void value_expected(const struct key *key, char *out, size_t size);

#endif
