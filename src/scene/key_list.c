/* Joins the core keys with those of the vocabulary's variants, and finds keys by path. */
#include "scene/keys.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum status key_list_create(struct key_list *list, const struct vocabulary *vocabulary,
                            struct error *e)
{
    size_t count = scene_core_key_count, tables = vocabulary ? vocabulary->count : 0;
    for (size_t t = 0; t < tables; t++)
        for (size_t i = 0; i < vocabulary->tables[t]->count; i++)
            count += vocabulary->tables[t]->rows[i]->key_count;
    *list = (struct key_list){.items = calloc(count, sizeof *list->items),
                              .vocabulary = vocabulary};
    if (!list->items)
        return error_set(e, STATUS_RUN, "memory is short");
    for (size_t i = 0; i < scene_core_key_count; i++)
        list->items[list->count++].key = &scene_core_keys[i];
    for (size_t t = 0; t < tables; t++) {
        const struct variant_table *table = vocabulary->tables[t];
        for (size_t i = 0; i < table->count; i++)
            for (size_t k = 0; k < table->rows[i]->key_count; k++)
                list->items[list->count++] =
                    (struct key_entry){&table->rows[i]->keys[k], table, table->rows[i]};
    }
    return STATUS_OK;
}

void key_list_free(struct key_list *list)
{
    free(list->items);
    *list = (struct key_list){0};
}

size_t key_list_find(const struct key_list *list, const char *path)
{
    size_t i = 0;
    while (i < list->count && strcmp(list->items[i].key->path, path) != 0)
        i++;
    return i;
}

const struct key *key_chooser(const struct variant_table *table)
{
    for (size_t i = 0; i < scene_core_key_count; i++) {
        const struct key *key = &scene_core_keys[i];
        if (key->type == KEY_CHOICE && strcmp(key->choices, table->name) == 0)
            return key;
    }
    return NULL;
}

bool key_list_active(const struct key_list *list, size_t row, const void *base)
{
    const struct key_entry *entry = &list->items[row];
    if (!entry->owner)
        return true;
    const struct key *chooser = key_chooser(entry->table);
    return !chooser ||
           strcmp((const char *)base + chooser->offset, entry->owner->name) == 0;
}

size_t key_list_find_active(const struct key_list *list, const char *path, const void *base)
{
    size_t i = 0;
    while (i < list->count && (strcmp(list->items[i].key->path, path) != 0 ||
                               !key_list_active(list, i, base)))
        i++;
    return i;
}

/* Whether the path leads through prefix + name; `rest` is what follows. */
static bool leads_through(const char *path, const char *prefix, const char *name,
                          const char **rest)
{
    size_t p = strlen(prefix), n = strlen(name);
    if (strncmp(path, prefix, p) != 0 || strncmp(path + p, name, n) != 0)
        return false;
    *rest = path + p + n;
    return **rest == '\0' || **rest == '.' || **rest == '[';
}

enum key_place key_child(const struct key_list *list, size_t row, const char *prefix,
                         char name[KEY_TEXT_SIZE])
{
    const char *path = list->items[row].key->path, *rest;
    size_t p = strlen(prefix);
    if (strncmp(path, prefix, p) != 0)
        return PLACE_NONE;
    snprintf(name, KEY_TEXT_SIZE, "%.*s", (int)strcspn(path + p, ".["), path + p);
    for (size_t i = 0; i < row; i++)
        if (leads_through(list->items[i].key->path, prefix, name, &rest))
            return PLACE_NONE;
    rest = path + p + strlen(name);
    if (*rest == '[')
        return PLACE_ARRAY;
    if (*rest == '.')
        return PLACE_OBJECT;
    return list->items[row].key->offset == KEY_GROUP ? PLACE_GROUP : PLACE_LEAF;
}

size_t key_child_find(const struct key_list *list, const char *prefix, const char *name,
                      enum key_place *place)
{
    const char *rest;
    for (size_t i = 0; i < list->count; i++) {
        char found[KEY_TEXT_SIZE];
        if (!leads_through(list->items[i].key->path, prefix, name, &rest))
            continue;
        *place = key_child(list, i, prefix, found);
        /* A name with a dot or bracket in it is no child. */
        return strcmp(found, name) == 0 ? i : list->count;
    }
    *place = PLACE_NONE;
    return list->count;
}

const struct variant_table *vocabulary_table(const struct vocabulary *vocabulary, const char *name)
{
    for (size_t t = 0; vocabulary && t < vocabulary->count; t++)
        if (strcmp(vocabulary->tables[t]->name, name) == 0)
            return vocabulary->tables[t];
    return NULL;
}

int key_word_index(const char *choices, const char *word)
{
    char known[KEY_TEXT_SIZE];
    for (int i = 0; key_word_at(choices, i, known), known[0]; i++)
        if (strcmp(known, word) == 0)
            return i;
    return -1;
}

void key_word_at(const char *choices, int index, char word[KEY_TEXT_SIZE])
{
    for (; index > 0 && *choices; index--) {
        choices += strcspn(choices, "|");
        choices += *choices == '|';
    }
    snprintf(word, KEY_TEXT_SIZE, "%.*s", (int)strcspn(choices, "|"), choices);
}
