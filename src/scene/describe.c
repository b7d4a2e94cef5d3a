/* Writes the table of all scene keys for a person. */
#include "scene/value.h"

#include <math.h>
#include <string.h>

enum { COLUMNS = 5 };

struct cells {
    char text[COLUMNS][80]; /* key, type, default, range, unit */
};

static const char *const titles[COLUMNS] = {"KEY", "TYPE", "DEFAULT", "RANGE", "UNIT"};

static const char *type_name(enum key_type type)
{
    static const char *const names[] = {
        [KEY_BOOL] = "true|false", [KEY_INT] = "integer", [KEY_REAL] = "number",
        [KEY_TEXT] = "text", [KEY_CHOICE] = "choice", [KEY_VEC3] = "3 numbers",
        [KEY_PAIR] = "2 numbers", [KEY_SIZE] = "2 integers", [KEY_ENUM] = "choice"};
    return names[type];
}

static void range_cell(const struct key *key, char *out, size_t size)
{
    char low[32], high[32];
    if (key->choices && strchr(key->choices, '|')) {
        snprintf(out, size, "%s", key->choices);
    } else if (key->choices) {
        snprintf(out, size, "list %s", key->choices);
    } else if (key->min != key->max) {
        value_number(key->min, low);
        value_number(key->max, high);
        bool above = key->flags & KEY_ABOVE_MIN;
        if (isfinite(key->min) && isfinite(key->max))
            snprintf(out, size, above ? "> %s, <= %s" : "%s to %s", low, high);
        else if (isfinite(key->min))
            snprintf(out, size, "%s %s", above ? ">" : ">=", low);
        else
            snprintf(out, size, "<= %s", high);
    }
}

static void cells_fill(struct cells *c, const struct key *key)
{
    memset(c, 0, sizeof *c);
    snprintf(c->text[0], sizeof c->text[0], "%s", key->path);
    snprintf(c->text[1], sizeof c->text[1], "%s", type_name(key->type));
    snprintf(c->text[2], sizeof c->text[2], "%s",
             key->fallback ? key->fallback : key_is_shaped(key) ? "(by shape)" : "(required)");
    range_cell(key, c->text[3], sizeof c->text[3]);
    snprintf(c->text[4], sizeof c->text[4], "%s", key->unit);
}

void scene_write_keys(const struct vocabulary *vocabulary, FILE *out)
{
    struct key_list keys;
    struct error ignored;
    struct cells c;
    int width[COLUMNS];
    if (key_list_create(&keys, vocabulary, &ignored))
        return;
    for (int k = 0; k < COLUMNS; k++)
        width[k] = (int)strlen(titles[k]);
    for (size_t i = 0; i < keys.count; i++) {
        cells_fill(&c, keys.items[i].key);
        for (int k = 0; k < COLUMNS; k++)
            if ((int)strlen(c.text[k]) > width[k])
                width[k] = (int)strlen(c.text[k]);
    }
    for (int k = 0; k < COLUMNS; k++)
        fprintf(out, "%-*s  ", width[k], titles[k]);
    fprintf(out, "MEANING\n");
    for (size_t i = 0; i < keys.count; i++) {
        const struct key_entry *entry = &keys.items[i];
        cells_fill(&c, entry->key);
        for (int k = 0; k < COLUMNS; k++)
            fprintf(out, "%-*s  ", width[k], c.text[k]);
        fprintf(out, "%s", entry->key->doc);
        if (entry->owner)
            fprintf(out, " (%s: %s)", entry->table->name, entry->owner->name);
        fputc('\n', out);
    }
    key_list_free(&keys);
}
