/* Writes the scene in force: every key with its value, as a file that loads to the same scene. */
#include "base/fnv.h"
#include "base/output.h"
#include "scene/value.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

struct writer {
    const struct scene *scene;
    struct key_list keys;
    FILE *out;
    int depth; /* of indentation, in steps of two spaces */
    bool first;
};

static void write_object(struct writer *w, const char *prefix, const void *base);

static void next_line(struct writer *w)
{
    fprintf(w->out, "%s\n%*s", w->first ? "" : ",", 2 * w->depth, "");
    w->first = false;
}

static const void *option_memory(const struct scene *scene, const char *path)
{
    for (size_t i = 0; i < scene->option_count; i++)
        if (strcmp(scene->options[i].path, path) == 0)
            return &scene->options[i].value;
    return NULL;
}

/* Where the row's value is; NULL when it has none in this scene or element. */
static const void *row_memory(const struct writer *w, size_t row, const void *base)
{
    const struct key *key = w->keys.items[row].key;
    if (!key_list_active(&w->keys, row, base))
        return NULL;
    if (key->offset == KEY_OPTION)
        return option_memory(w->scene, key->path);
    for (int a = 0; a < ARRAY_COUNT; a++)
        if (strncmp(key->path, scene_arrays[a].prefix, strlen(scene_arrays[a].prefix)) == 0 &&
            !key_fits_element(key, &scene_arrays[a], base))
            return NULL;
    return (const char *)base + key->offset;
}

/* Of rows that share a path, the one in force. */
static const void *path_memory(const struct writer *w, size_t row, const void *base,
                               const struct key **key)
{
    for (size_t i = row; i < w->keys.count; i++) {
        *key = w->keys.items[i].key;
        const void *memory = strcmp((*key)->path, w->keys.items[row].key->path) == 0
                                 ? row_memory(w, i, base) : NULL;
        if (memory)
            return memory;
    }
    return NULL;
}

static void write_array(struct writer *w, const char *prefix, const char *name)
{
    for (int a = 0; a < ARRAY_COUNT; a++) {
        const struct key_array *array = &scene_arrays[a];
        const char *items;
        size_t count;
        if (strcmp(array->prefix, prefix) != 0)
            continue;
        memcpy(&items, (const char *)w->scene + array->items, sizeof items);
        memcpy(&count, (const char *)w->scene + array->count, sizeof count);
        fprintf(w->out, "\"%s\": [", name);
        w->depth++;
        w->first = true;
        for (size_t i = 0; i < count; i++) {
            next_line(w);
            write_object(w, array->prefix, items + i * array->size);
        }
        w->depth--;
        fputc(']', w->out);
        w->first = false;
    }
}

/* Whether anything below the prefix has a value: variants' keys may all be absent. */
static bool has_value(const struct writer *w, const char *prefix, const void *base)
{
    for (size_t i = 0; i < w->keys.count; i++)
        if (strncmp(w->keys.items[i].key->path, prefix, strlen(prefix)) == 0 &&
            row_memory(w, i, base))
            return true;
    return false;
}

static void write_child(struct writer *w, size_t row, enum key_place place, const char *prefix,
                        const char *name, const void *base)
{
    char below[2 * KEY_TEXT_SIZE];
    const struct key *key;
    const void *memory;
    snprintf(below, sizeof below, "%s%s.", prefix, name);
    if (place == PLACE_ARRAY) {
        snprintf(below, sizeof below, "%s%s[].", prefix, name);
        next_line(w);
        write_array(w, below, name);
    } else if (place == PLACE_LEAF) {
        memory = path_memory(w, row, base, &key);
        if (!memory)
            return;
        next_line(w);
        fprintf(w->out, "\"%s\": ", name);
        value_write(key, memory, w->out);
    } else if (has_value(w, below, base)) {
        next_line(w);
        fprintf(w->out, "\"%s\": ", name);
        write_object(w, below, base);
    }
}

static void write_object(struct writer *w, const char *prefix, const void *base)
{
    char name[KEY_TEXT_SIZE];
    fputc('{', w->out);
    w->depth++;
    w->first = true;
    for (size_t i = 0; i < w->keys.count; i++) {
        enum key_place place = key_child(&w->keys, i, prefix, name);
        if (place != PLACE_NONE)
            write_child(w, i, place, prefix, name, base);
    }
    w->depth--;
    fprintf(w->out, "\n%*s}", 2 * w->depth, "");
    w->first = false;
}

void scene_write(const struct scene *scene, const struct vocabulary *vocabulary, FILE *out)
{
    struct writer w = {.scene = scene, .out = out};
    struct error ignored;
    if (key_list_create(&w.keys, vocabulary, &ignored))
        return;
    write_object(&w, "", scene);
    fputc('\n', out);
    key_list_free(&w.keys);
}

uint64_t scene_hash(const struct scene *scene, const struct vocabulary *vocabulary)
{
    char *text = NULL;
    size_t size = 0;
    FILE *out = open_memstream(&text, &size);
    if (!out)
        return 0;
    scene_write(scene, vocabulary, out);
    fclose(out);
    uint64_t hash = fnv_bytes(FNV_START, text, size);
    free(text);
    return hash;
}

enum status scene_save(const struct scene *scene, const struct vocabulary *vocabulary,
                       const char *path, struct error *e)
{
    struct output_file file;
    if (strcmp(path, "-") == 0) {
        scene_write(scene, vocabulary, stdout);
        return fflush(stdout) ? error_set(e, STATUS_OUTPUT, "standard output cannot be written: %s", strerror(errno))
                              : STATUS_OK;
    }
    if (output_open(&file, path, e))
        return e->status;
    scene_write(scene, vocabulary, file.stream);
    return output_close(&file, true, e);
}
