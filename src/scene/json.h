/* JSON documents whose every value knows its place in the text. */
#ifndef SCENE_JSON_H
#define SCENE_JSON_H

#include "base/error.h"

#include <stdbool.h>
#include <stddef.h>

enum { JSON_SIZE_LIMIT = 16 << 20, JSON_DEPTH_LIMIT = 32 }; /* bytes; nested values */

enum json_kind { JSON_OBJECT, JSON_ARRAY, JSON_STRING, JSON_NUMBER, JSON_BOOL, JSON_NULL };

/* Nodes lie in the order of the text. An object's children are its keys (strings), and a key's
 * only child, the next node, is its value. */
struct json_node {
    enum json_kind kind;
    int start, end; /* bytes of the text; of a string without its quotes */
    int size;       /* children */
    int next;       /* the node after this one and all below it */
};

struct json {
    char *name;     /* of the file, or what the text is, for messages */
    bool is_file;   /* messages give line and column */
    char *text;     /* UTF-8, zero-terminated */
    int length;     /* bytes */
    struct json_node *nodes;
    int count;
};

/* Read and check strictly (RFC 8259, no duplicate-key check). STATUS_USAGE with the place and what
 * to do; STATUS_RUN when memory is short. Free with json_free, also after failure. */
enum status json_read_file(struct json *doc, const char *path, struct error *e);
enum status json_read_text(struct json *doc, const char *name, const char *text, struct error *e);
void json_free(struct json *doc);

/* Line and column (in characters) of a byte, both from 1. */
void json_position(const struct json *doc, int offset, int *line, int *column);

/* Records "NAME:LINE:COLUMN: message" and returns STATUS_USAGE. */
enum status json_fail(const struct json *doc, int offset, struct error *e, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Decodes the string at a node into out, zero-terminated; false when it needs more than `size`
 * bytes, and then out holds a beginning of it that is whole UTF-8. */
bool json_string(const struct json *doc, int node, char *out, size_t size);

/* The value of the key in an object node, or -1. */
int json_member(const struct json *doc, int object, const char *key);

/* "an object", "a number" ... for messages. */
const char *json_kind_name(enum json_kind kind);

/* What is wrong first. */
struct json_fault {
    int offset; /* byte of the text */
    char text[240];
};

/* Checks that the text is one JSON value and nothing else; false fills the fault. */
bool json_check(const char *text, int length, struct json_fault *fault);

#endif
