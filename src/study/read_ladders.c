/* Reads the ladders of a study, or the two of a stability map. */
#include "study/reading.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static enum status fill_rungs(struct reading *r, const struct set_lists *lists,
                              struct study_ladder *ladder)
{
    int list, key;
    for (size_t k = 0; (key = set_list_at(lists, k, &list)) >= 0; k++) {
        if ((size_t)r->doc.nodes[list].size != ladder->count)
            return reading_fail(r, list, "lists of a ladder are of equal length: a value for each rung");
        for (size_t rung = 0; rung < ladder->count; rung++) {
            int value = set_value_at(&r->doc, list, rung);
            if (k == 0)
                set_value_text(&r->doc, value, ladder->labels[rung], sizeof *ladder->labels);
            if (set_add(&ladder->rungs[rung], &r->doc, key, value, r->e))
                return r->e->status;
        }
    }
    return STATUS_OK;
}

static enum status read_figure(struct reading *r, int object, enum ladder_figure *figure)
{
    char word[KEY_TEXT_SIZE];
    int node;
    if (read_member(&r->doc, object, "figure", JSON_STRING, false, &node, r->e) || node < 0)
        return r->e->status;
    json_string(&r->doc, node, word, sizeof word);
    *figure = strcmp(word, "time") == 0 ? LADDER_TIME : LADDER_WORK;
    return *figure == LADDER_TIME || strcmp(word, "work-precision") == 0
               ? STATUS_OK : reading_fail(r, node, "give \"work-precision\" or \"time\"");
}

/* {"name": "theirs", "seconds": [1, 2.5, null]} */
static enum status read_other(struct reading *r, int node, const struct study_ladder *ladder,
                              struct study_other *other)
{
    int list;
    if (r->doc.nodes[node].kind != JSON_OBJECT)
        return reading_fail(r, node, "give an object such as {\"name\": \"theirs\", \"seconds\": [1, 2.5, null]}");
    if (read_only(&r->doc, node, "name|seconds", r->e) ||
        read_text(&r->doc, node, "name", true, other->name, sizeof other->name, r->e) ||
        read_member(&r->doc, node, "seconds", JSON_ARRAY, true, &list, r->e))
        return r->e->status;
    if ((size_t)r->doc.nodes[list].size != ladder->count)
        return reading_fail(r, list, "give a time in s for each rung, or null");
    other->seconds = calloc(ladder->count, sizeof *other->seconds);
    for (size_t k = 0; k < ladder->count && other->seconds; k++) {
        const struct json_node *value = &r->doc.nodes[set_value_at(&r->doc, list, k)];
        if (value->kind != JSON_NUMBER && value->kind != JSON_NULL)
            return reading_fail(r, list, "give a time in s for each rung, or null");
        other->seconds[k] = value->kind == JSON_NUMBER ? strtod(r->doc.text + value->start, NULL) : (double)NAN;
    }
    return other->seconds ? STATUS_OK : reading_memory(r);
}

static enum status read_others(struct reading *r, int node, struct study_ladder *ladder)
{
    int list;
    if (read_member(&r->doc, node, "others", JSON_ARRAY, false, &list, r->e) || list < 0)
        return r->e->status;
    size_t count = (size_t)r->doc.nodes[list].size;
    ladder->others = calloc(count + 1, sizeof *ladder->others);
    if (!ladder->others)
        return reading_memory(r);
    for (size_t k = 0; k < count; k++)
        if (read_other(r, set_value_at(&r->doc, list, k), ladder, &ladder->others[ladder->other_count++]))
            return r->e->status;
    return STATUS_OK;
}

static enum status read_ladder(struct reading *r, int node, struct study_ladder *ladder)
{
    struct set_lists lists;
    int list;
    if (r->doc.nodes[node].kind != JSON_OBJECT)
        return reading_fail(r, node, "give an object such as {\"name\": \"resolution\", \"set\": "
                             "{\"particles.spacing\": [0.02, 0.01]}}");
    ladder->steps = (double)NAN;
    if (read_only(&r->doc, node, "name|set|figure|steps|others", r->e) ||
        read_number(&r->doc, node, "steps", 1, 1e9, &ladder->steps, r->e) ||
        read_figure(r, node, &ladder->figure) ||
        read_text(&r->doc, node, "name", true, ladder->name, sizeof ladder->name, r->e) ||
        reading_lists(r, node, "set", true, &lists))
        return r->e->status;
    int key = set_list_at(&lists, 0, &list);
    json_string(&r->doc, key, ladder->key, sizeof ladder->key);
    size_t count = (size_t)r->doc.nodes[list].size;
    ladder->rungs = calloc(count, sizeof *ladder->rungs);
    ladder->labels = calloc(count, sizeof *ladder->labels);
    if (!ladder->rungs || !ladder->labels)
        return reading_memory(r);
    ladder->count = count;
    if (fill_rungs(r, &lists, ladder))
        return r->e->status;
    return read_others(r, node, ladder);
}

/* The cell's settings are those of its column and row. */
static enum status fill_cells(struct reading *r, const struct study_ladder *x,
                              const struct study_ladder *y, struct study_ladder *cells)
{
    strcpy(cells->name, "map");
    snprintf(cells->key, sizeof cells->key, "%.60s, %.60s", x->key, y->key);
    size_t count = x->count * y->count;
    cells->rungs = calloc(count, sizeof *cells->rungs);
    cells->labels = calloc(count, sizeof *cells->labels);
    if (!cells->rungs || !cells->labels)
        return reading_memory(r);
    cells->count = count;
    for (size_t k = 0; k < count; k++) {
        size_t column = k % x->count, row = k / x->count;
        snprintf(cells->labels[k], sizeof *cells->labels, "%.14s, %.14s", x->labels[column],
                 y->labels[row]);
        if (set_append(&cells->rungs[k], &x->rungs[column], r->e) ||
            set_append(&cells->rungs[k], &y->rungs[row], r->e))
            return r->e->status;
    }
    return STATUS_OK;
}

static enum status read_map(struct reading *r, int map)
{
    static const char *const names[] = {"x", "y"};
    struct study *study = r->study;
    int node;
    bool bounded = study->known;
    if (read_only(&r->doc, map, "x|y", r->e))
        return r->e->status;
    for (int k = 0; k < 2; k++)
        if (read_member(&r->doc, map, names[k], JSON_OBJECT, true, &node, r->e) ||
            read_ladder(r, node, &study->map[k]))
            return r->e->status;
    for (size_t k = 0; k < study->asked_count; k++)
        bounded = bounded || !isnan(study->asked[k].asked);
    if (!bounded)
        return reading_fail(r, 0, "no error has a bound \"asked\", so that nothing in the map could be wrong");
    study->is_map = true;
    return fill_cells(r, &study->map[0], &study->map[1], &study->ladders[study->ladder_count++]);
}

/* Without ladders every method has one point. */
enum status read_ladders(struct reading *r)
{
    struct study *study = r->study;
    int list, map;
    if (read_member(&r->doc, 0, "ladders", JSON_ARRAY, false, &list, r->e) ||
        read_member(&r->doc, 0, "map", JSON_OBJECT, false, &map, r->e))
        return r->e->status;
    if (map >= 0 && list >= 0)
        return reading_fail(r, map, "give \"ladders\" or \"map\", not both");
    size_t count = list < 0 ? 1 : (size_t)r->doc.nodes[list].size;
    study->ladders = calloc(count + 1, sizeof *study->ladders);
    if (!study->ladders)
        return reading_memory(r);
    if (map >= 0)
        return read_map(r, map);
    if (list < 0) {
        struct study_ladder *one = &study->ladders[study->ladder_count++];
        strcpy(one->name, "methods");
        one->steps = (double)NAN;
        one->rungs = calloc(1, sizeof *one->rungs);
        one->labels = calloc(1, sizeof *one->labels);
        one->count = one->rungs && one->labels;
        return one->count ? STATUS_OK : reading_memory(r);
    }
    for (size_t k = 0; k < count; k++)
        if (read_ladder(r, set_value_at(&r->doc, list, k), &study->ladders[study->ladder_count++]))
            return r->e->status;
    for (size_t i = 0; i < count; i++)
        for (size_t j = 0; j < i; j++)
            if (strcmp(study->ladders[i].name, study->ladders[j].name) == 0)
                return reading_fail(r, set_value_at(&r->doc, list, i), "two ladders have the same name");
    return count ? STATUS_OK : reading_fail(r, list, "give at least one ladder, or leave the key out");
}
