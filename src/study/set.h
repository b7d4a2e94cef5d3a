/* Settings of scene keys as a study file has them: objects of keys and values, single or in lists. */
#ifndef STUDY_SET_H
#define STUDY_SET_H

#include "scene/json.h"
#include "study/study.h"

/* Appends "KEY=VALUE" with the text of the value's node. */
enum status set_add(struct study_set *set, const struct json *doc, int key, int value,
                    struct error *e);

/* Appends "KEY=VALUE" with that label. */
enum status set_say(struct study_set *set, const char *key, const char *value, const char *label,
                    struct error *e);

/* Appends every member of the object. */
enum status set_add_object(struct study_set *set, const struct json *doc, int object,
                           struct error *e);
enum status set_append(struct study_set *set, const struct study_set *more, struct error *e);
void set_free(struct study_set *set);

/* A value's text, shortened, for names: a string without its quotes. */
void set_value_text(const struct json *doc, int node, char *out, size_t size);

/* Values of keys that go together: members of an object whose values are lists. */
struct set_lists {
    const struct json *doc;
    int object;
};

/* The key node of the list of that place, or -1; *list gets its array. */
int set_list_at(const struct set_lists *lists, size_t place, int *list);

/* The node of the value at a place of an array, which has one. */
int set_value_at(const struct json *doc, int array, size_t place);

#endif
