/* A scene on its way from text to struct: which key is said where, so that checks can point. */
#ifndef SCENE_LOAD_H
#define SCENE_LOAD_H

#include "scene/json.h"
#include "scene/keys.h"

struct place {
    const struct json *doc; /* NULL: not said, the default holds */
    int node;               /* the value */
};

struct said_array {
    struct place place;     /* the array itself */
    size_t count;           /* elements */
    struct place *elements; /* count */
    struct place *said;     /* count * keys.count: by element, then by row */
};

struct load {
    struct key_list keys;
    struct json file;
    struct json *sets;      /* one per override */
    size_t set_count;
    struct place *said;     /* by row, outside arrays */
    struct said_array arrays[ARRAY_COUNT];
    struct scene *scene;
    struct error *e;
};

/* Notes where each key of the object is said. Unknown and duplicate keys are STATUS_USAGE. */
enum status say_file(struct load *load);

/* Notes the overrides, said after the file; what they leave no sense to in the file is forgotten. */
enum status say_overrides(struct load *load, const struct scene_overrides *set);

/* Records "PLACE: message"; the beginning of the file when the place is not said. STATUS_USAGE. */
enum status load_fail(struct load *load, struct place place, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Where a key is said: outside arrays, or in element i of an array. A key that is not said is the
 * object that should hold it. */
struct place load_place(const struct load *load, const char *path);
struct place load_element_place(const struct load *load, int array, size_t i, const char *path);

/* Line and column of a place, if it is in the scene file. */
struct scene_place load_position(const struct load *load, struct place place);

/* Semantic checks over a scene that is filled in. STATUS_USAGE. */
enum status check_scene(struct load *load);
enum status check_bodies(struct load *load);
enum status check_obstacles(struct load *load);
enum status check_measures(struct load *load);
enum status check_camera(struct load *load);

/* The same of the shape that element i of an array has. */
enum status check_shape(struct load *load, int array, size_t i, const struct shape *shape);

#endif
