/* sph-render list: prints the variant tables and the scene keys. */
#include "base/log.h"
#include "base/suggest.h"
#include "run/run.h"
#include "study/products/products.h"
#include "tools/devices.h"
#include "tools/tools.h"

#include <argp.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/* Tables that no scene chooses from. */
static const struct variant_table *const more[] = {&tool_table, &case_table, &norm_table,
                                                   &product_table};
enum { MORE = sizeof more / sizeof *more };

/* The table of that place among all, or NULL. */
static const struct variant_table *table_at(size_t place)
{
    if (place < run_vocabulary.count)
        return run_vocabulary.tables[place];
    place -= run_vocabulary.count;
    return place < MORE ? more[place] : NULL;
}

struct list {
    const char *what; /* NULL: everything */
    bool schema;
};

static error_t parse_option(int key, char *value, struct argp_state *state)
{
    struct list *list = state->input;
    if (key == 'j') {
        list->schema = true;
        return 0;
    }
    if (key != ARGP_KEY_ARG)
        return ARGP_ERR_UNKNOWN;
    if (list->what)
        argp_error(state, "one table at a time: %s and %s", list->what, value);
    list->what = value;
    return 0;
}

static void print_table(const struct variant_table *table)
{
    int width = 0;
    for (size_t i = 0; i < table->count; i++)
        if ((int)strlen(table->rows[i]->name) > width)
            width = (int)strlen(table->rows[i]->name);
    printf("%s: %s\n", table->name, table->doc);
    for (size_t i = 0; i < table->count; i++) {
        const struct variant *row = table->rows[i];
        printf("  %-*s  %s", width, row->name, row->doc);
        if (row->missing)
            printf(" (not in this build: %s)", row->missing);
        putchar('\n');
    }
}

static void print_all(void)
{
    for (size_t t = 0; table_at(t); t++) {
        print_table(table_at(t));
        putchar('\n');
    }
    printf("keys: what a scene file may say; NAME[] is an array, --set counts it from 0\n");
    scene_write_keys(&run_vocabulary, stdout);
}

static int unknown_table(const char *what)
{
    struct suggest near;
    suggest_start(&near, what);
    suggest_offer(&near, "keys");
    suggest_offer(&near, "devices");
    for (size_t t = 0; table_at(t); t++)
        suggest_offer(&near, table_at(t)->name);
    const char *best = suggest_best(&near);
    log_error("list: there is no table \"%s\"%s%s; `sph-render list' shows all", what,
              best ? "; did you mean " : "", best ? best : "");
    return STATUS_USAGE;
}

static int print_one(const char *what)
{
    if (strcmp(what, "keys") == 0) {
        scene_write_keys(&run_vocabulary, stdout);
        return STATUS_OK;
    }
    if (strcmp(what, "devices") == 0) {
        devices_print();
        return STATUS_OK;
    }
    for (size_t t = 0; table_at(t); t++)
        if (strcmp(table_at(t)->name, what) == 0) {
            print_table(table_at(t));
            return STATUS_OK;
        }
    return unknown_table(what);
}

static int list_main(int argc, char **argv)
{
    static const struct argp_option options[] = {
        {"json-schema", 'j', NULL, 0, "Print the JSON Schema of scene files (with keys)", 0}, {0}};
    static const struct argp argp = {
        options, parse_option, "[TABLE]",
        "Prints the tables of solvers, kernels, encoders and so on, or one of them; `keys' is the "
        "table of scene keys, and `devices' the GPUs of this machine.", NULL, NULL, NULL};
    static char name[] = "sph-render list";
    struct list list = {0};
    argv[0] = name;
    if (argp_parse(&argp, argc, argv, 0, NULL, &list))
        return STATUS_USAGE;
    if (list.schema && list.what && strcmp(list.what, "keys") != 0) {
        log_error("list: --json-schema is of keys, not of %s", list.what);
        return STATUS_USAGE;
    }
    int status = STATUS_OK;
    if (list.schema)
        scene_write_schema(&run_vocabulary, stdout);
    else if (list.what)
        status = print_one(list.what);
    else
        print_all();
    return status;
}

extern const struct tool tool_list;
const struct tool tool_list = {
    .variant = {.name = "list", .doc = "print every table: solvers, encoders, scene keys ..."},
    .run = list_main};
