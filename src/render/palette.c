/* The colours of a film: a map of the table or of the scene's own file. */
#include "render/palette.h"

#include "render/render.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS_MIN = 2, ROWS_MAX = 256, LINE_SIZE = 256 };

struct map_file {
    const char *path;
    struct error *e;
    int line;
    int count;
    double rows[ROWS_MAX][3]; /* as written; of #rrggbb 0..255 */
    int first[ROWS_MAX];      /* line of each */
    bool whole;               /* some component is above 1: all are 0..255 */
};

static enum status file_fail(const struct map_file *f, const char *line, const char *at,
                             const char *why)
{
    return error_set(f->e, STATUS_USAGE, "%s:%d:%d: %s; a line is \"red green blue\", each 0 to 1 or 0 "
                     "to 255, or \"#rrggbb\"", f->path, f->line, (int)(at - line) + 1, why);
}

static const char *blank_end(const char *text)
{
    return text + strspn(text, " \t");
}

/* "#rrggbb" */
static enum status hex_read(struct map_file *f, const char *line, const char *at, double row[3])
{
    size_t digits = strspn(at + 1, "0123456789abcdefABCDEF");
    if (digits != 6 || *blank_end(at + 7))
        return file_fail(f, line, at, "not six hexadecimal digits alone");
    unsigned long number = strtoul(at + 1, NULL, 16);
    for (int k = 0; k < 3; k++)
        row[k] = (double)(number >> (16 - 8 * k) & 255);
    f->whole = true;
    return STATUS_OK;
}

static enum status numbers_read(struct map_file *f, const char *line, const char *at, double row[3])
{
    for (int k = 0; k < 3; k++) {
        char *end;
        at = blank_end(at);
        at += k && *at == ',' ? 1 : 0;
        at = blank_end(at);
        row[k] = strtod(at, &end);
        if (end == at)
            return file_fail(f, line, at, *at ? "not a number" : "fewer than three numbers");
        if (!(row[k] >= 0 && row[k] <= 255))
            return file_fail(f, line, at, "not from 0 to 255");
        f->whole |= row[k] > 1;
        at = end;
    }
    at = blank_end(at);
    return *at ? file_fail(f, line, at, "more than three numbers") : STATUS_OK;
}

/* Empty lines, and those that begin with "//", say nothing. */
static enum status line_read(struct map_file *f, char *line)
{
    const char *at;
    f->line++;
    if (strlen(line) == LINE_SIZE - 1)
        return file_fail(f, line, line, "the line is too long");
    line[strcspn(line, "\r\n")] = '\0';
    at = blank_end(line);
    if (!*at || strncmp(at, "//", 2) == 0)
        return STATUS_OK;
    if (f->count == ROWS_MAX)
        return file_fail(f, line, at, "more than 256 colours");
    f->first[f->count] = f->line;
    double *row = f->rows[f->count++];
    return *at == '#' ? hex_read(f, line, at, row) : numbers_read(f, line, at, row);
}

/* In a file of 0..255 every component is whole, so that a file of 0..1 is not taken for one. */
static enum status rows_check(struct map_file *f)
{
    if (f->count < ROWS_MIN)
        return error_set(f->e, STATUS_USAGE, "%s:%d:1: %s; a map has 2 to 256 colours, one a line",
                         f->path, f->line > 0 ? f->line : 1, f->count ? "one colour" : "no colour");
    for (int i = 0; f->whole && i < f->count; i++)
        for (int k = 0; k < 3; k++)
            if (f->rows[i][k] != floor(f->rows[i][k]))
                return error_set(f->e, STATUS_USAGE, "%s:%d:1: %g is not whole, but other colours are "
                                 "0 to 255; use one of 0 to 1 and 0 to 255 throughout", f->path,
                                 f->first[i], f->rows[i][k]);
    return STATUS_OK;
}

/* Between rows colours are mixed. */
static void rows_spread(const struct map_file *f, uint8_t (*rgb)[3])
{
    double full = f->whole ? 1 : 255;
    for (int i = 0; i < MAP_SIZE; i++) {
        double place = i * (f->count - 1.0) / (MAP_SIZE - 1);
        int row = (int)fmin(floor(place), f->count - 2);
        for (int k = 0; k < 3; k++) {
            double low = f->rows[row][k], high = f->rows[row + 1][k];
            rgb[i][k] = (uint8_t)lround(full * (low + (high - low) * (place - row)));
        }
    }
}

enum status palette_read(const char *path, uint8_t (*rgb)[3], struct error *e)
{
    char line[LINE_SIZE];
    struct map_file f = {.path = path, .e = e};
    FILE *in = fopen(path, "r");
    enum status status = STATUS_OK;
    if (!in)
        return error_set(e, STATUS_USAGE, "color.map_file: %s: cannot be read: %s", path,
                         strerror(errno));
    while (!status && fgets(line, sizeof line, in))
        status = line_read(&f, line);
    if (!status && ferror(in))
        status = error_set(e, STATUS_USAGE, "color.map_file: %s: cannot be read: %s", path,
                           strerror(errno));
    fclose(in);
    if (!status)
        status = rows_check(&f);
    if (!status)
        rows_spread(&f, rgb);
    return status;
}

/* Beside the scene file, unless the path is absolute. */
static enum status own_read(const struct scene *scene, uint8_t (*rgb)[3], struct error *e)
{
    char path[sizeof scene->source + KEY_TEXT_SIZE];
    const char *name = scene->color.map_file, *slash = strrchr(scene->source, '/');
    int folder = slash && name[0] != '/' ? (int)(slash + 1 - scene->source) : 0;
    snprintf(path, sizeof path, "%.*s%s", folder, scene->source, name);
    return palette_read(path, rgb, e);
}

enum status palette_make(const struct scene *scene, bool diverging, uint8_t (*rgb)[3],
                         struct error *e)
{
    const struct variant *row = variant_find(&render_maps, scene->color.map);
    const struct render_map *usual = diverging ? &map_coolwarm : &map_viridis;
    if (scene->color.map_file[0]) {
        if (own_read(scene, rgb, e))
            return e->status;
    } else {
        (row ? (const struct render_map *)row : usual)->fill(rgb);
    }
    for (int i = 0; scene->color.reverse && i < MAP_SIZE / 2; i++)
        for (int k = 0; k < 3; k++) {
            uint8_t swap = rgb[i][k];
            rgb[i][k] = rgb[MAP_SIZE - 1 - i][k];
            rgb[MAP_SIZE - 1 - i][k] = swap;
        }
    return STATUS_OK;
}
