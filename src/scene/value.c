/* Reads single values from JSON nodes, checking type, range and words. */
#include "scene/value.h"
#include "base/suggest.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct reading { /* one value on its way */
    const struct json *doc;
    int node;
    const struct key *key;
    const char *path;
    const struct vocabulary *vocabulary;
    struct error *e;
};

static int start_of(const struct reading *r, int node)
{
    const struct json_node *n = &r->doc->nodes[node];
    return n->kind == JSON_STRING ? n->start - 1 : n->start;
}

static const char *auto_hint(const struct reading *r)
{
    return r->key->flags & KEY_AUTO ? " (or \"auto\")" : "";
}

static enum status wrong_type(const struct reading *r, int node)
{
    char expected[160];
    value_expected(r->key, expected, sizeof expected);
    const struct json_node *n = &r->doc->nodes[node];
    const char *mark = n->kind == JSON_STRING ? "\"" : "";
    int length = n->end - n->start < 40 ? n->end - n->start : 40;
    if (n->kind == JSON_STRING || n->kind == JSON_NUMBER || n->kind == JSON_BOOL)
        return json_fail(r->doc, start_of(r, node), r->e, "%s must be %s%s, not %s%.*s%s", r->path,
                         expected, auto_hint(r), mark, length, r->doc->text + n->start, mark);
    return json_fail(r->doc, start_of(r, node), r->e, "%s must be %s%s, not %s", r->path, expected,
                     auto_hint(r), json_kind_name(n->kind));
}

static enum status check_range(const struct reading *r, int node, double value)
{
    const struct key *key = r->key;
    char expected[160];
    bool limited = key->min != key->max;
    bool low = key->flags & KEY_ABOVE_MIN ? value <= key->min : value < key->min;
    if (isfinite(value) && (!limited || (!low && value <= key->max)))
        return STATUS_OK;
    value_expected(key, expected, sizeof expected);
    const struct json_node *n = &r->doc->nodes[node];
    int length = n->end - n->start < 40 ? n->end - n->start : 40;
    return json_fail(r->doc, n->start, r->e, "%s: %.*s is %s; it must be %s%s", r->path, length,
                     r->doc->text + n->start, isfinite(value) ? "out of range" : "not finite",
                     expected, auto_hint(r));
}

static enum status read_real(const struct reading *r, int node, double *out)
{
    if (r->doc->nodes[node].kind != JSON_NUMBER)
        return wrong_type(r, node);
    *out = strtod(r->doc->text + r->doc->nodes[node].start, NULL);
    return check_range(r, node, *out);
}

static enum status read_integer(const struct reading *r, int node, int64_t *out)
{
    const struct json_node *n = &r->doc->nodes[node];
    double value = 0;
    enum status status = read_real(r, node, &value);
    if (status)
        return status;
    if (value != floor(value) || fabs(value) >= 9.2233720368547e18)
        return wrong_type(r, node);
    /* Plain digits are exact beyond 2^53; 1e3 and 5.0 are integers too. */
    size_t plain = strspn(r->doc->text + n->start, "-0123456789");
    *out = plain == (size_t)(n->end - n->start) ? strtoll(r->doc->text + n->start, NULL, 10)
                                                : (int64_t)value;
    return STATUS_OK;
}

static enum status read_numbers(const struct reading *r, double *out, int count)
{
    if (r->doc->nodes[r->node].kind != JSON_ARRAY || r->doc->nodes[r->node].size != count)
        return wrong_type(r, r->node);
    enum status status = STATUS_OK;
    for (int i = 0, node = r->node + 1; i < count && !status; i++, node = r->doc->nodes[node].next)
        status = read_real(r, node, &out[i]);
    return status;
}

static enum status read_size(const struct reading *r, int *out)
{
    if (r->doc->nodes[r->node].kind != JSON_ARRAY || r->doc->nodes[r->node].size != 2)
        return wrong_type(r, r->node);
    for (int i = 0; i < 2; i++) {
        int64_t value = 0;
        enum status status = read_integer(r, r->node + 1 + i, &value);
        if (status)
            return status;
        out[i] = (int)value;
    }
    return STATUS_OK;
}

static enum status read_text(const struct reading *r, char *out)
{
    if (r->doc->nodes[r->node].kind != JSON_STRING)
        return wrong_type(r, r->node);
    if (!json_string(r->doc, r->node, out, KEY_TEXT_SIZE))
        return json_fail(r->doc, start_of(r, r->node), r->e,
                         "%s is longer than %d bytes; shorten it", r->path, KEY_TEXT_SIZE - 1);
    return STATUS_OK;
}

static enum status unknown_word(const struct reading *r, const char *word, struct suggest *near,
                                const char *known)
{
    const char *best = suggest_best(near);
    return json_fail(r->doc, start_of(r, r->node), r->e, "%s: \"%s\" is unknown%s%s%s; known: %s%s",
                     r->path, word, best ? "; did you mean \"" : "", best ? best : "",
                     best ? "\"?" : "", known, auto_hint(r));
}

/* One of the words "a|b|c": its place, or -1 with the message recorded. */
static int read_word(const struct reading *r, const char *text)
{
    struct suggest near;
    char word[KEY_TEXT_SIZE], known[600] = "";
    int found = key_word_index(r->key->choices, text);
    if (found >= 0)
        return found;
    suggest_start(&near, text);
    for (int i = 0; key_word_at(r->key->choices, i, word), word[0]; i++) {
        size_t n = strlen(known);
        snprintf(known + n, sizeof known - n, "%s%s", i ? ", " : "", word);
        suggest_offer(&near, word);
    }
    unknown_word(r, text, &near, known);
    return -1;
}

static enum status read_variant(const struct reading *r, const char *text)
{
    const struct variant_table *table = vocabulary_table(r->vocabulary, r->key->choices);
    const struct variant *row = table ? variant_find(table, text) : NULL;
    struct suggest near;
    char known[600] = "";
    if (row && row->missing)
        return json_fail(r->doc, start_of(r, r->node), r->e, "%s: \"%s\" is not in this build: %s",
                         r->path, text, row->missing);
    if (row || !table)
        return STATUS_OK;
    suggest_start(&near, text);
    for (size_t i = 0; i < table->count; i++) {
        size_t n = strlen(known);
        snprintf(known + n, sizeof known - n, "%s%s", i ? ", " : "", table->rows[i]->name);
        suggest_offer(&near, table->rows[i]->name);
    }
    return unknown_word(r, text, &near, known);
}

/* Of KEY_SWITCH: 0 for false, 1 for true, bare or (by --set) as a word; else -1. */
static int read_switch(const struct reading *r)
{
    const struct json_node *n = &r->doc->nodes[r->node];
    char text[8] = "";
    if (!(r->key->flags & KEY_SWITCH))
        return -1;
    if (n->kind == JSON_BOOL)
        return r->doc->text[n->start] == 't';
    if (n->kind != JSON_STRING || !json_string(r->doc, r->node, text, sizeof text))
        return -1;
    return strcmp(text, "true") == 0 ? 1 : strcmp(text, "false") == 0 ? 0 : -1;
}

static enum status read_choice(const struct reading *r, void *memory)
{
    char text[KEY_TEXT_SIZE] = ""; /* its tail is copied too */
    int given = read_switch(r);
    if (given >= 0) {
        *(int *)memory = given;
        return STATUS_OK;
    }
    enum status status = read_text(r, text);
    if (status)
        return status;
    bool chosen = r->key->flags & KEY_AUTO && strcmp(text, "auto") == 0;
    if (r->key->type == KEY_ENUM || strchr(r->key->choices, '|')) {
        int word = chosen ? 0 : read_word(r, text);
        if (word < 0)
            return r->e->status;
        if (r->key->type == KEY_ENUM) {
            *(int *)memory = word;
            return STATUS_OK;
        }
    } else if (!chosen && (status = read_variant(r, text))) {
        return status;
    }
    memcpy(memory, text, sizeof text);
    return STATUS_OK;
}

static bool says_auto(const struct reading *r)
{
    char text[8];
    return r->key->flags & KEY_AUTO && r->doc->nodes[r->node].kind == JSON_STRING &&
           json_string(r->doc, r->node, text, sizeof text) && strcmp(text, "auto") == 0;
}

static enum status read_automatic(const struct reading *r, double *memory)
{
    size_t numbers = value_size(r->key->type) / sizeof(double);
    for (size_t i = 0; i < numbers; i++)
        memory[i] = NAN;
    return STATUS_OK;
}

enum status value_read(const struct json *doc, int node, const struct key *key, const char *path,
                       const struct vocabulary *vocabulary, void *memory, struct error *e)
{
    struct reading r = {doc, node, key, path, vocabulary, e};
    bool real = key->type == KEY_REAL || key->type == KEY_VEC3 || key->type == KEY_PAIR;
    if (real && says_auto(&r))
        return read_automatic(&r, memory);
    switch (key->type) {
    case KEY_BOOL:
        if (doc->nodes[node].kind != JSON_BOOL)
            return wrong_type(&r, node);
        *(bool *)memory = doc->text[doc->nodes[node].start] == 't';
        return STATUS_OK;
    case KEY_INT: return read_integer(&r, node, memory);
    case KEY_REAL: return read_real(&r, node, memory);
    case KEY_VEC3: return read_numbers(&r, memory, 3);
    case KEY_PAIR: return read_numbers(&r, memory, 2);
    case KEY_SIZE: return read_size(&r, memory);
    case KEY_TEXT: return read_text(&r, memory);
    case KEY_CHOICE:
    case KEY_ENUM: return read_choice(&r, memory);
    }
    return STATUS_OK;
}

enum status value_default(const struct key *key, const struct vocabulary *vocabulary, void *memory,
                          struct error *e)
{
    struct json doc;
    char name[KEY_TEXT_SIZE + 16];
    snprintf(name, sizeof name, "default of %s", key->path);
    enum status status = json_read_text(&doc, name, key->fallback, e);
    if (!status)
        status = value_read(&doc, 0, key, key->path, vocabulary, memory, e);
    json_free(&doc);
    return status;
}
