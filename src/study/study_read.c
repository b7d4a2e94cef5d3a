/* Reads a study file. */
#include "study/reading.h"

#include <libgen.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum status reading_memory(struct reading *r)
{
    return error_set(r->e, STATUS_RUN, "%s: memory is short", r->doc.name);
}

enum status reading_fail(struct reading *r, int node, const char *text)
{
    const struct json_node *n = &r->doc.nodes[node];
    return json_fail(&r->doc, n->start - (n->kind == JSON_STRING), r->e, "%s", text);
}

/* A path in the file is from the file's directory. */
enum status reading_path(struct reading *r, int object, const char *key, bool needed, char **out)
{
    char name[PATH_MAX] = "", copy[PATH_MAX];
    if (read_text(&r->doc, object, key, needed, name, sizeof name, r->e) || !name[0])
        return r->e->status;
    snprintf(copy, sizeof copy, "%s", r->study->path);
    const char *directory = dirname(copy);
    bool here = name[0] == '/' || strcmp(directory, ".") == 0;
    if (asprintf(out, "%s%s%s", here ? "" : directory, here ? "" : "/", name) < 0) {
        *out = NULL;
        return reading_memory(r);
    }
    return STATUS_OK;
}

enum status reading_set(struct reading *r, int object, const char *key, struct study_set *set)
{
    int node;
    if (read_member(&r->doc, object, key, JSON_OBJECT, false, &node, r->e) || node < 0)
        return r->e->status;
    return set_add_object(set, &r->doc, node, r->e);
}

/* The object of lists of the member: at least one, each of at least one value. */
enum status reading_lists(struct reading *r, int object, const char *key, bool needed,
                              struct set_lists *lists)
{
    int list;
    *lists = (struct set_lists){&r->doc, -1};
    if (read_member(&r->doc, object, key, JSON_OBJECT, needed, &lists->object, r->e) ||
        lists->object < 0)
        return r->e->status;
    if (!r->doc.nodes[lists->object].size)
        return reading_fail(r, lists->object, "this is empty; give keys and lists of values");
    for (size_t k = 0; set_list_at(lists, k, &list) >= 0; k++)
        if (r->doc.nodes[list].kind != JSON_ARRAY || !r->doc.nodes[list].size)
            return reading_fail(r, list, "give a list of values, such as [0.02, 0.01]");
    return STATUS_OK;
}

static enum status read_study(struct reading *r)
{
    struct study *study = r->study;
    const struct json *doc = &r->doc;
    const struct variant *known = NULL;
    double repeats = json_member(doc, 0, "map") < 0 ? 3 : 1, seeds = 1;
    if (read_only(doc, 0, "title|scene|case|measure|interval|errors|plot|floor|set|reference|methods|"
                          "ladders|map|repeats|seeds|limit", r->e) ||
        read_text(doc, 0, "title", true, study->title, sizeof study->title, r->e) ||
        reading_path(r, 0, "scene", true, &study->scene) ||
        read_variant(doc, 0, "case", &case_table, &known, r->e) ||
        read_number(doc, 0, "interval", 1e-9, 1e9, &study->interval, r->e) ||
        read_number(doc, 0, "floor", 0, 1, &study->floor, r->e) ||
        read_number(doc, 0, "repeats", 1, STUDY_REPEATS_MAX, &repeats, r->e) ||
        read_number(doc, 0, "seeds", 1, STUDY_SEEDS_MAX, &seeds, r->e) ||
        read_number(doc, 0, "limit", 1e-3, INFINITY, &study->limit, r->e))
        return r->e->status;
    study->known = (const struct case_row *)known;
    study->repeats = (int)repeats;
    study->seeds = (int)seeds;
    if (study->seeds > 1 && json_member(doc, 0, "map") >= 0)
        return reading_fail(r, json_member(doc, 0, "seeds"), "a stability map has no \"seeds\"; leave it out");
    if (reading_set(r, 0, "set", &study->set) ||
        reading_set(r, 0, "reference", &study->reference) || read_errors(r) || read_methods(r))
        return r->e->status;
    return read_ladders(r);
}

enum status study_read(struct study *study, const char *path, struct error *e)
{
    struct reading r = {.study = study, .e = e};
    *study = (struct study){.path = strdup(path), .interval = (double)NAN, .floor = (double)NAN,
                            .limit = INFINITY};
    e->status = STATUS_OK;
    if (!study->path)
        return error_set(e, STATUS_RUN, "%s: memory is short", path);
    enum status status = json_read_file(&r.doc, path, e);
    if (!status)
        status = r.doc.nodes[0].kind == JSON_OBJECT ? read_study(&r)
                                                    : reading_fail(&r, 0, "a study is an object");
    json_free(&r.doc);
    return status;
}

static void ladder_free(struct study_ladder *ladder)
{
    for (size_t rung = 0; rung < ladder->count; rung++)
        set_free(&ladder->rungs[rung]);
    for (size_t k = 0; k < ladder->other_count; k++)
        free(ladder->others[k].seconds);
    free(ladder->others);
    free(ladder->rungs);
    free(ladder->labels);
}

void study_free(struct study *study)
{
    for (size_t k = 0; k < study->method_count; k++)
        set_free(&study->methods[k].set);
    for (size_t k = 0; k < study->ladder_count; k++)
        ladder_free(&study->ladders[k]);
    for (int k = 0; k < 2; k++)
        ladder_free(&study->map[k]);
    for (size_t k = 0; k < study->asked_count; k++) {
        free(study->asked[k].formula);
        free(study->asked[k].path);
    }
    set_free(&study->set);
    set_free(&study->reference);
    free(study->methods);
    free(study->ladders);
    free(study->asked);
    free(study->plots);
    free(study->measure);
    free(study->scene);
    free(study->path);
    *study = (struct study){0};
}
