/* Loads a scene: reads the file, fills struct scene key by key, then checks it as a whole. */
#include "scene/load.h"
#include "base/suggest.h"
#include "scene/value.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

/* In the text; the beginning of the file when the place is not said. */
static int place_offset(const struct load *load, struct place place)
{
    const struct json *doc = place.doc ? place.doc : &load->file;
    const struct json_node *node = doc->nodes ? &doc->nodes[place.doc ? place.node : 0] : NULL;
    return node ? node->start - (node->kind == JSON_STRING) : 0;
}

struct scene_place load_position(const struct load *load, struct place place)
{
    struct scene_place at = {0};
    if (place.doc == &load->file)
        json_position(&load->file, place_offset(load, place), &at.line, &at.column);
    return at;
}

enum status load_fail(struct load *load, struct place place, const char *format, ...)
{
    char text[1500];
    va_list args;
    va_start(args, format);
    vsnprintf(text, sizeof text, format, args);
    va_end(args);
    return json_fail(place.doc ? place.doc : &load->file, place_offset(load, place), load->e, "%s",
                     text);
}

/* The object in the file that holds, or should hold, the key. */
static struct place holder(const struct load *load, const char *path)
{
    char name[KEY_TEXT_SIZE];
    const struct json *doc = &load->file;
    int node = 0;
    for (size_t n; node >= 0 && path[n = strcspn(path, ".")]; path += n + 1) {
        snprintf(name, sizeof name, "%.*s", (int)n, path);
        int below = json_member(doc, node, name);
        if (below < 0)
            break;
        node = below;
    }
    return (struct place){doc, node};
}

struct place load_place(const struct load *load, const char *path)
{
    size_t row = key_list_find(&load->keys, path);
    if (row < load->keys.count && load->said[row].doc)
        return load->said[row];
    return holder(load, path);
}

struct place load_element_place(const struct load *load, int array, size_t i, const char *path)
{
    const struct said_array *a = &load->arrays[array];
    size_t row = key_list_find(&load->keys, path);
    struct place place = row < load->keys.count ? a->said[i * load->keys.count + row]
                                                : (struct place){0};
    return place.doc ? place : a->elements[i];
}

static enum status missing_key(struct load *load, struct place parent, const struct key *key,
                               const char *path)
{
    char expected[160];
    value_expected(key, expected, sizeof expected);
    return load_fail(load, parent, "\"%s\" is missing; give %s%s%s (%s)", path, expected,
                     key->unit[0] ? " in " : "", key->unit, key->doc);
}

static enum status fill_value(struct load *load, const struct key *key, const char *path,
                              struct place said, struct place parent, void *memory)
{
    if (said.doc)
        return value_read(said.doc, said.node, key, path, load->keys.vocabulary, memory, load->e);
    if (key->fallback)
        return value_default(key, load->keys.vocabulary, memory, load->e);
    return missing_key(load, parent, key, path);
}

static enum status fill_globals(struct load *load)
{
    enum status status = STATUS_OK;
    for (size_t i = 0; i < load->keys.count && !status; i++) {
        const struct key *key = load->keys.items[i].key;
        if (load->keys.items[i].owner || key->offset == KEY_GROUP || strstr(key->path, "[]"))
            continue;
        status = fill_value(load, key, key->path, load->said[i], holder(load, key->path),
                            (char *)load->scene + key->offset);
    }
    return status;
}

/* A key of another shape: says which shapes read it. */
static enum status wrong_shape(struct load *load, struct place said, const struct key *key,
                               const char *path, const struct shape *shape)
{
    char fitting[200] = "";
    for (int i = SHAPE_BOX; i <= SHAPE_CYLINDER; i++) {
        size_t n = strlen(fitting);
        if (key_fits_shape(key, (enum shape_kind)i))
            snprintf(fitting + n, sizeof fitting - n, "%s%s", n ? " or " : "", shape_words[i]);
    }
    return load_fail(load, said, "%s is for shape %s only, and the shape here is %s; remove the key or "
                     "change the shape", path, fitting, shape_words[shape->kind]);
}

/* A key is said although no variant that reads it is chosen. `label` is what messages call the
 * element ("measure.0."), `base` its memory; or "" and the scene. */
static enum status refuse_option(struct load *load, size_t row, struct place said,
                                 const char *label, const void *base)
{
    const struct key_entry *entry = &load->keys.items[row];
    const struct key *chooser = key_chooser(entry->table);
    const char *path = entry->key->path, *choice = chooser->path;
    char owners[300] = "";
    if (*label) {
        path = strrchr(path, '.') + 1;
        choice = strrchr(choice, '.') + 1;
    }
    for (size_t i = row; i < load->keys.count; i++) {
        size_t n = strlen(owners);
        if (strcmp(load->keys.items[i].key->path, entry->key->path) == 0)
            snprintf(owners + n, sizeof owners - n, "%s\"%s\"", n ? " or " : "",
                     load->keys.items[i].owner->name);
    }
    return load_fail(load, said, "%s%s is read only while %s%s is %s, and it is \"%s\"; "
                     "remove the key or change %s%s", label, path, label, choice, owners,
                     (const char *)base + chooser->offset, label, choice);
}

/* Element keys that belong to a variant which the element did not choose are not to be said. */
static enum status pass_element_key(struct load *load, size_t row, struct place said,
                                    const char *label, const void *memory)
{
    const char *path = load->keys.items[row].key->path;
    if (!said.doc || key_list_find(&load->keys, path) != row ||
        key_list_find_active(&load->keys, path, memory) < load->keys.count)
        return STATUS_OK;
    return refuse_option(load, row, said, label, memory);
}

static enum status fill_element(struct load *load, int array, size_t element, void *memory)
{
    const char *prefix = scene_arrays[array].prefix;
    const struct said_array *a = &load->arrays[array];
    enum status status = STATUS_OK;
    for (size_t i = 0; i < load->keys.count && !status; i++) {
        const struct key *key = load->keys.items[i].key;
        char label[KEY_TEXT_SIZE], path[2 * KEY_TEXT_SIZE];
        if (strncmp(key->path, prefix, strlen(prefix)) != 0)
            continue;
        /* Rows that share a path are said in the first. */
        size_t first = key_list_find(&load->keys, key->path);
        struct place said = a->said[element * load->keys.count + first];
        snprintf(label, sizeof label, "%s.%zu.", scene_arrays[array].name, element);
        snprintf(path, sizeof path, "%s%s", label, key->path + strlen(prefix));
        if (!key_list_active(&load->keys, i, memory)) {
            status = pass_element_key(load, i, said, label, memory);
            continue;
        }
        /* The row of the shape stands before those that depend on it. */
        if (!key_fits_element(key, &scene_arrays[array], memory)) {
            if (said.doc)
                status = wrong_shape(load, said, key, path,
                                     (const void *)((char *)memory + scene_arrays[array].shape));
            continue;
        }
        status = fill_value(load, key, path, said, a->elements[element],
                            (char *)memory + key->offset);
    }
    return status;
}

static enum status fill_array(struct load *load, int array)
{
    const struct key_array *row = &scene_arrays[array];
    size_t count = load->arrays[array].count;
    char *items = calloc(count + 1, row->size);
    if (!items)
        return error_set(load->e, STATUS_RUN, "memory is short");
    memcpy((char *)load->scene + row->items, &items, sizeof items);
    memcpy((char *)load->scene + row->count, &count, sizeof count);
    enum status status = STATUS_OK;
    for (size_t i = 0; i < count && !status; i++)
        status = fill_element(load, array, i, items + i * row->size);
    return status;
}

static enum status fill_options(struct load *load)
{
    struct scene *scene = load->scene;
    scene->options = calloc(load->keys.count, sizeof *scene->options);
    if (!scene->options)
        return error_set(load->e, STATUS_RUN, "memory is short");
    for (size_t i = scene_core_key_count; i < load->keys.count; i++) {
        const struct key *key = load->keys.items[i].key;
        /* Variants may share a path: the first row stands for all. */
        if (strstr(key->path, "[]") || key_list_find(&load->keys, key->path) != i)
            continue;
        size_t active = key_list_find_active(&load->keys, key->path, scene);
        if (active == load->keys.count) {
            if (load->said[i].doc)
                return refuse_option(load, i, load->said[i], "", scene);
            continue;
        }
        key = load->keys.items[active].key;
        struct scene_option *option = &scene->options[scene->option_count++];
        snprintf(option->path, sizeof option->path, "%s", key->path);
        option->type = key->type;
        option->place = load_position(load, load->said[i]);
        enum status status = fill_value(load, key, key->path, load->said[i],
                                        holder(load, key->path), &option->value);
        if (status)
            return status;
    }
    return STATUS_OK;
}

static enum status load_create(struct load *load, const struct scene_overrides *set,
                               const struct vocabulary *vocabulary)
{
    enum status status = key_list_create(&load->keys, vocabulary, load->e);
    if (status)
        return status;
    load->set_count = set ? set->count : 0;
    load->sets = calloc(load->set_count + 1, sizeof *load->sets);
    load->said = calloc(load->keys.count, sizeof *load->said);
    load->scene = calloc(1, sizeof *load->scene);
    if (!load->sets || !load->said || !load->scene)
        return error_set(load->e, STATUS_RUN, "memory is short");
    return STATUS_OK;
}

static void load_free(struct load *load)
{
    for (size_t i = 0; load->sets && i < load->set_count; i++)
        json_free(&load->sets[i]);
    for (int a = 0; a < ARRAY_COUNT; a++) {
        free(load->arrays[a].elements);
        free(load->arrays[a].said);
    }
    free(load->sets);
    free(load->said);
    json_free(&load->file);
    key_list_free(&load->keys);
}

static enum status load_fill(struct load *load)
{
    enum status status = fill_globals(load);
    for (int a = 0; a < ARRAY_COUNT && !status; a++)
        status = fill_array(load, a);
    if (!status)
        status = fill_options(load);
    if (!status)
        status = check_scene(load);
    return status;
}

enum status scene_load(struct scene **scene, const char *path, const struct scene_overrides *set,
                       const struct vocabulary *vocabulary, struct error *e)
{
    struct load load = {.e = e};
    *scene = NULL;
    enum status status = load_create(&load, set, vocabulary);
    if (!status)
        status = json_read_file(&load.file, path, e);
    if (!status)
        status = say_file(&load);
    if (!status)
        status = say_overrides(&load, set);
    if (!status) {
        snprintf(load.scene->source, sizeof load.scene->source, "%s", path);
        status = load_fill(&load);
    }
    if (status)
        scene_free(load.scene);
    else
        *scene = load.scene;
    load_free(&load);
    return status;
}

void scene_free(struct scene *scene)
{
    if (!scene)
        return;
    free(scene->fluids);
    free(scene->bodies);
    free(scene->obstacles);
    free(scene->measures);
    free(scene->labels);
    free(scene->keyframes);
    free(scene->options);
    free(scene);
}
