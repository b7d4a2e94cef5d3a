/* Reads JSON documents into nodes that know their place; tokens by jsmn. */
#include "scene/json.h"

#define JSMN_STATIC
#define JSMN_PARENT_LINKS
#define JSMN_STRICT
#include <jsmn.h>

#include <errno.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

void json_free(struct json *doc)
{
    free(doc->name);
    free(doc->text);
    free(doc->nodes);
    *doc = (struct json){0};
}

void json_position(const struct json *doc, int offset, int *line, int *column)
{
    *line = *column = 1;
    for (int i = 0; i < offset && i < doc->length; i++) {
        if (doc->text[i] == '\n') {
            ++*line;
            *column = 1;
        } else if (((unsigned char)doc->text[i] & 0xc0) != 0x80) {
            ++*column;
        }
    }
}

enum status json_fail(const struct json *doc, int offset, struct error *e, const char *format, ...)
{
    char text[1500];
    int line, column;
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    if (!doc->is_file)
        return error_set(e, STATUS_USAGE, "%.400s: %s", doc->name, text);
    json_position(doc, offset, &line, &column);
    return error_set(e, STATUS_USAGE, "%.400s:%d:%d: %s", doc->name, line, column, text);
}

static enum json_kind kind_of(const struct json *doc, const jsmntok_t *token)
{
    switch (token->type) {
    case JSMN_OBJECT: return JSON_OBJECT;
    case JSMN_ARRAY: return JSON_ARRAY;
    case JSMN_STRING: return JSON_STRING;
    default: break;
    }
    char first = doc->text[token->start];
    return first == 'n' ? JSON_NULL : first == 't' || first == 'f' ? JSON_BOOL : JSON_NUMBER;
}

/* Each node's `next` follows from those after it, so they are made from the last to the first. */
static void nodes_fill(struct json *doc, const jsmntok_t *tokens)
{
    for (int i = doc->count - 1; i >= 0; i--) {
        struct json_node *n = &doc->nodes[i];
        *n = (struct json_node){.kind = kind_of(doc, &tokens[i]), .start = tokens[i].start,
                                .end = tokens[i].end, .size = tokens[i].size, .next = i + 1};
        for (int k = 0; k < n->size; k++)
            n->next = doc->nodes[n->next].next;
    }
}

/* The text is known to be valid JSON, with white space at its end for jsmn's strict mode. */
static enum status nodes_create(struct json *doc, struct error *e)
{
    jsmn_parser parser;
    jsmn_init(&parser);
    int count = jsmn_parse(&parser, doc->text, (size_t)doc->length, NULL, 0);
    if (count < 1)
        return json_fail(doc, (int)parser.pos, e, "not understood");
    jsmntok_t *tokens = calloc((size_t)count, sizeof *tokens);
    doc->nodes = calloc((size_t)count, sizeof *doc->nodes);
    enum status status = STATUS_OK;
    if (!tokens || !doc->nodes) {
        status = error_set(e, STATUS_RUN, "%s: memory is short", doc->name);
        goto end;
    }
    jsmn_init(&parser);
    doc->count = jsmn_parse(&parser, doc->text, (size_t)doc->length, tokens, (unsigned)count);
    if (doc->count != count)
        status = json_fail(doc, (int)parser.pos, e, "not understood");
    else
        nodes_fill(doc, tokens);
end:
    free(tokens);
    return status;
}

static enum status document_parse(struct json *doc, struct error *e)
{
    struct json_fault fault;
    if (!json_check(doc->text, doc->length, &fault))
        return json_fail(doc, fault.offset, e, "%s", fault.text);
    doc->text[doc->length++] = '\n';
    doc->text[doc->length] = '\0';
    return nodes_create(doc, e);
}

enum status json_read_text(struct json *doc, const char *name, const char *text, struct error *e)
{
    size_t length = strlen(text);
    *doc = (struct json){.name = strdup(name), .text = malloc(length + 2)};
    if (!doc->name || !doc->text)
        return error_set(e, STATUS_RUN, "%s: memory is short", name);
    if (length > JSON_SIZE_LIMIT)
        return error_set(e, STATUS_USAGE, "%.200s: more than %d bytes", name, JSON_SIZE_LIMIT);
    memcpy(doc->text, text, length + 1);
    doc->length = (int)length;
    return document_parse(doc, e);
}

static enum status file_content(struct json *doc, FILE *file, struct error *e)
{
    size_t room = 64 << 10, length = 0;
    for (;;) {
        char *grown = realloc(doc->text, room + 2);
        if (!grown)
            return error_set(e, STATUS_RUN, "%s: memory is short", doc->name);
        doc->text = grown;
        length += fread(doc->text + length, 1, room - length, file);
        if (length > JSON_SIZE_LIMIT)
            return error_set(e, STATUS_USAGE, "%s: more than %d MiB, this is no scene file",
                             doc->name, JSON_SIZE_LIMIT >> 20);
        if (length < room)
            break;
        room *= 2;
    }
    if (ferror(file))
        return error_set(e, STATUS_USAGE, "%s: cannot be read: %s", doc->name, strerror(errno));
    doc->text[length] = '\0';
    doc->length = (int)length;
    return STATUS_OK;
}

enum status json_read_file(struct json *doc, const char *path, struct error *e)
{
    struct stat info;
    *doc = (struct json){.name = strdup(path), .is_file = true};
    if (!doc->name)
        return error_set(e, STATUS_RUN, "%s: memory is short", path);
    if (stat(path, &info) == 0 && S_ISDIR(info.st_mode))
        return error_set(e, STATUS_USAGE, "%s: this is a directory; give a scene file in it", path);
    FILE *file = fopen(path, "rb");
    if (!file)
        return error_set(e, STATUS_USAGE, "%s: cannot be opened: %s", path, strerror(errno));
    enum status status = file_content(doc, file, e);
    fclose(file);
    return status ? status : document_parse(doc, e);
}
