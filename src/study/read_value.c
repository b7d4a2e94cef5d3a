/* Reads members of objects in a study file. */
#include "study/read_value.h"

#include "base/suggest.h"
#include "scene/keys.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int place_of(const struct json *doc, int node)
{
    return doc->nodes[node].start - (doc->nodes[node].kind == JSON_STRING);
}

enum status read_member(const struct json *doc, int object, const char *key, enum json_kind kind,
                        bool needed, int *node, struct error *e)
{
    *node = json_member(doc, object, key);
    if (*node < 0 && needed)
        return json_fail(doc, place_of(doc, object), e, "\"%s\" is missing; give %s", key,
                         json_kind_name(kind));
    if (*node >= 0 && doc->nodes[*node].kind != kind)
        return json_fail(doc, place_of(doc, *node), e, "\"%s\" is %s; give %s", key,
                         json_kind_name(doc->nodes[*node].kind), json_kind_name(kind));
    return STATUS_OK;
}

enum status read_text(const struct json *doc, int object, const char *key, bool needed, char *out,
                      size_t size, struct error *e)
{
    int node;
    if (read_member(doc, object, key, JSON_STRING, needed, &node, e) || node < 0)
        return e->status;
    if (!json_string(doc, node, out, size))
        return json_fail(doc, place_of(doc, node), e, "\"%s\" is longer than %zu bytes", key,
                         size - 1);
    return STATUS_OK;
}

enum status read_long_text(const struct json *doc, int object, const char *key, char **out,
                           struct error *e)
{
    int node;
    if (read_member(doc, object, key, JSON_STRING, false, &node, e) || node < 0)
        return e->status;
    size_t size = (size_t)(doc->nodes[node].end - doc->nodes[node].start) + 1;
    free(*out);
    *out = malloc(size);
    if (!*out)
        return error_set(e, STATUS_RUN, "memory is short");
    json_string(doc, node, *out, size);
    return STATUS_OK;
}

enum status read_number(const struct json *doc, int object, const char *key, double min, double max,
                        double *out, struct error *e)
{
    int node;
    if (read_member(doc, object, key, JSON_NUMBER, false, &node, e) || node < 0)
        return e->status;
    double value = strtod(doc->text + doc->nodes[node].start, NULL);
    if (!(value >= min && value <= max))
        return json_fail(doc, place_of(doc, node), e, "\"%s\" is %g; give a number from %g to %g",
                         key, value, min, max);
    *out = value;
    return STATUS_OK;
}

enum status read_variant(const struct json *doc, int object, const char *key,
                         const struct variant_table *table, const struct variant **out,
                         struct error *e)
{
    char name[KEY_TEXT_SIZE];
    struct suggest suggest;
    int node;
    if (read_member(doc, object, key, JSON_STRING, false, &node, e) || node < 0)
        return e->status;
    json_string(doc, node, name, sizeof name);
    if ((*out = variant_find(table, name)))
        return STATUS_OK;
    suggest_start(&suggest, name);
    for (size_t k = 0; k < table->count; k++)
        suggest_offer(&suggest, table->rows[k]->name);
    const char *best = suggest_best(&suggest);
    return json_fail(doc, place_of(doc, node), e, "there is no \"%s\" among the %s%s%s%s; `sph-render "
                     "list %s` has them", name, table->name, best ? "; did you mean \"" : "",
                     best ? best : "", best ? "\"?" : "", table->name);
}

enum status read_only(const struct json *doc, int object, const char *words, struct error *e)
{
    int key = object + 1;
    for (int k = 0; k < doc->nodes[object].size; k++, key = doc->nodes[key].next) {
        char name[KEY_TEXT_SIZE], word[KEY_TEXT_SIZE];
        struct suggest suggest;
        json_string(doc, key, name, sizeof name);
        if (key_word_index(words, name) >= 0)
            continue;
        suggest_start(&suggest, name);
        for (int i = 0; key_word_at(words, i, word), word[0]; i++)
            suggest_offer(&suggest, word);
        const char *best = suggest_best(&suggest);
        return json_fail(doc, place_of(doc, key), e, "there is no key \"%s\" here; %s%s%s", name,
                         best ? "did you mean \"" : "there are ", best ? best : words,
                         best ? "\"?" : "");
    }
    return STATUS_OK;
}
