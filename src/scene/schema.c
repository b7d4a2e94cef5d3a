/* Writes the JSON Schema of scene files, for editors. */
#include "base/quote.h"
#include "scene/value.h"

#include <math.h>
#include <string.h>

struct schema {
    struct key_list keys;
    FILE *out;
    int depth; /* of indentation, in steps of two spaces */
};

static void schema_object(struct schema *s, const char *prefix);

static void line(struct schema *s)
{
    fprintf(s->out, "\n%*s", 2 * s->depth, "");
}

static void quoted(struct schema *s, const char *text)
{
    char out[1024];
    json_quote(text, out, sizeof out);
    fputs(out, s->out);
}

/* ', "minimum": 0' and so on, of a single number. */
static void schema_range(struct schema *s, const struct key *key)
{
    char low[32], high[32];
    if (key->min == key->max)
        return;
    value_number(key->min, low);
    value_number(key->max, high);
    if (isfinite(key->min))
        fprintf(s->out, ", \"%s\": %s",
                key->flags & KEY_ABOVE_MIN ? "exclusiveMinimum" : "minimum", low);
    if (isfinite(key->max))
        fprintf(s->out, ", \"maximum\": %s", high);
}

static void schema_numbers(struct schema *s, const struct key *key, const char *type, int count)
{
    fprintf(s->out, "\"type\": \"array\", \"items\": {\"type\": \"%s\"", type);
    schema_range(s, key);
    fprintf(s->out, "}, \"minItems\": %d, \"maxItems\": %d", count, count);
}

static void schema_words(struct schema *s, const struct key *key)
{
    const struct variant_table *table = vocabulary_table(s->keys.vocabulary, key->choices);
    char word[KEY_TEXT_SIZE];
    bool words = strchr(key->choices, '|') != NULL, first = true;
    fputs(key->flags & KEY_SWITCH ? "\"enum\": [false, true" : "\"type\": \"string\"", s->out);
    if (!words && !table)
        return;
    fputs(key->flags & KEY_SWITCH ? ", " : ", \"enum\": [", s->out);
    if (key->flags & KEY_AUTO) {
        fputs("\"auto\"", s->out);
        first = false;
    }
    for (int i = 0; words && (key_word_at(key->choices, i, word), word[0]); i++, first = false) {
        fputs(first ? "" : ", ", s->out);
        quoted(s, word);
    }
    for (size_t i = 0; !words && i < table->count; i++, first = false) {
        fputs(first ? "" : ", ", s->out);
        quoted(s, table->rows[i]->name);
    }
    fputc(']', s->out);
}

static void schema_type(struct schema *s, const struct key *key)
{
    switch (key->type) {
    case KEY_BOOL: fputs("\"type\": \"boolean\"", s->out); break;
    case KEY_INT:
    case KEY_REAL:
        fprintf(s->out, "\"type\": \"%s\"", key->type == KEY_INT ? "integer" : "number");
        schema_range(s, key);
        break;
    case KEY_VEC3: schema_numbers(s, key, "number", 3); break;
    case KEY_PAIR: schema_numbers(s, key, "number", 2); break;
    case KEY_SIZE: schema_numbers(s, key, "integer", 2); break;
    case KEY_TEXT:
        fprintf(s->out, "\"type\": \"string\", \"maxLength\": %d", KEY_TEXT_SIZE - 1);
        break;
    case KEY_CHOICE:
    case KEY_ENUM: schema_words(s, key); break;
    }
}

static void schema_notes(struct schema *s, size_t row)
{
    const struct key_entry *entry = &s->keys.items[row];
    char text[600];
    snprintf(text, sizeof text, "%s%s%s%s%s%s%s", entry->key->doc, entry->key->unit[0] ? " [" : "",
             entry->key->unit, entry->key->unit[0] ? "]" : "", entry->owner ? " (for " : "",
             entry->owner ? entry->owner->name : "", entry->owner ? ")" : "");
    fputs("\"description\": ", s->out);
    quoted(s, text);
    if (entry->key->fallback)
        fprintf(s->out, ", \"default\": %s", entry->key->fallback);
}

static bool is_number(const struct key *key)
{
    return key->type != KEY_CHOICE && key->type != KEY_ENUM && key->type != KEY_TEXT;
}

/* Variants may share a path: then any of their types will do. */
static void schema_leaf(struct schema *s, size_t row)
{
    const char *path = s->keys.items[row].key->path;
    int rows = 0, given = 0;
    bool chosen = false; /* "auto" beside numbers; words have it in their enum */
    for (size_t i = row; i < s->keys.count; i++) {
        const struct key *key = s->keys.items[i].key;
        if (strcmp(key->path, path) != 0)
            continue;
        rows++;
        chosen |= key->flags & KEY_AUTO && is_number(key);
    }
    bool several = rows > 1 || chosen;
    fputc('{', s->out);
    schema_notes(s, row);
    fputs(several ? ", \"anyOf\": [" : ", ", s->out);
    if (chosen)
        fputs("{\"const\": \"auto\"}", s->out);
    for (size_t i = row; i < s->keys.count; i++) {
        if (strcmp(s->keys.items[i].key->path, path) != 0)
            continue;
        fputs(several ? (chosen || given++ ? ", {" : "{") : "", s->out);
        schema_type(s, s->keys.items[i].key);
        fputs(several ? "}" : "", s->out);
    }
    fputs(several ? "]}" : "}", s->out);
}

static void schema_child(struct schema *s, size_t row, enum key_place place, const char *prefix,
                         const char *name)
{
    char below[2 * KEY_TEXT_SIZE];
    snprintf(below, sizeof below, "%s%s%s.", prefix, name, place == PLACE_ARRAY ? "[]" : "");
    quoted(s, name);
    fputs(": ", s->out);
    if (place == PLACE_LEAF) {
        schema_leaf(s, row);
    } else if (place == PLACE_ARRAY) {
        fprintf(s->out, "{\"type\": \"array\", \"minItems\": %d, ", strcmp(name, "fluids") == 0);
        if (strcmp(name, "obstacles") == 0)
            fprintf(s->out, "\"maxItems\": %d, ", OBSTACLES_MAX);
        fputs("\"items\": ", s->out);
        schema_object(s, below);
        fputc('}', s->out);
    } else if (place == PLACE_GROUP) {
        fputc('{', s->out);
        schema_notes(s, row);
        fputs(", \"anyOf\": [{", s->out);
        schema_type(s, s->keys.items[row].key);
        fputs("}, ", s->out);
        schema_object(s, below);
        fputs("]}", s->out);
    } else {
        schema_object(s, below);
    }
}

static bool is_required(const struct key *key)
{
    return !key->fallback && !key_is_shaped(key);
}

/* A child must be given when it is, or holds, a key without a default. */
static bool child_required(const struct schema *s, const char *prefix, const char *name,
                           enum key_place place)
{
    char path[2 * KEY_TEXT_SIZE];
    if (place == PLACE_ARRAY)
        return strcmp(name, "fluids") == 0;
    snprintf(path, sizeof path, "%s%s", prefix, name);
    size_t n = strlen(path);
    for (size_t i = 0; i < s->keys.count; i++) {
        const struct key *key = s->keys.items[i].key;
        if (!s->keys.items[i].owner && strncmp(key->path, path, n) == 0 &&
            (key->path[n] == '\0' || key->path[n] == '.') && !strstr(key->path + n, "[]") &&
            is_required(key))
            return true;
    }
    return false;
}

static void schema_required(struct schema *s, const char *prefix)
{
    char name[KEY_TEXT_SIZE];
    int count = 0;
    for (size_t i = 0; i < s->keys.count; i++) {
        enum key_place place = key_child(&s->keys, i, prefix, name);
        if (place == PLACE_NONE || !child_required(s, prefix, name, place))
            continue;
        fputs(count++ ? ", " : "\"required\": [", s->out);
        quoted(s, name);
    }
    if (count) {
        fputs("],", s->out);
        line(s);
    }
}

/* Keys of an array's elements that a shape needs, and those it must not have. */
static void schema_shape(struct schema *s, const char *prefix, enum shape_kind shape)
{
    int required = 0, refused = 0;
    size_t n = strlen(prefix);
    fprintf(s->out, "{\"if\": {\"properties\": {\"shape\": {\"const\": \"%s\"}}, \"required\": "
            "[\"shape\"]}, \"then\": {\"required\": [", shape_words[shape]);
    for (size_t i = 0; i < scene_core_key_count; i++) {
        const struct key *key = &scene_core_keys[i];
        if (strncmp(key->path, prefix, n) == 0 && key_is_shaped(key) && key_fits_shape(key, shape) &&
            !key->fallback)
            fprintf(s->out, "%s\"%s\"", required++ ? ", " : "", key->path + n);
    }
    fputs("], \"properties\": {", s->out);
    for (size_t i = 0; i < scene_core_key_count; i++) {
        const struct key *key = &scene_core_keys[i];
        if (strncmp(key->path, prefix, n) == 0 && !key_fits_shape(key, shape))
            fprintf(s->out, "%s\"%s\": false", refused++ ? ", " : "", key->path + n);
    }
    fputs("}}}", s->out);
}

static void schema_shapes(struct schema *s, const char *prefix)
{
    fputs("\"allOf\": [", s->out);
    for (int i = SHAPE_BOX; i <= SHAPE_CYLINDER; i++) {
        fputs(i ? "," : "", s->out);
        line(s);
        schema_shape(s, prefix, (enum shape_kind)i);
    }
    fputs("],", s->out);
    line(s);
}

static bool owns(const struct variant *variant, const char *path)
{
    size_t k = 0;
    while (k < variant->key_count && strcmp(variant->keys[k].path, path) != 0)
        k++;
    return k < variant->key_count;
}

/* Keys that an element needs when it chose the variant, and those of others, which it must not
 * have. */
static void schema_owner(struct schema *s, const struct variant *variant, const char *chooser)
{
    int required = 0, refused = 0;
    fprintf(s->out, "{\"if\": {\"properties\": {\"%s\": {\"const\": \"%s\"}}, \"required\": "
            "[\"%s\"]}, \"then\": {\"required\": [", chooser, variant->name, chooser);
    for (size_t k = 0; k < variant->key_count; k++)
        if (!variant->keys[k].fallback)
            fprintf(s->out, "%s\"%s\"", required++ ? ", " : "",
                    strrchr(variant->keys[k].path, '.') + 1);
    fputs("], \"properties\": {", s->out);
    for (size_t i = scene_core_key_count; i < s->keys.count; i++) {
        const char *path = s->keys.items[i].key->path;
        if (strstr(path, "[].") && key_list_find(&s->keys, path) == i && !owns(variant, path))
            fprintf(s->out, "%s\"%s\": false", refused++ ? ", " : "", strrchr(path, '.') + 1);
    }
    fputs("}}}", s->out);
}

static void schema_quantities(struct schema *s)
{
    const struct variant_table *table = vocabulary_table(s->keys.vocabulary, "measures");
    if (!table)
        return;
    fputs("\"allOf\": [", s->out);
    for (size_t i = 0; i < table->count; i++) {
        fputs(i ? "," : "", s->out);
        line(s);
        schema_owner(s, table->rows[i], "quantity");
    }
    fputs("],", s->out);
    line(s);
}

static void schema_members(struct schema *s, const char *prefix)
{
    char name[KEY_TEXT_SIZE];
    bool first = true;
    line(s);
    fputs("\"type\": \"object\", \"additionalProperties\": false,", s->out);
    line(s);
    schema_required(s, prefix);
    for (int a = 0; a < ARRAY_COUNT; a++)
        if (scene_arrays[a].shape != KEY_SHAPELESS && strcmp(prefix, scene_arrays[a].prefix) == 0)
            schema_shapes(s, prefix);
    if (strcmp(prefix, "measure[].") == 0)
        schema_quantities(s);
    fputs("\"properties\": {", s->out);
    s->depth++;
    for (size_t i = 0; i < s->keys.count; i++) {
        enum key_place place = key_child(&s->keys, i, prefix, name);
        if (place == PLACE_NONE)
            continue;
        fputs(first ? "" : ",", s->out);
        line(s);
        schema_child(s, i, place, prefix, name);
        first = false;
    }
    s->depth--;
    line(s);
    fputs("}", s->out);
}

static void schema_object(struct schema *s, const char *prefix)
{
    fputc('{', s->out);
    s->depth++;
    schema_members(s, prefix);
    s->depth--;
    line(s);
    fputc('}', s->out);
}

void scene_write_schema(const struct vocabulary *vocabulary, FILE *out)
{
    struct schema s = {.out = out, .depth = 1};
    struct error ignored;
    if (key_list_create(&s.keys, vocabulary, &ignored))
        return;
    fputs("{\n  \"$schema\": \"https://json-schema.org/draft/2020-12/schema\",\n"
          "  \"title\": \"sph-render scene\",\n"
          "  \"description\": \"A fluid scene and its film; SI units.\",", out);
    schema_members(&s, "");
    fputs("\n}\n", out);
    key_list_free(&s.keys);
}
