/* Reads the errors of a study: what is measured, compared with what, and drawn. */
#include "study/reading.h"
#include "study/reference/formula.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
        return reading_fail(r, json_member(&r->doc, node, asked->formula ? "formula" : "data"), e.text);
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
        return reading_fail(r, object, "\"reference\" is missing");
    if (doc->nodes[node].kind == JSON_STRING) {
        json_string(doc, node, word, sizeof word);
        asked->kind = strcmp(word, "run") == 0 ? REFERENCE_RUN : REFERENCE_FIRST;
        return strcmp(word, "run") == 0 || strcmp(word, "first") == 0 ? STATUS_OK
                                                                      : reading_fail(r, node, help);
    }
    if (doc->nodes[node].kind != JSON_OBJECT)
        return reading_fail(r, node, help);
    if (read_only(doc, node, "value|formula|data|column|low|high", r->e) ||
        read_number(doc, node, "value", -INFINITY, INFINITY, &asked->value, r->e) ||
        read_long_text(doc, node, "formula", &asked->formula, r->e) ||
        reading_path(r, node, "data", false, &asked->path) ||
        read_text(doc, node, "column", asked->path, asked->reference_column,
                  sizeof asked->reference_column, r->e) ||
        read_text(doc, node, "low", false, asked->low, sizeof asked->low, r->e) ||
        read_text(doc, node, "high", false, asked->high, sizeof asked->high, r->e))
        return r->e->status;
    if (!isnan(asked->value) + !!asked->formula + !!asked->path != 1)
        return reading_fail(r, node, help);
    asked->kind = asked->formula ? REFERENCE_FORMULA : asked->path ? REFERENCE_DATA : REFERENCE_VALUE;
    return check_reference(r, node, asked);
}

static enum status read_asked(struct reading *r, int node, struct study_asked *asked)
{
    const struct variant *norm = norm_table.rows[0];
    *asked = (struct study_asked){.value = (double)NAN, .asked = (double)NAN};
    if (r->doc.nodes[node].kind != JSON_OBJECT)
        return reading_fail(r, node, "give an object such as {\"column\": \"energy.kinetic\", \"reference\": "
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

static enum status read_list(struct reading *r)
{
    struct study *study = r->study;
    int list;
    if (read_member(&r->doc, 0, "errors", JSON_ARRAY, false, &list, r->e))
        return r->e->status;
    size_t count = list < 0 ? 0 : (size_t)r->doc.nodes[list].size;
    study->asked = calloc(count + 1, sizeof *study->asked);
    if (!study->asked)
        return reading_memory(r);
    for (size_t k = 0; k < count; k++)
        if (read_asked(r, set_value_at(&r->doc, list, k), &study->asked[study->asked_count++]))
            return r->e->status;
    for (size_t k = 0; k < count; k++)
        if (study->asked[k].kind == REFERENCE_RUN && !study->reference.count)
            return reading_fail(r, list, "an error is against a finer run, but \"reference\" is missing: give "
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
        return reading_memory(r);
    for (size_t k = 0; k < count; k++) {
        int node = set_value_at(&r->doc, list, k);
        if (r->doc.nodes[node].kind != JSON_STRING ||
            !json_string(&r->doc, node, study->plots[study->plot_count++], STUDY_NAME_SIZE))
            return reading_fail(r, node, "give the name of an error");
        if (!study->known && !has_error(study, study->plots[k])) /* a case's are known when it ran */
            return reading_fail(r, node, "there is no error of that name");
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
    return r->study->measure ? STATUS_OK : reading_memory(r);
}

enum status read_errors(struct reading *r)
{
    if (read_measure(r) || read_list(r))
        return r->e->status;
    return read_plots(r);
}
