/* Writes what several stability maps have in common: a page with all of them, and a table of their cells. */
#include "study/map/index.h"

#include "base/html.h"
#include "base/output.h"
#include "study/map/map.h"
#include "study/products/summary.h"
#include "study/products/text.h"

#include <libgen.h>
#include <string.h>
#include <unistd.h>

enum { METHODS_MAX = 16 };

static const char opening[] =
    "<!DOCTYPE html>\n<html lang=\"en\"><meta charset=\"utf-8\">\n"
    "<meta name=\"viewport\" content=\"width=device-width\">\n<style>"
    "body{font:15px/1.45 sans-serif;color:#222;margin:2em auto;max-width:1180px;padding:0 1em}"
    "h1{font-size:1.6em}h2{font-size:1.25em;margin-top:2em;border-bottom:1px solid #ccc}"
    "figure{margin:.4em 0}figure img{width:600px;max-width:100%}"
    "table{border-collapse:collapse;font-size:.9em}td,th{padding:.2em .6em;text-align:right;"
    "border-bottom:1px solid #e4e4e4}td:first-child,th:first-child{text-align:left}"
    ".wide{overflow-x:auto}code{background:#f4f4f4;overflow-wrap:anywhere}</style>\n"
    "<title>Stability maps</title>\n<h1>Stability maps</h1>\n";

static size_t count_of(const struct map *map, size_t method, enum cell_kind kind)
{
    size_t count = 0;
    for (size_t k = 0; k < map->count; k++)
        count += map->cells[k].method == method && map->cells[k].kind == kind;
    return count;
}

/* Whether cells of that kind are in some map. */
static bool is_used(const struct map *maps, size_t count, enum cell_kind kind)
{
    bool used = kind < CELL_LEFT_OUT;
    for (size_t k = 0; k < count; k++)
        for (size_t m = 0; m < maps[k].study->method_count; m++)
            used = used || count_of(&maps[k], m, kind) > 0;
    return used;
}

static size_t method_names(const struct map *maps, size_t count, const char **names)
{
    size_t found = 0;
    for (size_t k = 0; k < count; k++)
        for (size_t m = 0; m < maps[k].study->method_count; m++) {
            const char *name = maps[k].study->methods[m].name;
            size_t i = 0;
            while (i < found && strcmp(names[i], name) != 0)
                i++;
            if (i == found && found < METHODS_MAX)
                names[found++] = name;
        }
    return found;
}

/* "21, 8, 0, 0, 1" of the method of that name; nothing where the map has it not. */
static void write_counts(const struct map *maps, size_t count, size_t k, const char *name, FILE *out)
{
    const struct map *map = &maps[k];
    for (size_t m = 0; m < map->study->method_count; m++)
        for (int kind = 0; kind < CELL_KINDS && strcmp(map->study->methods[m].name, name) == 0; kind++)
            if (is_used(maps, count, (enum cell_kind)kind))
                fprintf(out, "%s%zu", kind ? ", " : "", count_of(map, m, (enum cell_kind)kind));
}

/* "stable, shortened, stopped ..." */
static void write_kinds(const struct map *maps, size_t count, FILE *out)
{
    for (int kind = 0; kind < CELL_KINDS; kind++)
        if (is_used(maps, count, (enum cell_kind)kind))
            fprintf(out, "%s%s", kind ? ", " : "", cell_looks[kind].name);
}

static void write_markdown(const struct map *maps, const struct study_results *all, size_t count, FILE *out)
{
    const char *names[METHODS_MAX];
    size_t methods = method_names(maps, count, names), cells = 0;
    for (size_t k = 0; k < count; k++)
        cells += maps[k].count;
    summary_about(all, count, out);
    fprintf(out, ": %zu runs. Cells that are ", cells);
    write_kinds(maps, count, out);
    fputs(":\n\n| map |", out);
    for (size_t m = 0; m < methods; m++)
        fprintf(out, " %s |", names[m]);
    fputs("\n|---|", out);
    for (size_t m = 0; m < methods; m++)
        fputs("---|", out);
    for (size_t k = 0; k < count; k++) {
        fputs("\n| ", out);
        text_markdown(maps[k].study->title, out);
        for (size_t m = 0; m < methods; m++) {
            fputs(" | ", out);
            write_counts(maps, count, k, names[m], out);
        }
        fputs(" |", out);
    }
    fputs("\n\n", out);
}

static void write_table(const struct map *maps, size_t count, FILE *out)
{
    const char *names[METHODS_MAX];
    size_t methods = method_names(maps, count, names);
    fputs("<div class=\"wide\"><table><tr><th>map</th>", out);
    for (size_t m = 0; m < methods; m++) {
        fputs("<th>", out);
        html_text(out, names[m]);
        fputs("</th>", out);
    }
    fputs("</tr>\n", out);
    for (size_t k = 0; k < count; k++) {
        fprintf(out, "<tr><td><a href=\"#map-%zu\">", k + 1);
        html_text(out, maps[k].study->title);
        fputs("</a></td>", out);
        for (size_t m = 0; m < methods; m++) {
            fputs("<td>", out);
            write_counts(maps, count, k, names[m], out);
            fputs("</td>", out);
        }
        fputs("</tr>\n", out);
    }
    fputs("</table></div>\n", out);
}

/* What stands below a map: its wrong and stopped cells with their reasons. */
static void write_reasons(const struct map *map, FILE *out)
{
    static const enum cell_kind kinds[] = {CELL_WRONG, CELL_STOPPED, CELL_LATE, CELL_LEFT_OUT};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        for (size_t k = 0, any = 0; k < map->count; k++) {
            const struct map_cell *cell = &map->cells[k];
            char text[700];
            if (cell->kind == kinds[i] && !any++)
                fprintf(out, "<details><summary>%s: %s</summary><ul>\n", cell_looks[kinds[i]].name,
                        cell_looks[kinds[i]].doc);
            if (cell->kind == kinds[i]) {
                snprintf(text, sizeof text, "%s, %s, %s: %s", map->study->methods[cell->method].name,
                         map->study->map[0].labels[cell->x], map->study->map[1].labels[cell->y], cell->why);
                fputs("<li>", out);
                html_text(out, text);
                fputs("</li>\n", out);
            }
            if (any && k + 1 == map->count)
                fputs("</ul></details>\n", out);
        }
}

static enum status write_map(const struct map *map, const struct study_results *results, size_t number,
                             FILE *out, struct error *e)
{
    char path[4096], caption[700];
    fprintf(out, "<h2 id=\"map-%zu\">", number);
    html_text(out, map->study->title);
    fputs("</h2>\n", out);
    snprintf(path, sizeof path, "%s/stability.svg", results->directory);
    snprintf(caption, sizeof caption, "Columns: %s (%s). Rows: %s (%s). %zu runs of %s, %s.", map->study->map[0].name,
             map->study->map[0].key, map->study->map[1].name, map->study->map[1].key, map->count,
             map->study->scene, results->about->date);
    if (access(path, R_OK) == 0) { /* without gnuplot there is none */
        fputs("<figure>", out);
        if (html_svg(out, path, e))
            return e->status;
        fputs("</figure>\n", out);
    }
    fputs("<p>", out);
    html_text(out, caption);
    fputs("</p>\n", out);
    write_reasons(map, out);
    return STATUS_OK;
}

static enum status write_page(const struct map *maps, const struct study_results *all, size_t count,
                              FILE *out, struct error *e)
{
    fputs(opening, out);
    fputs("<p>", out);
    summary_about(all, count, out);
    fputs(". Cells that are ", out);
    write_kinds(maps, count, out);
    fputs(":</p>\n", out);
    write_table(maps, count, out);
    for (size_t k = 0; k < count; k++)
        if (write_map(&maps[k], &all[k], k + 1, out, e))
            return e->status;
    fputs("<h2>Command</h2>\n<p><code>", out);
    html_text(out, all[0].about->command);
    fputs("</code></p></html>\n", out);
    return STATUS_OK;
}

static enum status write_files(const struct map *maps, const struct study_results *all, size_t count,
                               const char *directory, struct error *e)
{
    static const char *const names[] = {"index.html", "summary.md"};
    for (int k = 0; k < 2 && !e->status; k++) {
        char path[4096];
        struct output_file file;
        snprintf(path, sizeof path, "%s/%s", directory, names[k]);
        if (output_open(&file, path, e))
            return e->status;
        if (k == 0)
            write_page(maps, all, count, file.stream, e);
        else
            write_markdown(maps, all, count, file.stream);
        enum status closed = output_close(&file, !e->status, e);
        e->status = e->status ? e->status : closed;
    }
    return e->status;
}

enum status map_index(const struct study_results *all, size_t count, const char *directory,
                      struct error *e)
{
    struct map maps[MAPS_MAX] = {{0}};
    for (size_t k = 0; k < count && !e->status; k++)
        map_make(&maps[k], &all[k], e);
    if (!e->status)
        write_files(maps, all, count, directory, e);
    for (size_t k = 0; k < count; k++)
        map_free(&maps[k]);
    return e->status;
}
