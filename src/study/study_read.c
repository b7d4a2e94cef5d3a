/* Reads a study file. */
#include "study/read_value.h"
#include "study/reference/formula.h"
#include "study/set.h"

#include <libgen.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What is being read. */
struct reading {
    struct study *study;
    struct json doc;
    struct error *e;
};

static enum status memory_short(struct reading *r)
{
    return error_set(r->e, STATUS_RUN, "%s: memory is short", r->doc.name);
}

static enum status fail(struct reading *r, int node, const char *text)
{
    const struct json_node *n = &r->doc.nodes[node];
    return json_fail(&r->doc, n->start - (n->kind == JSON_STRING), r->e, "%s", text);
}

/* A path in the file is from the file's directory. */
static enum status read_path(struct reading *r, int object, const char *key, bool needed, char **out)
{
    char name[PATH_MAX] = "", copy[PATH_MAX];
    if (read_text(&r->doc, object, key, needed, name, sizeof name, r->e) || !name[0])
        return r->e->status;
    snprintf(copy, sizeof copy, "%s", r->study->path);
    const char *directory = dirname(copy);
    bool here = name[0] == '/' || strcmp(directory, ".") == 0;
    if (asprintf(out, "%s%s%s", here ? "" : directory, here ? "" : "/", name) < 0) {
        *out = NULL;
        return memory_short(r);
    }
    return STATUS_OK;
}

static enum status read_set(struct reading *r, int object, const char *key, struct study_set *set)
{
    int node;
    if (read_member(&r->doc, object, key, JSON_OBJECT, false, &node, r->e) || node < 0)
        return r->e->status;
    return set_add_object(set, &r->doc, node, r->e);
}

/* The object of lists of the member: at least one, each of at least one value. */
static enum status read_lists(struct reading *r, int object, const char *key, bool needed,
                              struct set_lists *lists)
{
    int list;
    *lists = (struct set_lists){&r->doc, -1};
    if (read_member(&r->doc, object, key, JSON_OBJECT, needed, &lists->object, r->e) ||
        lists->object < 0)
        return r->e->status;
    if (!r->doc.nodes[lists->object].size)
        return fail(r, lists->object, "this is empty; give keys and lists of values");
    for (size_t k = 0; set_list_at(lists, k, &list) >= 0; k++)
        if (r->doc.nodes[list].kind != JSON_ARRAY || !r->doc.nodes[list].size)
            return fail(r, list, "give a list of values, such as [0.02, 0.01]");
    return STATUS_OK;
}

/* One more method, a copy of that with more settings. */
static enum status add_method(struct reading *r, const struct study_method *from)
{
    struct study *study = r->study;
    struct study_method *grown =
        realloc(study->methods, (study->method_count + 1) * sizeof *grown);
    if (!grown)
        return memory_short(r);
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
        return fail(r, node, "give an object such as {\"name\": \"isph\", \"set\": {\"solver.method\": "
                             "\"isph\"}}");
    if (read_only(&r->doc, node, "name|set|vary", r->e) ||
        read_text(&r->doc, node, "name", false, from->name, sizeof from->name, r->e) ||
        read_set(r, node, "set", &from->set) || read_lists(r, node, "vary", false, &lists))
        return r->e->status;
    if (lists.object < 0)
        return from->name[0] ? add_method(r, from)
                             : fail(r, node, "\"name\" is missing; give one, or \"vary\"");
    for (size_t k = 0; set_list_at(&lists, k, &list) >= 0; k++)
        combinations *= (size_t)r->doc.nodes[list].size;
    if (combinations > 256)
        return fail(r, node, "\"vary\" makes more than 256 methods; give fewer values");
    for (size_t k = 0; k < combinations; k++)
        if (vary_method(r, from, &lists, k))
            return r->e->status;
    return STATUS_OK;
}

static enum status read_methods(struct reading *r)
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
                return fail(r, list, "two methods have the same name");
    return r->study->method_count ? STATUS_OK : fail(r, list, "give at least one method");
}

static enum status fill_rungs(struct reading *r, const struct set_lists *lists,
                              struct study_ladder *ladder)
{
    int list, key;
    for (size_t k = 0; (key = set_list_at(lists, k, &list)) >= 0; k++) {
        if ((size_t)r->doc.nodes[list].size != ladder->count)
            return fail(r, list, "lists of a ladder are of equal length: a value for each rung");
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
               ? STATUS_OK : fail(r, node, "give \"work-precision\" or \"time\"");
}

static enum status read_ladder(struct reading *r, int node, struct study_ladder *ladder)
{
    struct set_lists lists;
    int list;
    if (r->doc.nodes[node].kind != JSON_OBJECT)
        return fail(r, node, "give an object such as {\"name\": \"resolution\", \"set\": "
                             "{\"particles.spacing\": [0.02, 0.01]}}");
    if (read_only(&r->doc, node, "name|set|figure", r->e) ||
        read_figure(r, node, &ladder->figure) ||
        read_text(&r->doc, node, "name", true, ladder->name, sizeof ladder->name, r->e) ||
        read_lists(r, node, "set", true, &lists))
        return r->e->status;
    int key = set_list_at(&lists, 0, &list);
    json_string(&r->doc, key, ladder->key, sizeof ladder->key);
    size_t count = (size_t)r->doc.nodes[list].size;
    ladder->rungs = calloc(count, sizeof *ladder->rungs);
    ladder->labels = calloc(count, sizeof *ladder->labels);
    if (!ladder->rungs || !ladder->labels)
        return memory_short(r);
    ladder->count = count;
    return fill_rungs(r, &lists, ladder);
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
        return memory_short(r);
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
        return fail(r, 0, "no error has a bound \"asked\", so that nothing in the map could be wrong");
    study->is_map = true;
    return fill_cells(r, &study->map[0], &study->map[1], &study->ladders[study->ladder_count++]);
}

/* Without ladders every method has one point. */
static enum status read_ladders(struct reading *r)
{
    struct study *study = r->study;
    int list, map;
    if (read_member(&r->doc, 0, "ladders", JSON_ARRAY, false, &list, r->e) ||
        read_member(&r->doc, 0, "map", JSON_OBJECT, false, &map, r->e))
        return r->e->status;
    if (map >= 0 && list >= 0)
        return fail(r, map, "give \"ladders\" or \"map\", not both");
    size_t count = list < 0 ? 1 : (size_t)r->doc.nodes[list].size;
    study->ladders = calloc(count + 1, sizeof *study->ladders);
    if (!study->ladders)
        return memory_short(r);
    if (map >= 0)
        return read_map(r, map);
    if (list < 0) {
        struct study_ladder *one = &study->ladders[study->ladder_count++];
        strcpy(one->name, "methods");
        one->rungs = calloc(1, sizeof *one->rungs);
        one->labels = calloc(1, sizeof *one->labels);
        one->count = one->rungs && one->labels;
        return one->count ? STATUS_OK : memory_short(r);
    }
    for (size_t k = 0; k < count; k++)
        if (read_ladder(r, set_value_at(&r->doc, list, k), &study->ladders[study->ladder_count++]))
            return r->e->status;
    for (size_t i = 0; i < count; i++)
        for (size_t j = 0; j < i; j++)
            if (strcmp(study->ladders[i].name, study->ladders[j].name) == 0)
                return fail(r, set_value_at(&r->doc, list, i), "two ladders have the same name");
    return count ? STATUS_OK : fail(r, list, "give at least one ladder, or leave the key out");
}

/* Whether formula or data can be used at all, before anything is run. */
static enum status check_reference(struct reading *r, int node, const struct study_asked *asked)
{
    struct error e = {.status = STATUS_OK, .text = ""};
    struct columns data = {0};
    const char *const names[] = {asked->reference_column, asked->low, asked->high};
    const double at = 0;
    double value;
    if (asked->formula)
        formula_values(asked->formula, &at, 1, &value, &e);
    if (asked->path && columns_read(&data, asked->path, &e) == STATUS_OK)
        for (size_t k = 0; k < sizeof names / sizeof *names && !e.status; k++)
            if (names[k][0])
                columns_need(&data, names[k], &e);
    columns_free(&data);
    if (e.status == STATUS_USAGE)
        return fail(r, json_member(&r->doc, node, asked->formula ? "formula" : "data"), e.text);
    return e.status ? error_set(r->e, e.status, "%s", e.text) : STATUS_OK;
}

/* {"value": 1}, {"formula": "exp(-t)"}, {"data": "file.csv", "column": "x"}, "first" or "run" */
static enum status read_reference(struct reading *r, int object, struct study_asked *asked)
{
    static const char *const help = "give \"first\", \"run\", {\"value\": X}, {\"formula\": \"exp(-t)\"} or "
                                    "{\"data\": \"FILE.csv\", \"column\": \"NAME\"}";
    char word[KEY_TEXT_SIZE];
    const struct json *doc = &r->doc;
    int node = json_member(doc, object, "reference");
    if (node < 0)
        return fail(r, object, "\"reference\" is missing");
    if (doc->nodes[node].kind == JSON_STRING) {
        json_string(doc, node, word, sizeof word);
        asked->kind = strcmp(word, "run") == 0 ? REFERENCE_RUN : REFERENCE_FIRST;
        return strcmp(word, "run") == 0 || strcmp(word, "first") == 0 ? STATUS_OK
                                                                      : fail(r, node, help);
    }
    if (doc->nodes[node].kind != JSON_OBJECT)
        return fail(r, node, help);
    if (read_only(doc, node, "value|formula|data|column|low|high", r->e) ||
        read_number(doc, node, "value", -INFINITY, INFINITY, &asked->value, r->e) ||
        read_long_text(doc, node, "formula", &asked->formula, r->e) ||
        read_path(r, node, "data", false, &asked->path) ||
        read_text(doc, node, "column", asked->path, asked->reference_column,
                  sizeof asked->reference_column, r->e) ||
        read_text(doc, node, "low", false, asked->low, sizeof asked->low, r->e) ||
        read_text(doc, node, "high", false, asked->high, sizeof asked->high, r->e))
        return r->e->status;
    if (!isnan(asked->value) + !!asked->formula + !!asked->path != 1)
        return fail(r, node, help);
    asked->kind = asked->formula ? REFERENCE_FORMULA : asked->path ? REFERENCE_DATA : REFERENCE_VALUE;
    return check_reference(r, node, asked);
}

static enum status read_asked(struct reading *r, int node, struct study_asked *asked)
{
    const struct variant *norm = norm_table.rows[0];
    *asked = (struct study_asked){.value = (double)NAN, .asked = (double)NAN};
    if (r->doc.nodes[node].kind != JSON_OBJECT)
        return fail(r, node, "give an object such as {\"column\": \"energy.kinetic\", \"reference\": "
                             "{\"formula\": \"exp(-t)\"}}");
    if (read_only(&r->doc, node, "name|column|norm|reference|asked", r->e) ||
        read_text(&r->doc, node, "column", true, asked->column, sizeof asked->column, r->e) ||
        read_variant(&r->doc, node, "norm", &norm_table, &norm, r->e) ||
        read_number(&r->doc, node, "asked", 0, INFINITY, &asked->asked, r->e) ||
        read_reference(r, node, asked))
        return r->e->status;
    asked->norm = (const struct norm_row *)norm;
    json_position(&r->doc, r->doc.nodes[json_member(&r->doc, node, "column")].start - 1, &asked->line,
                  &asked->character);
    snprintf(asked->name, sizeof asked->name, "%.60s, %s", asked->column, norm->name);
    return read_text(&r->doc, node, "name", false, asked->name, sizeof asked->name, r->e);
}

static enum status read_errors(struct reading *r)
{
    struct study *study = r->study;
    int list;
    if (read_member(&r->doc, 0, "errors", JSON_ARRAY, false, &list, r->e))
        return r->e->status;
    size_t count = list < 0 ? 0 : (size_t)r->doc.nodes[list].size;
    study->asked = calloc(count + 1, sizeof *study->asked);
    if (!study->asked)
        return memory_short(r);
    for (size_t k = 0; k < count; k++)
        if (read_asked(r, set_value_at(&r->doc, list, k), &study->asked[study->asked_count++]))
            return r->e->status;
    for (size_t k = 0; k < count; k++)
        if (study->asked[k].kind == REFERENCE_RUN && !study->reference.count)
            return fail(r, list, "an error is against a finer run, but \"reference\" is missing: give "
                                 "that run's settings, such as {\"particles.spacing\": 0.005}");
    return STATUS_OK; /* without errors a study is one of times */
}

static bool has_error(const struct study *study, const char *name)
{
    for (size_t k = 0; k < study->asked_count; k++)
        if (strcmp(study->asked[k].name, name) == 0)
            return true;
    return false;
}

static enum status read_plots(struct reading *r)
{
    struct study *study = r->study;
    int list;
    if (read_member(&r->doc, 0, "plot", JSON_ARRAY, false, &list, r->e) || list < 0)
        return r->e->status;
    size_t count = (size_t)r->doc.nodes[list].size;
    study->plots = calloc(count + 1, sizeof *study->plots);
    if (!study->plots)
        return memory_short(r);
    for (size_t k = 0; k < count; k++) {
        int node = set_value_at(&r->doc, list, k);
        if (r->doc.nodes[node].kind != JSON_STRING ||
            !json_string(&r->doc, node, study->plots[study->plot_count++], STUDY_NAME_SIZE))
            return fail(r, node, "give the name of an error");
        if (!study->known && !has_error(study, study->plots[k])) /* a case's are known when it ran */
            return fail(r, node, "there is no error of that name");
    }
    return STATUS_OK;
}

/* The text between the brackets of "measure". */
static enum status read_measure(struct reading *r)
{
    int node;
    if (read_member(&r->doc, 0, "measure", JSON_ARRAY, false, &node, r->e) || node < 0)
        return r->e->status;
    const struct json_node *n = &r->doc.nodes[node];
    r->study->measure = strndup(r->doc.text + n->start + 1, (size_t)(n->end - n->start - 2));
    return r->study->measure ? STATUS_OK : memory_short(r);
}

static enum status read_study(struct reading *r)
{
    struct study *study = r->study;
    const struct json *doc = &r->doc;
    const struct variant *known = NULL;
    double repeats = json_member(doc, 0, "map") < 0 ? 3 : 1;
    if (read_only(doc, 0, "title|scene|case|measure|interval|errors|plot|floor|set|reference|methods|"
                          "ladders|map|repeats|limit", r->e) ||
        read_text(doc, 0, "title", true, study->title, sizeof study->title, r->e) ||
        read_path(r, 0, "scene", true, &study->scene) ||
        read_variant(doc, 0, "case", &case_table, &known, r->e) ||
        read_number(doc, 0, "interval", 1e-9, 1e9, &study->interval, r->e) ||
        read_number(doc, 0, "floor", 0, 1, &study->floor, r->e) ||
        read_number(doc, 0, "repeats", 1, STUDY_REPEATS_MAX, &repeats, r->e) ||
        read_number(doc, 0, "limit", 1e-3, INFINITY, &study->limit, r->e))
        return r->e->status;
    study->known = (const struct case_row *)known;
    study->repeats = (int)repeats;
    if (read_measure(r) || read_set(r, 0, "set", &study->set) ||
        read_set(r, 0, "reference", &study->reference) || read_errors(r) || read_plots(r) ||
        read_methods(r))
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
                                                    : fail(&r, 0, "a study is an object");
    json_free(&r.doc);
    return status;
}

static void ladder_free(struct study_ladder *ladder)
{
    for (size_t rung = 0; rung < ladder->count; rung++)
        set_free(&ladder->rungs[rung]);
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
