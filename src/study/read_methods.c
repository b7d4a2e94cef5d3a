/* Reads the methods of a study. */
#include "study/reading.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* One more method, a copy of that with more settings. */
static enum status add_method(struct reading *r, const struct study_method *from)
{
    struct study *study = r->study;
    struct study_method *grown =
        realloc(study->methods, (study->method_count + 1) * sizeof *grown);
    if (!grown)
        return reading_memory(r);
    study->methods = grown;
    struct study_method *method = &grown[study->method_count++];
    *method = (struct study_method){0};
    snprintf(method->name, sizeof method->name, "%s", from->name);
    return set_append(&method->set, &from->set, r->e);
}

/* "solver.support" -> "support" */
static const char *last_word(const char *path)
{
    const char *dot = strrchr(path, '.');
    return dot ? dot + 1 : path;
}

/* The method of that place among all combinations of the lists' values; the last list runs first. */
static enum status vary_method(struct reading *r, const struct study_method *from,
                               const struct set_lists *lists, size_t place)
{
    int list;
    if (add_method(r, from))
        return r->e->status;
    struct study_method *method = &r->study->methods[r->study->method_count - 1];
    for (size_t k = (size_t)r->doc.nodes[lists->object].size; k-- > 0;) {
        char key[KEY_TEXT_SIZE], text[48];
        int node = set_list_at(lists, k, &list);
        size_t count = (size_t)r->doc.nodes[list].size;
        int value = set_value_at(&r->doc, list, place % count);
        place /= count;
        json_string(&r->doc, node, key, sizeof key);
        set_value_text(&r->doc, value, text, sizeof text);
        size_t length = strlen(method->name);
        bool word = r->doc.nodes[value].kind == JSON_STRING; /* that says what it is by itself */
        snprintf(method->name + length, sizeof method->name - length, "%s%s%s%s",
                 length ? ", " : "", word ? "" : last_word(key), word ? "" : " ", text);
        if (set_add(&method->set, &r->doc, node, value, r->e))
            return r->e->status;
    }
    return STATUS_OK;
}

static enum status read_method(struct reading *r, int node, struct study_method *from)
{
    struct set_lists lists;
    int list;
    size_t combinations = 1;
    if (r->doc.nodes[node].kind != JSON_OBJECT)
        return reading_fail(r, node, "give an object such as {\"name\": \"isph\", \"set\": {\"solver.method\": "
                             "\"isph\"}}");
    if (read_only(&r->doc, node, "name|set|vary", r->e) ||
        read_text(&r->doc, node, "name", false, from->name, sizeof from->name, r->e) ||
        reading_set(r, node, "set", &from->set) || reading_lists(r, node, "vary", false, &lists))
        return r->e->status;
    if (lists.object < 0)
        return from->name[0] ? add_method(r, from)
                             : reading_fail(r, node, "\"name\" is missing; give one, or \"vary\"");
    for (size_t k = 0; set_list_at(&lists, k, &list) >= 0; k++)
        combinations *= (size_t)r->doc.nodes[list].size;
    if (combinations > 256)
        return reading_fail(r, node, "\"vary\" makes more than 256 methods; give fewer values");
    for (size_t k = 0; k < combinations; k++)
        if (vary_method(r, from, &lists, k))
            return r->e->status;
    return STATUS_OK;
}

enum status read_methods(struct reading *r)
{
    static const struct study_method plain = {.name = "as the scene says"};
    int list;
    if (read_member(&r->doc, 0, "methods", JSON_ARRAY, false, &list, r->e))
        return r->e->status;
    if (list < 0)
        return add_method(r, &plain);
    for (size_t k = 0; k < (size_t)r->doc.nodes[list].size; k++) {
        struct study_method from = {0};
        enum status status = read_method(r, set_value_at(&r->doc, list, k), &from);
        set_free(&from.set);
        if (status)
            return status;
    }
    for (size_t i = 0; i < r->study->method_count; i++)
        for (size_t j = 0; j < i; j++)
            if (strcmp(r->study->methods[i].name, r->study->methods[j].name) == 0)
                return reading_fail(r, list, "two methods have the same name");
    return r->study->method_count ? STATUS_OK : reading_fail(r, list, "give at least one method");
}
