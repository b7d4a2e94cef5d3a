/* Writes a stability map's tables: stability.csv, stability.json, report.md. */
#include "study/products/fields.h"
#include "study/products/text.h"
#include "study/map/map.h"

#include "base/output.h"
#include "base/quote.h"
#include "run/report.h"

#include <math.h>
#include <string.h>

static const char *x_label(const struct map *map, const struct map_cell *cell)
{
    return map->study->map[0].labels[cell->x];
}

static const char *y_label(const struct map *map, const struct map_cell *cell)
{
    return map->study->map[1].labels[cell->y];
}

static const char *method_name(const struct map *map, const struct map_cell *cell)
{
    return map->study->methods[cell->method].name;
}

static void field_text(const char *text, FILE *out)
{
    csv_text(text, out);
    fputc(',', out);
}

static void field_number(double number, FILE *out)
{
    csv_number(number, out);
    fputc(',', out);
}

static void csv_cell(const struct map *map, const struct map_cell *cell,
                     const struct study_errors *errors, FILE *out)
{
    const struct study_point *point = cell->point;
    const char *const texts[] = {method_name(map, cell), x_label(map, cell), y_label(map, cell),
                                 cell_looks[cell->kind].name, cell->why};
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++)
        field_text(texts[k], out);
    const double numbers[] = {cell->step, cell->steps, cell->fewest, cell->rejected,
                              cell->steps > 0 ? point->scene->time.end / cell->steps : (double)NAN,
                              study_wall(point)};
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++)
        field_number(numbers[k], out);
    fprintf(out, "%s,", cell->bound);
    for (int k = 0; k < LIMIT_COUNT; k++)
        field_number(cell->limits[k], out);
    field_number(cell->explicit_viscous, out);
    for (size_t k = 0; errors && k < errors->count; k++) {
        const struct study_error *error = study_error(point, errors->items[k].name);
        field_number(error ? error->value : (double)NAN, out);
    }
    fprintf(out, "%s,%s\n", point->hash, point->folder);
}

static void write_csv(const struct map *map, const struct study_results *results, FILE *out)
{
    const struct study_errors *errors = study_most_errors(results->points, NULL);
    fputs("method,", out);
    field_text(map->study->map[0].key, out);
    field_text(map->study->map[1].key, out);
    fputs("kind,why,step asked (s),steps,fewest steps,rejected,mean step (s),wall (s),bound by,", out);
    for (int k = 0; k < LIMIT_COUNT; k++)
        fprintf(out, "%s limit (s),", limit_words[k]);
    fputs("explicit viscous limit (s),", out);
    for (size_t k = 0; errors && k < errors->count; k++)
        field_text(errors->items[k].name, out);
    fputs("state,folder\n", out);
    for (size_t k = 0; k < map->count; k++)
        csv_cell(map, &map->cells[k], errors, out);
}

static void json_cell(const struct map *map, const struct map_cell *cell, FILE *out)
{
    const struct study_errors *errors = &cell->point->errors;
    char name[2 * sizeof errors->items[0].name + 3];
    fputs("{", out);
    json_text("method", method_name(map, cell), out);
    json_text("x", x_label(map, cell), out);
    json_text("y", y_label(map, cell), out);
    json_text("kind", cell_looks[cell->kind].name, out);
    json_text("why", cell->why, out);
    json_number("step_asked", cell->step, out);
    json_number("steps", cell->steps, out);
    json_number("fewest_steps", cell->fewest, out);
    json_number("rejected", cell->rejected, out);
    json_number("wall", study_wall(cell->point), out);
    json_text("bound_by", cell->bound, out);
    json_number("bound_part", cell->bound_part, out);
    fputs("\"limits\": {", out);
    for (int k = 0; k < LIMIT_COUNT; k++)
        json_number(limit_words[k], cell->limits[k], out);
    fputs("\"unit\": \"s\"}, \"errors\": {", out);
    for (size_t k = 0; k < errors->count; k++) {
        json_quote(errors->items[k].name, name, sizeof name);
        fprintf(out, "%s%s: %.9g", k ? ", " : "", name,
                isfinite(errors->items[k].value) ? errors->items[k].value : -1);
    }
    fputs("}, ", out);
    json_text("state", cell->point->hash, out);
    fprintf(out, "\"folder\": \"%s\"}", cell->point->folder);
}

static void write_json(const struct map *map, const struct study_results *results, FILE *out)
{
    fputs("{", out);
    json_text("title", map->study->title, out);
    json_text("study", map->study->path, out);
    json_text("program", "sph-render " SPH_VERSION, out);
    json_text("processor", report_processor(), out);
    json_text("command", results->about->command, out);
    json_text("date", results->about->date, out);
    json_text("x", map->study->map[0].key, out);
    json_text("y", map->study->map[1].key, out);
    fputs("\"cells\": [", out);
    for (size_t k = 0; k < map->count; k++) {
        fputs(k ? ",\n  " : "\n  ", out);
        json_cell(map, &map->cells[k], out);
    }
    fputs("]}\n", out);
}

static void markdown_cell(const char *text, FILE *out)
{
    fputc(' ', out);
    text_markdown(text, out);
    fputs(" |", out);
}

/* The beginning of a row: method, column and row of the map. */
static void markdown_place(const struct map *map, const struct map_cell *cell, FILE *out)
{
    fputc('|', out);
    markdown_cell(method_name(map, cell), out);
    markdown_cell(x_label(map, cell), out);
    markdown_cell(y_label(map, cell), out);
}

static size_t count_of(const struct map *map, size_t method, enum cell_kind kind)
{
    size_t count = 0;
    for (size_t k = 0; k < map->count; k++)
        count += map->cells[k].method == method && map->cells[k].kind == kind;
    return count;
}

static void write_counts(const struct map *map, FILE *out)
{
    fputs("| method |", out);
    for (int kind = 0; kind < CELL_KINDS; kind++)
        fprintf(out, " %s |", cell_looks[kind].name);
    fputs("\n|---|", out);
    for (int kind = 0; kind < CELL_KINDS; kind++)
        fputs("---|", out);
    for (size_t m = 0; m < map->study->method_count; m++) {
        fputs("\n|", out);
        markdown_cell(map->study->methods[m].name, out);
        for (int kind = 0; kind < CELL_KINDS; kind++)
            fprintf(out, " %zu |", count_of(map, m, (enum cell_kind)kind));
    }
    fputs("\n\n", out);
    for (int kind = 0; kind < CELL_KINDS; kind++)
        fprintf(out, "- %s: %s\n", cell_looks[kind].name, cell_looks[kind].doc);
}

static void write_bounds(const struct study_results *results, FILE *out)
{
    const struct study_errors *errors = study_most_errors(results->points, NULL);
    fputs("\n## Bounds\n\nWrong is beyond one of\n\n", out);
    for (size_t k = 0; errors && k < errors->count; k++) {
        char bound[64];
        if (!isnan(errors->items[k].asked)) {
            text_error(errors->items[k].asked, errors->items[k].unit, bound, sizeof bound);
            fputs("- ", out);
            text_markdown(errors->items[k].name, out);
            fprintf(out, ": %s\n", bound);
        }
    }
}

/* Cells of one kind with what is to be said of them. */
static void write_cells(const struct map *map, enum cell_kind kind, const char *title, FILE *out)
{
    bool any = false;
    for (size_t k = 0; k < map->count; k++) {
        const struct map_cell *cell = &map->cells[k];
        if (cell->kind != kind)
            continue;
        if (!any)
            fprintf(out, "\n## %s\n\n| method | %s | %s | why |\n|---|---|---|---|\n", title,
                    map->study->map[0].key, map->study->map[1].key);
        any = true;
        markdown_place(map, cell, out);
        markdown_cell(cell->why, out);
        fputs("\n", out);
    }
}

/* How much shorter steps are than asked, and by which limit: rows of the table are those of the map. */
static void write_shortened(const struct map *map, FILE *out)
{
    bool any = false;
    for (size_t k = 0; k < map->count; k++) {
        const struct map_cell *cell = &map->cells[k];
        if (cell->kind != CELL_SHORTENED)
            continue;
        if (!any)
            fprintf(out, "\n## Shortened\n\n| method | %s | %s | steps | of asked length | rejected | "
                         "most bound by |\n|---|---|---|---|---|---|---|\n",
                    map->study->map[0].key, map->study->map[1].key);
        any = true;
        markdown_place(map, cell, out);
        fprintf(out, " %.0f | %.0f | %.0f | %s (%.0f %%) |\n", cell->steps, cell->fewest,
                cell->rejected, cell->bound, 100 * cell->bound_part);
    }
}

static void write_report(const struct map *map, const struct study_results *results, FILE *out)
{
    fputs("# ", out);
    text_markdown(map->study->title, out);
    fputs("\n\n![map](stability.png)\n\nColumns: ", out);
    text_markdown(map->study->map[0].name, out);
    fprintf(out, " (`%s`). Rows: ", map->study->map[0].key);
    text_markdown(map->study->map[1].name, out);
    fprintf(out, " (`%s`). %zu runs of `%s`, %s, %s.\n\n    %s\n\n", map->study->map[1].key, map->count, map->study->scene, report_processor(),
            results->about->date, results->about->command);
    write_counts(map, out);
    fputs("\nCurves are the limits of the time step at the start:\n\n", out);
    for (int k = 0; k < LIMIT_COUNT; k++)
        if (limit_formulas[k])
            fprintf(out, "- %s: %s\n", limit_words[k], limit_formulas[k]);
    write_bounds(results, out);
    write_cells(map, CELL_WRONG, "Wrong", out);
    write_cells(map, CELL_STOPPED, "Stopped", out);
    write_cells(map, CELL_LATE, "Late", out);
    write_cells(map, CELL_LEFT_OUT, "Left out", out);
    write_shortened(map, out);
}

enum status map_write(const struct map *map, const struct study_results *results, struct error *e)
{
    static const char *const names[] = {"stability.csv", "stability.json", "report.md"};
    for (int k = 0; k < 3; k++) {
        char path[4096];
        struct output_file file;
        snprintf(path, sizeof path, "%s/%s", results->directory, names[k]);
        if (output_open(&file, path, e))
            return e->status;
        (k == 0 ? write_csv : k == 1 ? write_json : write_report)(map, results, file.stream);
        if (output_close(&file, true, e))
            return e->status;
    }
    return STATUS_OK;
}
