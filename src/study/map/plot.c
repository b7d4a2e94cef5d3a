/* Draws a stability map by gnuplot. */
#include "study/map/map.h"

#include "base/log.h"
#include "base/output.h"
#include "study/gnuplot.h"

#include <math.h>
#include <string.h>

/* Of the figure in pixels: 600 are a column of 85 mm at 180 a inch. */
enum { WIDTH = 600, LEFT = 112, RIGHT = 12, TOP = 58, TITLE = 22, CELL = 30, BOTTOM = 58 };

/* Curves that tell apart in grey, by enum limit. */
static const struct curve {
    int limit, dash;
    const char *title;
} curves[] = {
    {LIMIT_ACOUSTIC, 1, "acoustic"}, {LIMIT_VISCOUS, 2, "viscous"},  {LIMIT_CAPILLARY, 3, "capillary"},
    {LIMIT_SPEED, 4, "speed"},       {LIMIT_FORCE, 5, "force"},      {LIMIT_DAMPING, 6, "damping"},
};
enum { CURVES = sizeof curves / sizeof *curves };

/* Where the columns are ascending steps. */
static bool has_curves(const struct map *map)
{
    bool has = strcmp(map->study->map[0].key, "time.step") == 0 && map->columns > 1;
    for (size_t k = 1; k < map->columns; k++)
        has = has && map->cells[k].step > map->cells[k - 1].step;
    return has;
}

/* Where a step lies among the columns, which are numbered from 0: between two by its logarithm. */
static double column_of(const struct map *map, double step)
{
    size_t k = 0;
    const struct map_cell *row = map->cells;
    while (k + 2 < map->columns && row[k + 1].step < step)
        k++;
    return (double)k + log(step / row[k].step) / log(row[k + 1].step / row[k].step);
}

/* Whether the limit is in the picture somewhere. */
static bool is_seen(const struct map *map, int limit)
{
    for (size_t row = 0; row < map->rows * map->study->method_count && has_curves(map); row++) {
        double step = map_limit(map, row / map->rows, row % map->rows, limit);
        double at = step > 0 && isfinite(step) ? column_of(map, step) : -1;
        if (at > -0.5 && at < (double)map->columns - 0.5)
            return true;
    }
    return false;
}

/* "3" of a cell whose steps are three times shorter than asked, "1" where only some were rejected. */
static void write_mark(const struct map_cell *cell, FILE *out)
{
    double times = cell->steps / cell->fewest;
    if (cell_looks[cell->kind].mark)
        fprintf(out, "\"%s\"", cell_looks[cell->kind].mark);
    else if (isnan(times))
        fputs("\"r\"", out);
    else
        fprintf(out, "\"÷%.*f\"", times < 9.95, times);
}

/* A block of cells for each method; then for each method and curve a block of its points. */
static void write_data(const struct map *map, FILE *out)
{
    size_t cells = map->columns * map->rows;
    fputs("# column, row, colours of cell and mark, mark, kind\n", out);
    for (size_t k = 0; k < map->count; k++) {
        const struct map_cell *cell = &map->cells[k];
        if (k > 0 && k % cells == 0)
            fputs("\n\n", out);
        fprintf(out, "%zu %zu 0x%s %s ", cell->x, cell->y, cell_looks[cell->kind].color + 1,
                cell->kind == CELL_WRONG ? "0xFFFFFF" : "0x000000");
        write_mark(cell, out);
        fprintf(out, " %d\n", cell->kind);
    }
    for (size_t m = 0; m < map->study->method_count; m++)
        for (int k = 0; k < CURVES; k++) {
            fprintf(out, "\n\n# %s: %s limit (s)\n", map->study->methods[m].name, curves[k].title);
            for (size_t row = 0; row < map->rows; row++) {
                double step = map_limit(map, m, row, curves[k].limit);
                if (has_curves(map) && step > 0 && isfinite(step))
                    fprintf(out, "%.4f %zu %.6g\n", column_of(map, step), row, step);
                else
                    fprintf(out, "NaN %zu NaN\n", row);
            }
        }
}

/* A text of the study as gnuplot reads it. */
static void write_text(const char *before, const char *text, const char *after, FILE *out)
{
    fprintf(out, "%s'", before);
    for (; *text; text++)
        if ((unsigned char)*text >= ' ')
            fprintf(out, *text == '\'' ? "''" : "%c", *text);
    fprintf(out, "'%s", after);
}

static void write_tics(const struct study_ladder *ladder, const char *axis, FILE *out)
{
    char place[32];
    fprintf(out, "set %stics (", axis);
    for (size_t k = 0; k < ladder->count; k++) {
        snprintf(place, sizeof place, " %zu", k);
        write_text(k ? ", " : "", ladder->labels[k], place, out);
    }
    fputs(") scale 0 nomirror\n", out);
}

/* A curve on a white rim, so that it is seen on every colour. */
static void write_curve(size_t block, const struct curve *curve, FILE *out)
{
    fprintf(out, ", \\\n  'stability.dat' index %zu using 1:2 with lines lw 5 lc rgb 'white' notitle"
                 ", \\\n  '' index %zu using 1:2 with lines lw 2 dt %d lc rgb 'black' notitle",
            block, block, curve->dash);
}

static void write_key(const struct map *map, FILE *out)
{
    for (int kind = 0; kind < CELL_KINDS; kind++) {
        bool any = false;
        for (size_t k = 0; k < map->count; k++)
            any = any || (int)map->cells[k].kind == kind;
        if (any)
            fprintf(out, ", \\\n  NaN with boxes fs solid 1 border lc rgb 'black' fc rgb '%s' title '%s%s%s'",
                    cell_looks[kind].color, cell_looks[kind].name,
                    kind == CELL_SHORTENED ? " ÷n" : cell_looks[kind].mark[0] ? " " : "",
                    kind == CELL_SHORTENED ? "" : cell_looks[kind].mark);
    }
    for (int k = 0; k < CURVES; k++)
        if (is_seen(map, curves[k].limit))
            fprintf(out, ", \\\n  NaN with lines lw 2 dt %d lc rgb 'black' title '%s limit'", curves[k].dash,
                    curves[k].title);
}

static void write_panel(const struct map *map, size_t method, double height, FILE *out)
{
    size_t methods = map->study->method_count;
    double panel = (double)map->rows * CELL;
    double top = TOP + (double)method * (panel + TITLE) + TITLE;
    bool last = method + 1 == methods;
    fprintf(out, "set tmargin at screen %.5f\nset bmargin at screen %.5f\n", 1 - top / height,
            1 - (top + panel) / height);
    write_text("set label 1 ", map->study->methods[method].name,
               " at graph 0, 1 offset 0, 0.7 left\n", out);
    if (last) {
        write_tics(&map->study->map[0], "x", out);
        write_text("set xlabel ", map->study->map[0].name, "\n", out);
    }
    fputs(method == 0 ? "set key at screen 0.5, 0.995 center top horizontal samplen 4 maxcols 3 maxrows 3\n"
                      : "unset key\n", out);
    fprintf(out, "plot 'stability.dat' index %zu using 1:2:(0.47):(0.44):3 with boxxyerror fs solid 1 "
                 "noborder lc rgb variable notitle", method);
    for (int k = 0; k < CURVES && has_curves(map); k++)
        if (is_seen(map, curves[k].limit))
            write_curve(methods + method * CURVES + (size_t)k, &curves[k], out);
    fprintf(out, ", \\\n  'stability.dat' index %zu using 1:($6 == %d ? 1/0 : $2):5:4 with labels tc rgb variable "
                 "notitle, \\\n  '' index %zu using 1:($6 == %d ? $2 : 1/0):5 with labels boxed notitle",
            method, CELL_SHORTENED, method, CELL_SHORTENED);
    if (method == 0)
        write_key(map, out);
    fputs("\nunset label 2\n", out);
}

static void write_script(const struct map *map, FILE *out)
{
    const struct study_ladder *axes = map->study->map;
    size_t methods = map->study->method_count;
    double height = TOP + BOTTOM + (double)methods * ((double)map->rows * CELL + TITLE);
    static const char *const terminals[] = {"pngcairo", "svg"}, *const names[] = {"png", "svg"};
    fprintf(out, "# gnuplot stability.gp, in this directory: the figure of the stability map\n");
    fputs("set encoding utf8\n", out);
    for (int k = 0; k < 2; k++) {
        fprintf(out, "set terminal %s size %d, %.0f font 'sans,%d' background rgb 'white' noenhanced\n", terminals[k],
                WIDTH, height, k ? 13 : 10);
        fprintf(out, "set output 'stability.%s'\nset multiplot\nset border 0\n"
                     "set style textbox opaque fillcolor rgb '%s' noborder margins 0.5, 0.2\n",
                names[k], cell_looks[CELL_SHORTENED].color);
        fprintf(out, "set lmargin at screen %.5f\nset rmargin at screen %.5f\n",
                (double)LEFT / WIDTH, 1 - (double)RIGHT / WIDTH);
        fprintf(out, "set xrange [-0.5:%zu.5]\nset yrange [-0.5:%zu.5]\n",
                map->columns - 1, map->rows - 1);
        write_text("set label 2 ", axes[1].name, " at screen 0.025, screen 0.5 rotate by 90 center\n", out);
        fputs("unset xlabel\nunset ylabel\nset format x ''\nset xtics scale 0 format ''\n", out);
        write_tics(&axes[1], "y", out);
        for (size_t m = 0; m < methods; m++)
            write_panel(map, m, height, out);
        fputs("unset multiplot\nunset label\n", out);
    }
    fputs("unset output\n", out);
}

enum status map_plot(const struct map *map, const char *directory, bool *drawn, struct error *e)
{
    static const char *const names[] = {"stability.dat", "stability.gp"};
    static void (*const write[])(const struct map *, FILE *) = {write_data, write_script};
    struct process_end end;
    char log[4096];
    for (int k = 0; k < 2; k++) {
        char path[4096];
        struct output_file file;
        snprintf(path, sizeof path, "%s/%s", directory, names[k]);
        if (output_open(&file, path, e))
            return e->status;
        write[k](map, file.stream);
        if (output_close(&file, true, e))
            return e->status;
    }
    *drawn = gnuplot_found();
    if (!*drawn) {
        log_info("%s: no figure, because there is no gnuplot (Debian's gnuplot-nox); the same command "
                 "draws it once it is there, or `gnuplot stability.gp` in the directory", directory);
        return STATUS_OK;
    }
    snprintf(log, sizeof log, "%s/stability.log", directory);
    if (gnuplot_run("stability.gp", directory, log, &end, e))
        return e->status;
    if (end.code)
        return error_set(e, STATUS_OUTPUT, "%s: gnuplot ended with exit code %d, and says why in %s",
                         directory, end.code, log);
    return STATUS_OK;
}
