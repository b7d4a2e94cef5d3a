/* All scene keys in one list: the core rows, then those of every variant in the vocabulary. */
#ifndef SCENE_KEYS_H
#define SCENE_KEYS_H

#include "scene/key.h"
#include "scene/scene.h"

/* An offset for a key that stands for all keys below it ("domain.walls": one word, six faces). */
#define KEY_GROUP ((size_t)-2)

extern const struct key scene_core_keys[];
extern const size_t scene_core_key_count;

/* Arrays of objects: where the elements live in struct scene. */
struct key_array {
    const char *name;   /* "fluids", "camera.keyframes" */
    const char *prefix; /* of its keys: "fluids[]." */
    size_t items, count; /* offsets of the pointer and of the size_t */
    size_t size;        /* bytes of one element */
    size_t shape;       /* offset in it of its struct shape, or KEY_SHAPELESS */
};
#define KEY_SHAPELESS ((size_t)-1)
enum { ARRAY_FLUIDS, ARRAY_BODIES, ARRAY_OBSTACLES, ARRAY_MEASURE, ARRAY_LABELS, ARRAY_KEYFRAMES, ARRAY_COUNT };
extern const struct key_array scene_arrays[ARRAY_COUNT];

/* Whether an element of this shape reads the key; keys that no shape owns are read by all. */
bool key_fits_shape(const struct key *key, enum shape_kind shape);
/* Whether only some shapes read the key. */
bool key_is_shaped(const struct key *key);
/* The same of an element's memory; all read what no shape owns. */
bool key_fits_element(const struct key *key, const struct key_array *array, const void *element);

struct key_entry {
    const struct key *key;
    const struct variant_table *table; /* NULL for core keys */
    const struct variant *owner;
};

struct key_list {
    struct key_entry *items;
    size_t count;
    const struct vocabulary *vocabulary;
};

/* STATUS_RUN when memory is short. vocabulary may be NULL. */
enum status key_list_create(struct key_list *list, const struct vocabulary *vocabulary,
                            struct error *e);
void key_list_free(struct key_list *list);

/* First row of that path, or list->count. */
size_t key_list_find(const struct key_list *list, const char *path);

/* Whether the row takes part: core, or owned by a variant that is chosen; `base` is the scene, or
 * for keys of an array the element. */
bool key_list_active(const struct key_list *list, size_t row, const void *base);

/* The first active row of that path, or list->count. */
size_t key_list_find_active(const struct key_list *list, const char *path, const void *base);

/* The core row by which a scene, or an element, chooses from the table, or NULL. */
const struct key *key_chooser(const struct variant_table *table);

enum key_place {
    PLACE_NONE,
    PLACE_LEAF,   /* a value */
    PLACE_GROUP,  /* a value for all below it, or an object */
    PLACE_OBJECT,
    PLACE_ARRAY   /* of objects */
};

/* What lies directly below `prefix` ("", "time.", "bodies[].") on the way to row `row`: its name,
 * and PLACE_NONE when the row is not below, or an earlier row already led there. */
enum key_place key_child(const struct key_list *list, size_t row, const char *prefix,
                         char name[KEY_TEXT_SIZE]);

/* The same by name: the row that leads there first, or list->count. */
size_t key_child_find(const struct key_list *list, const char *prefix, const char *name,
                      enum key_place *place);

const struct variant_table *vocabulary_table(const struct vocabulary *vocabulary, const char *name);

/* Place of the word in "a|b|c", or -1; and the word at a place, "" beyond the last. */
int key_word_index(const char *choices, const char *word);
void key_word_at(const char *choices, int index, char word[KEY_TEXT_SIZE]);

#endif
