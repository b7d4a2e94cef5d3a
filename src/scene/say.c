/* Notes where in the file and the overrides each key is said; finds unknown and duplicate keys. */
#include "base/quote.h"
#include "base/suggest.h"
#include "scene/load.h"
#include "scene/value.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct scope { /* an object whose members are keys */
    struct place *said;         /* by row */
    char prefix[KEY_TEXT_SIZE]; /* of the keys: "bodies[]." */
    char label[KEY_TEXT_SIZE];  /* for messages: "bodies.1." */
};

static enum status say_object(struct load *load, const struct scope *scope, struct place place);

static struct scope scope_below(const struct scope *scope, const char *name)
{
    struct scope below = {.said = scope->said};
    snprintf(below.prefix, sizeof below.prefix, "%.60s%.60s.", scope->prefix, name);
    snprintf(below.label, sizeof below.label, "%.60s%.60s.", scope->label, name);
    return below;
}

static struct scope scope_element(struct load *load, int array, size_t i)
{
    struct scope element = {.said = load->arrays[array].said + i * load->keys.count};
    snprintf(element.prefix, sizeof element.prefix, "%s", scene_arrays[array].prefix);
    snprintf(element.label, sizeof element.label, "%s.%zu.", scene_arrays[array].name, i);
    return element;
}

/* A key of that name elsewhere in the scene, or NULL. */
static const char *key_elsewhere(const struct key_list *keys, const char *name)
{
    for (size_t i = 0; i < keys->count; i++) {
        const char *path = keys->items[i].key->path, *dot = strrchr(path, '.');
        if (strcmp(dot ? dot + 1 : path, name) == 0)
            return path;
    }
    return NULL;
}

static enum status unknown_key(struct load *load, const struct scope *scope, const char *name,
                               struct place key)
{
    struct suggest near;
    char child[KEY_TEXT_SIZE], known[700] = "";
    suggest_start(&near, name);
    for (size_t i = 0; i < load->keys.count; i++) {
        if (key_child(&load->keys, i, scope->prefix, child) == PLACE_NONE)
            continue;
        size_t n = strlen(known);
        snprintf(known + n, sizeof known - n, "%s%s", n ? ", " : "", child);
        suggest_offer(&near, child);
    }
    const char *best = suggest_best(&near), *other = key_elsewhere(&load->keys, name);
    if (other && (!best || strcasecmp(best, name) != 0))
        return load_fail(load, key, "unknown key \"%s%s\"; did you mean \"%s\"? Known here: %s",
                         scope->label, name, other, known);
    if (best)
        return load_fail(load, key, "unknown key \"%s%s\"; did you mean \"%s%s\"? Known here: %s",
                         scope->label, name, scope->label, best, known);
    return load_fail(load, key, "unknown key \"%s%s\"; known here: %s", scope->label, name, known);
}

/* One word for all keys below: checked once under the group's own name. */
static enum status say_group(struct load *load, const struct scope *scope, size_t row,
                             struct place place)
{
    const struct key *group = load->keys.items[row].key;
    size_t length = strlen(group->path);
    int ignored;
    enum status status = value_read(place.doc, place.node, group, group->path,
                                    load->keys.vocabulary, &ignored, load->e);
    for (size_t i = 0; i < load->keys.count; i++) {
        const char *path = load->keys.items[i].key->path;
        if (strncmp(path, group->path, length) == 0 && path[length] == '.')
            scope->said[i] = place;
    }
    return status;
}

/* A said array replaces an earlier one whole. */
static enum status say_array(struct load *load, int array, struct place place)
{
    struct said_array *a = &load->arrays[array];
    const struct json_node *nodes = place.doc->nodes;
    if (nodes[place.node].kind != JSON_ARRAY)
        return load_fail(load, place, "%s must be an array of objects: [{...}, {...}]",
                         scene_arrays[array].name);
    free(a->elements);
    free(a->said);
    a->place = place;
    a->count = (size_t)nodes[place.node].size;
    a->elements = calloc(a->count + 1, sizeof *a->elements);
    a->said = calloc((a->count + 1) * load->keys.count, sizeof *a->said);
    if (!a->elements || !a->said) {
        a->count = 0;
        return error_set(load->e, STATUS_RUN, "memory is short");
    }
    int node = place.node + 1;
    for (size_t i = 0; i < a->count; i++, node = nodes[node].next) {
        struct scope element = scope_element(load, array, i);
        a->elements[i] = (struct place){place.doc, node};
        enum status status = say_object(load, &element, a->elements[i]);
        if (status)
            return status;
    }
    return STATUS_OK;
}

static int array_of(const char *path)
{
    for (int a = 0; a < ARRAY_COUNT; a++)
        if (strncmp(path, scene_arrays[a].prefix, strlen(scene_arrays[a].prefix)) == 0)
            return a;
    return -1;
}

/* `key` is the place of the name, `place` that of the value. */
static enum status say_member(struct load *load, const struct scope *scope, const char *name,
                              struct place key, struct place place)
{
    enum key_place kind;
    size_t row = key_child_find(&load->keys, scope->prefix, name, &kind);
    if (row == load->keys.count)
        return unknown_key(load, scope, name, key);
    if (kind == PLACE_ARRAY)
        return say_array(load, array_of(load->keys.items[row].key->path), place);
    bool object = place.doc->nodes[place.node].kind == JSON_OBJECT;
    if (kind == PLACE_OBJECT || (kind == PLACE_GROUP && object)) {
        struct scope below = scope_below(scope, name);
        return say_object(load, &below, place);
    }
    if (kind == PLACE_GROUP)
        return say_group(load, scope, row, place);
    scope->said[row] = place;
    return STATUS_OK;
}

/* Whether the object has an earlier key of the same name. */
static bool said_before(const struct json *doc, int object, int key, const char *name)
{
    char other[KEY_TEXT_SIZE];
    for (int k = object + 1; k < key; k = doc->nodes[k].next)
        if (json_string(doc, k, other, sizeof other) && strcmp(other, name) == 0)
            return true;
    return false;
}

static enum status say_object(struct load *load, const struct scope *scope, struct place place)
{
    const struct json *doc = place.doc;
    const struct json_node *object = &doc->nodes[place.node];
    int length = (int)strlen(scope->label) - 1;
    if (object->kind != JSON_OBJECT)
        return load_fail(load, place, "%.*s must be an object {...}, not %s",
                         length < 0 ? 9 : length, length < 0 ? "the scene" : scope->label,
                         json_kind_name(object->kind));
    for (int k = place.node + 1; k < object->next; k = doc->nodes[k].next) {
        char name[KEY_TEXT_SIZE];
        struct place key = {doc, k};
        json_string(doc, k, name, sizeof name);
        if (said_before(doc, place.node, k, name))
            return load_fail(load, key, "\"%s%s\" is said twice; remove one", scope->label, name);
        enum status status = say_member(load, scope, name, key, (struct place){doc, k + 1});
        if (status)
            return status;
    }
    return STATUS_OK;
}

enum status say_file(struct load *load)
{
    struct scope root = {.said = load->said};
    return say_object(load, &root, (struct place){&load->file, 0});
}

/* Text types take bare text; the others take it where it can only be a word ("auto"). */
static enum status parse_value(struct load *load, struct json *doc, const struct key *key,
                               const char *label, const char *value)
{
    char quoted[1024];
    bool text = key && (key->type == KEY_TEXT || key->type == KEY_CHOICE || key->type == KEY_ENUM);
    enum status status = json_read_text(doc, label, value, load->e);
    if (!status && (!text || doc->nodes[0].kind == JSON_STRING || doc->nodes[0].size > 0))
        return STATUS_OK;
    if (status == STATUS_RUN || (!text && !isalpha((unsigned char)value[0])))
        return status;
    json_free(doc);
    if (!json_quote(value, quoted, sizeof quoted))
        return error_set(load->e, STATUS_USAGE, "%.200s: the value is too long", label);
    load->e->status = STATUS_OK; /* of the try without quotes */
    return json_read_text(doc, label, quoted, load->e);
}

/* "bodies.1": leaves the element's scope in *scope; `rest` begins with the number. */
static enum status enter_element(struct load *load, struct scope *scope, int array,
                                 const char **rest, size_t *element)
{
    const char *name = scene_arrays[array].name;
    char *end;
    size_t count = load->arrays[array].count;
    unsigned long i = strtoul(*rest, &end, 10);
    if (!isdigit((unsigned char)**rest) || (*end && *end != '.'))
        return error_set(load->e, STATUS_USAGE,
                         "elements of %s are addressed by number from 0: %s.0.KEY", name, name);
    if (i >= count)
        return error_set(load->e, STATUS_USAGE, "there is no %s.%lu; the scene has %zu, counted "
                         "from 0", name, i, count);
    *scope = scope_element(load, array, i);
    *rest = *end ? end + 1 : end;
    *element = i;
    return STATUS_OK;
}

/* Follows the path to the object that holds its last name; `last` is "" for a whole element. */
static enum status follow(struct load *load, const char *path, struct scope *scope,
                          const char **last, int *array, size_t *element)
{
    *array = -1;
    while (*(*last = path)) {
        char name[KEY_TEXT_SIZE];
        enum key_place kind;
        size_t length = strcspn(path, ".");
        snprintf(name, sizeof name, "%.*s", (int)(length > 100 ? 100 : length), path);
        size_t row = key_child_find(&load->keys, scope->prefix, name, &kind);
        if (!path[length] || row == load->keys.count || kind == PLACE_LEAF)
            return STATUS_OK;
        path += length + 1;
        if (kind == PLACE_ARRAY) {
            *array = array_of(load->keys.items[row].key->path);
            enum status status = enter_element(load, scope, *array, &path, element);
            if (status)
                return status;
        } else {
            *scope = scope_below(scope, name);
        }
    }
    return STATUS_OK;
}

static enum status say_set(struct load *load, struct json *doc, const char *item,
                           const char *label)
{
    char path[KEY_TEXT_SIZE];
    const char *equals = strchr(item, '='), *last;
    struct scope scope = {.said = load->said};
    int array;
    size_t element = 0, row;
    enum key_place kind = PLACE_NONE;
    if (!equals || equals == item || (size_t)(equals - item) >= sizeof path)
        return error_set(load->e, STATUS_USAGE, "%.300s: write key.path=value, for example "
                         "time.end=2", label);
    snprintf(path, sizeof path, "%.*s", (int)(equals - item), item);
    enum status status = follow(load, path, &scope, &last, &array, &element);
    if (status) {
        error_context(load->e, "%.300s", label);
        return status;
    }
    row = key_child_find(&load->keys, scope.prefix, last, &kind);
    bool leaf = *last && (kind == PLACE_LEAF || kind == PLACE_GROUP);
    status = parse_value(load, doc, leaf ? load->keys.items[row].key : NULL, label, equals + 1);
    if (status)
        return status;
    struct place place = {doc, 0};
    if (*last)
        return say_member(load, &scope, last, place, place);
    if (array >= 0)
        load->arrays[array].elements[element] = place;
    return say_object(load, &scope, place);
}

/* The word of a key that takes one, as far as it is said now. */
static void word_now(const struct load *load, size_t row, char word[KEY_TEXT_SIZE])
{
    const struct place said = load->said[row];
    if (!said.doc || !json_string(said.doc, said.node, word, KEY_TEXT_SIZE))
        sscanf(load->keys.items[row].key->fallback, "\"%127[^\"]", word);
}

static void forget(struct load *load, size_t row)
{
    if (load->said[row].doc == &load->file)
        load->said[row] = (struct place){0};
}

/* Ranges of one quantity are not those of another: forgets what the file says in the unit of color.by. */
static void forget_ranges(struct load *load)
{
    for (size_t i = 0; i < load->keys.count; i++)
        if (strcmp(load->keys.items[i].key->unit, "of color.by") == 0)
            forget(load, i);
}

/* Of two keys that exclude each other, an override's replaces the file's, unless it says only the usual. */
static void forget_excluded(struct load *load)
{
    static const char *const pairs[][2] = {{"color.range", "color.percentiles"}, {"color.map", "color.map_file"}};
    for (size_t k = 0; k < 2 * sizeof pairs / sizeof *pairs; k++) {
        const size_t said = key_list_find(&load->keys, pairs[k / 2][k % 2]);
        const struct place place = load->said[said];
        char word[KEY_TEXT_SIZE] = "-";
        if (!place.doc || place.doc == &load->file)
            continue;
        json_string(place.doc, place.node, word, sizeof word);
        if (word[0] && strcmp(word, "auto") != 0)
            forget(load, key_list_find(&load->keys, pairs[k / 2][1 - k % 2]));
    }
}

enum status say_overrides(struct load *load, const struct scene_overrides *set)
{
    const size_t by = key_list_find(&load->keys, "color.by");
    char label[512], before[KEY_TEXT_SIZE] = "", after[KEY_TEXT_SIZE] = "";
    word_now(load, by, before);
    for (size_t i = 0; i < load->set_count; i++) {
        if (set->labels && set->labels[i])
            snprintf(label, sizeof label, "%s", set->labels[i]);
        else
            snprintf(label, sizeof label, "--set %s", set->items[i]);
        if (say_set(load, &load->sets[i], set->items[i], label))
            return load->e->status;
    }
    word_now(load, by, after);
    if (strcmp(before, after) != 0)
        forget_ranges(load);
    forget_excluded(load);
    return STATUS_OK;
}
