/* A figure as a script for gnuplot: as wide as a column of a paper, 85 mm at 300 dots per inch. */
#include "study/products/plot_script.h"

#include "base/memory.h"
#include "base/output.h"
#include "study/products/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 1004, HEIGHT = 730, LINE = 40, NAME_MOST = 46 };

/* Okabe & Ito 2008, without yellow: told apart with every kind of colour vision. Seven colours and
 * twelve marks have no common factor, so 84 methods differ in both. */
static const char *const colors[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                     "#e69f00", "#56b4e9", "#000000"};
static const int shapes[] = {7, 5, 9, 13, 11, 15, 6, 4, 8, 12, 10, 14};

struct script {
    const struct study_results *results;
    const struct figure *figure;
    const struct figure_view *view;
    FILE *out;
    size_t entries; /* of the key */
    bool shown[256]; /* methods that have marks */
};

static size_t method_place(const struct script *s, const struct study_point *point)
{
    return (size_t)(point->method - s->results->study->methods);
}

static const char *method_color(size_t place)
{
    return colors[place % (sizeof colors / sizeof *colors)];
}

static int method_shape(size_t place)
{
    return shapes[place % (sizeof shapes / sizeof *shapes)];
}

/* 'It''s', at most `most` letters of it. */
static void write_quoted(const char *text, size_t most, FILE *out)
{
    size_t letters = 0;
    fputc('\'', out);
    for (; *text; text++) {
        letters += ((unsigned char)*text & 0xc0) != 0x80;
        if (letters > most) {
            fputs("…", out);
            break;
        }
        if (*text == '\'')
            fputc('\'', out);
        fputc(*text, out);
    }
    fputc('\'', out);
}

/* The next entry of the plot command; what it says in the key is to follow. */
static void begin_entry(struct script *s)
{
    fputs(s->entries++ ? ", \\\n  " : "plot ", s->out);
}

static void write_title(struct script *s, const char *text)
{
    fputs(" title ", s->out);
    write_quoted(text, NAME_MOST, s->out);
    fputs(" noenhanced", s->out);
}

static void say_in_key(struct script *s, const char *style, const char *text)
{
    begin_entry(s);
    fprintf(s->out, "keyentry with %s", style);
    write_title(s, text);
}

/* A vertical line at an error, or a shade up to it, if the axis has it. */
static void write_limit(struct script *s, int number, double value, const char *color)
{
    const struct figure_axis *x = &s->view->x;
    if (isnan(value) || value <= x->from || s->figure->kind == FIGURE_VALUE)
        return;
    if (color)
        fprintf(s->out, "set object %d rectangle from graph 0, graph 0 to first %.9g, graph 1 behind "
                        "fillcolor rgb '%s' fillstyle solid noborder\n",
                number, fmin(value, x->to), color);
    else if (value < x->to)
        fprintf(s->out, "set arrow %d from first %.9g, graph 0 to first %.9g, graph 1 nohead "
                        "dashtype (12, 8) linewidth 3 linecolor rgb '#444444'\n",
                number, value, value);
}

/* Its line in the key. */
static void say_limit(struct script *s, double value, const char *what, const char *style)
{
    char text[160], number[64];
    const struct figure_axis *x = &s->view->x;
    double scaled = s->figure->of ? value * text_scale(s->figure->of->unit) : value;
    if (isnan(value) || scaled <= x->from || s->figure->kind == FIGURE_VALUE)
        return;
    text_error(value, s->figure->of ? s->figure->of->unit : "", number, sizeof number);
    snprintf(text, sizeof text, "%s%s%s", what, number, scaled < x->to ? "" : ", beyond the right edge");
    say_in_key(s, style, text);
}

#define SPREAD_COLOR "#e3e3e3"
#define FLOOR_COLOR  "#c4c4c4"

static void write_limits(struct script *s)
{
    const struct study_error *of = s->figure->of;
    if (!of)
        return;
    double scale = text_scale(of->unit);
    write_limit(s, 1, of->spread * scale, SPREAD_COLOR);
    write_limit(s, 2, s->results->study->floor * scale, FLOOR_COLOR);
    write_limit(s, 3, of->asked * scale, NULL);
}

static void write_labels(struct script *s, const enum label_side *sides)
{
    static const char *const how[] = {[LABEL_RIGHT] = "left offset 1,0", [LABEL_LEFT] = "right offset -1,0",
                                      [LABEL_ABOVE] = "center offset 0,0.8",
                                      [LABEL_BELOW] = "center offset 0,-0.8"};
    for (size_t k = 0; k < s->view->count; k++) {
        const struct figure_mark *mark = &s->view->marks[k];
        size_t place = method_place(s, mark->point);
        char text[32];
        text_value(mark->point->ladder->labels[mark->point->rung], text, sizeof text);
        if (sides[k] == LABEL_NONE || !text[0] || s->figure->kind == FIGURE_VALUE)
            continue;
        fprintf(s->out, "set label ");
        write_quoted(text, NAME_MOST, s->out);
        fprintf(s->out, " at %.9g, %.9g %s noenhanced textcolor rgb '%s' font ',19'\n", mark->x, mark->y,
                how[sides[k]], method_color(place));
    }
}

/* "text" in as many lines as it takes. */
static void write_name(struct script *s, char letter, const char *text)
{
    size_t letters = 0;
    fprintf(s->out, "set %clabel \"", letter);
    for (; *text; text++) {
        size_t word = strcspn(text + 1, " ");
        if (*text == ' ' && letters + word >= NAME_MOST) {
            fputs("\\n", s->out);
            letters = 0;
            continue;
        }
        letters++;
        fprintf(s->out, *text == '"' || *text == '\\' ? "\\%c" : "%c", *text);
    }
    fputs(letter == 'x' ? "\\n\" noenhanced\n" : "\" noenhanced\n", s->out); /* room above the key */
}

static void write_axes(struct script *s)
{
    char text[256];
    const struct figure_view *v = s->view;
    const struct study_error *of = s->figure->of;
    const struct study_ladder *ladder = s->figure->ladder;
    fprintf(s->out, "set logscale %s\nset xrange [%.9g:%.9g]\nset yrange [%.9g:%.9g]\n",
            v->x.rungs ? "y" : "xy", v->x.from, v->x.to, v->y.from, v->y.to);
    figure_tics(s->figure, &v->x, 'x', s->out);
    figure_tics(s->figure, &v->y, 'y', s->out);
    if (s->figure->kind == FIGURE_VALUE)
        snprintf(text, sizeof text, "%s", figure_key(ladder));
    else
        snprintf(text, sizeof text, "error: %s%s%s", of ? of->name : "", of && of->unit[0] ? ", " : "",
                 of ? of->unit : "");
    write_name(s, 'x', text);
    if (s->figure->kind == FIGURE_VALUE && ladder->steps > 0)
        snprintf(text, sizeof text, "wall time for %.0f steps, s", ladder->steps);
    else
        snprintf(text, sizeof text, s->figure->kind == FIGURE_PAIRS ? "evaluated pairs" : "wall time, s");
    write_name(s, 'y', text);
    if (v->failures)
        fputs("set arrow from graph 0, graph 0.88 to graph 1, graph 0.88 nohead linewidth 1.5 linecolor "
              "rgb '#bbbbbb'\n", s->out);
}

/* Of all that the key may say, for the height of the picture. */
static size_t key_lines(const struct script *s)
{
    size_t count = 7 + (s->figure->kind == FIGURE_VALUE ? s->figure->ladder->other_count : 0);
    for (size_t m = 0; m < sizeof s->shown; m++)
        count += s->shown[m];
    return count;
}

static void write_head(struct script *s)
{
    fprintf(s->out,
            "# gnuplot %s.gp, in this directory, makes %s.png and %s.svg of %s.dat.\n"
            "set encoding utf8\n"
            "set border linewidth 2 linecolor rgb '#333333'\nset tics nomirror scale 0.8, 0.4\n"
            "set grid xtics ytics linetype 1 linewidth 1 linecolor rgb '#ececec'\n"
            "set key outside below center Left reverse maxcols 1 samplen 2 spacing 1.1 width 0 "
            "noenhanced\n"
            "width = %d; lines = %zu; height = %d + %d * lines\n",
            s->figure->stem, s->figure->stem, s->figure->stem, s->figure->stem, WIDTH,
            key_lines(s), HEIGHT, LINE);
}

/* From the least to the most of the seeds. */
static void plot_bars(struct script *s, size_t block, const char *color)
{
    bool any = false;
    for (size_t k = 0; k < s->view->count; k++)
        any = any || !isnan(s->view->marks[k].high);
    if (!any)
        return;
    begin_entry(s);
    fprintf(s->out, "data index %zu using 1:2:5:6 with xerrorbars linewidth 2 pointtype 0 linecolor rgb '%s' notitle",
            block, color);
}

static void plot_methods(struct script *s)
{
    size_t block = 0;
    for (size_t m = 0; m < s->results->study->method_count && m < sizeof s->shown; m++) {
        char style[160];
        bool has_block = false;
        for (size_t k = 0; k < s->view->count; k++)
            has_block = has_block || (method_place(s, s->view->marks[k].point) == m &&
                                      !s->view->marks[k].failed);
        snprintf(style, sizeof style, "linespoints linewidth 4 pointtype %d pointsize mark linecolor "
                 "rgb '%s'", method_shape(m), method_color(m));
        if (has_block) {
            begin_entry(s);
            fprintf(s->out, "data index %zu using 1:2 with %s", block++, style);
            write_title(s, s->results->study->methods[m].name);
            plot_bars(s, block - 1, method_color(m));
        } else if (s->shown[m]) {
            say_in_key(s, style, s->results->study->methods[m].name);
        }
    }
    if (s->figure->kind != FIGURE_VALUE && block) {
        begin_entry(s);
        fprintf(s->out, "data index %zu using 1:2 with linespoints linewidth 2 pointtype 6 pointsize ring "
                        "linecolor rgb '#777777'", block);
        write_title(s, s->figure->kind == FIGURE_PAIRS ? "front: none errs less with fewer pairs"
                                                       : "front: none errs less in less time");
    }
}

/* From each method's first point on, time by threads falls by the threads. */
static void plot_ideal(struct script *s)
{
    bool said = false;
    const struct study_method *last = NULL;
    for (size_t k = 0; k < s->view->count; k++) {
        const struct figure_mark *mark = &s->view->marks[k];
        if (mark->failed || mark->point->method == last)
            continue;
        last = mark->point->method;
        begin_entry(s);
        fprintf(s->out, "(x >= %.9g ? %.9g / x : NaN) with lines dashtype (10, 8) linewidth 2 linecolor "
                        "rgb '#999999'", mark->x, mark->x * mark->y);
        if (said)
            fputs(" notitle", s->out);
        else
            write_title(s, "ideal: by the number of threads");
        said = true;
    }
}

/* Other programs' times, at the rungs that they are known of. */
static void write_others(struct script *s)
{
    const struct study_ladder *ladder = s->figure->ladder;
    for (size_t o = 0; o < ladder->other_count && s->figure->kind == FIGURE_VALUE; o++) {
        fprintf(s->out, "$other%zu << END\n", o);
        for (size_t k = 0; k < ladder->count; k++) {
            double x = s->view->x.rungs ? (double)k + 1 : strtod(ladder->labels[k], NULL);
            if (!isnan(ladder->others[o].seconds[k]))
                fprintf(s->out, "%.9g %.9g\n", x, ladder->others[o].seconds[k]);
        }
        fputs("END\n", s->out);
    }
}

static void plot_others(struct script *s)
{
    const struct study_ladder *ladder = s->figure->ladder;
    for (size_t o = 0; o < ladder->other_count && s->figure->kind == FIGURE_VALUE; o++) {
        size_t look = s->results->study->method_count + o;
        begin_entry(s);
        fprintf(s->out, "$other%zu using 1:2 with linespoints dashtype (8, 8) linewidth 2 pointtype %d "
                        "pointsize 0.7 * mark linecolor rgb '%s'", o, method_shape(look), method_color(look));
        write_title(s, ladder->others[o].name);
    }
}

static void plot_failures(struct script *s)
{
    bool said = false;
    for (size_t k = 0; k < s->view->count; k++) {
        const struct figure_mark *mark = &s->view->marks[k];
        if (!mark->failed)
            continue;
        begin_entry(s);
        fprintf(s->out, "'+' every ::0::0 using (%.9g):(%.9g) with points pointtype 2 pointsize mark "
                        "linewidth 6 linecolor rgb '%s' notitle",
                mark->x, mark->y, method_color(method_place(s, mark->point)));
        if (!said)
            say_in_key(s, "points pointtype 2 pointsize mark linewidth 6 linecolor rgb '#444444'",
                       "stopped, late or crashed: no error");
        said = true;
    }
}

static void plot_all(struct script *s)
{
    char text[160];
    const struct study_error *of = s->figure->of;
    const struct study_ladder *ladder = s->figure->ladder;
    bool work = s->figure->kind != FIGURE_VALUE;
    fprintf(s->out, "data = '%s.dat'\n", s->figure->stem);
    plot_methods(s);
    plot_others(s);
    if (!work && strcmp(ladder->key, "threads") == 0 && !s->view->x.rungs)
        plot_ideal(s);
    plot_failures(s);
    if (work && of) {
        say_limit(s, of->asked, "asked: at most ",
                  "lines dashtype (12, 8) linewidth 3 linecolor rgb '#444444'");
        say_limit(s, of->spread, "spread of experiments: ",
                  "boxes fillstyle solid noborder linecolor rgb '" SPREAD_COLOR "'");
        say_limit(s, s->results->study->floor, "float32 cannot tell below ",
                  "boxes fillstyle solid noborder linecolor rgb '" FLOOR_COLOR "'");
    }
    if (work && s->results->study->seeds > 1) {
        snprintf(text, sizeof text, "bars: least to most of %d seeds", s->results->study->seeds);
        say_in_key(s, "lines linewidth 2 linecolor rgb '#444444'", text);
    }
    if (work && ladder->key[0]) {
        snprintf(text, sizeof text, "numbers: %s", ladder->key);
        say_in_key(s, "dots linecolor rgb '#ffffff'", text);
    }
    fputc('\n', s->out);
}

static void write_script(struct script *s, const enum label_side *sides)
{
    const char *stem = s->figure->stem;
    for (size_t k = 0; k < s->view->count; k++) {
        size_t place = method_place(s, s->view->marks[k].point);
        if (place < sizeof s->shown)
            s->shown[place] = true;
    }
    write_head(s);
    write_axes(s);
    write_limits(s);
    write_labels(s, sides);
    write_others(s);
    fprintf(s->out, "set terminal pngcairo size width, height font 'sans,24' rounded\n"
                    "set output '%s.png'\nmark = 2.6; ring = 4.6\n", stem);
    plot_all(s);
    fprintf(s->out, "set terminal svg size 0.75 * width, 0.75 * height + 9 * lines font 'sans,24' rounded background "
                    "'#ffffff'\nset output '%s.svg'\nmark = 0.85; ring = 1.5\nreplot\nunset output\n", stem);
}

enum status plot_script(const struct study_results *results, const struct figure *figure,
                        const struct figure_view *view, struct error *e)
{
    char path[4096];
    struct output_file file;
    struct script script = {.results = results, .figure = figure, .view = view};
    enum label_side *sides = memory_create("study labels", view->count + 1, sizeof *sides, e);
    if (!sides)
        return e->status;
    figure_labels(view, sides);
    plot_path(results, figure, "gp", path, sizeof path);
    if (output_open(&file, path, e) == STATUS_OK) {
        script.out = file.stream;
        write_script(&script, sides);
        output_close(&file, true, e);
    }
    memory_free(sides);
    return e->status;
}
