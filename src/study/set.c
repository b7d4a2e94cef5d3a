/* Builds settings of scene keys from a study's JSON. */
#include "study/set.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static enum status memory_short(struct error *e)
{
    return error_set(e, STATUS_RUN, "memory is short");
}

/* Takes both texts, also on failure. */
static enum status set_take(struct study_set *set, char *item, char *label, struct error *e)
{
    char **items = realloc(set->items, (set->count + 1) * sizeof *items);
    set->items = items ? items : set->items;
    char **labels = realloc(set->labels, (set->count + 1) * sizeof *labels);
    set->labels = labels ? labels : set->labels;
    if (!items || !labels || !item || !label) {
        free(item);
        free(label);
        return memory_short(e);
    }
    set->items[set->count] = item;
    set->labels[set->count++] = label;
    return STATUS_OK;
}

/* First and last byte of a value's JSON text. */
static void value_span(const struct json *doc, int node, int *start, int *length)
{
    const struct json_node *n = &doc->nodes[node];
    int quote = n->kind == JSON_STRING;
    *start = n->start - quote;
    *length = n->end + quote - *start;
}

enum status set_add(struct study_set *set, const struct json *doc, int key, int value,
                    struct error *e)
{
    char name[KEY_TEXT_SIZE], *item = NULL, *label = NULL;
    int start, length, line, column;
    if (!json_string(doc, key, name, sizeof name))
        return json_fail(doc, doc->nodes[key].start, e, "the key is too long");
    value_span(doc, value, &start, &length);
    json_position(doc, start, &line, &column);
    if (asprintf(&item, "%s=%.*s", name, length, doc->text + start) < 0)
        item = NULL;
    if (asprintf(&label, "%s:%d:%d: %s", doc->name, line, column, name) < 0)
        label = NULL;
    return set_take(set, item, label, e);
}

enum status set_say(struct study_set *set, const char *key, const char *value, const char *label,
                    struct error *e)
{
    char *item = NULL;
    if (asprintf(&item, "%s=%s", key, value) < 0)
        item = NULL;
    return set_take(set, item, strdup(label), e);
}

enum status set_add_object(struct study_set *set, const struct json *doc, int object,
                           struct error *e)
{
    int key = object + 1;
    for (int k = 0; k < doc->nodes[object].size; k++, key = doc->nodes[key].next)
        if (set_add(set, doc, key, key + 1, e))
            return e->status;
    return STATUS_OK;
}

enum status set_append(struct study_set *set, const struct study_set *more, struct error *e)
{
    for (size_t k = 0; k < more->count; k++)
        if (set_take(set, strdup(more->items[k]), strdup(more->labels[k]), e))
            return e->status;
    return STATUS_OK;
}

void set_free(struct study_set *set)
{
    for (size_t k = 0; k < set->count; k++) {
        free(set->items[k]);
        free(set->labels[k]);
    }
    free(set->items);
    free(set->labels);
    *set = (struct study_set){0};
}

void set_value_text(const struct json *doc, int node, char *out, size_t size)
{
    int start, length;
    if (doc->nodes[node].kind == JSON_STRING) {
        json_string(doc, node, out, size);
        return;
    }
    value_span(doc, node, &start, &length);
    snprintf(out, size, "%.*s", length, doc->text + start);
}

int set_list_at(const struct set_lists *lists, size_t place, int *list)
{
    const struct json *doc = lists->doc;
    int key = lists->object + 1;
    if (place >= (size_t)doc->nodes[lists->object].size)
        return -1;
    for (; place > 0; place--)
        key = doc->nodes[key].next;
    *list = key + 1;
    return key;
}

int set_value_at(const struct json *doc, int array, size_t place)
{
    int node = array + 1;
    for (; place > 0; place--)
        node = doc->nodes[node].next;
    return node;
}
