/* Reads csv files into columns and finds them by name. */
#include "study/reference/columns.h"

#include "base/suggest.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Cuts the next field off a line, without spaces about it; NULL after the last. */
static char *next_field(char **rest)
{
    char *field = *rest;
    if (!field)
        return NULL;
    char *end = field + strcspn(field, ",\r\n");
    *rest = *end == ',' ? end + 1 : NULL;
    *end = 0;
    while (end > field && end[-1] == ' ')
        *--end = 0;
    return field + strspn(field, " ");
}

static enum status memory_short(const char *path, struct error *e)
{
    return error_set(e, STATUS_RUN, "%s: memory is short", path);
}

static enum status read_names(struct columns *c, char *line, const char *path, struct error *e)
{
    size_t most = 1;
    for (const char *p = line; *p; p++)
        most += *p == ',';
    c->names = calloc(most, sizeof *c->names);
    c->values = calloc(most, sizeof *c->values);
    if (!c->names || !c->values)
        return memory_short(path, e);
    for (char *rest = line, *field; (field = next_field(&rest)); c->count++)
        if (!(c->names[c->count] = strdup(field)))
            return memory_short(path, e);
    return STATUS_OK;
}

static enum status read_row(struct columns *c, char *line, size_t *room, const char *path,
                            long number, struct error *e)
{
    if (c->rows == *room) {
        *room = *room ? 2 * *room : 256;
        for (size_t k = 0; k < c->count; k++) {
            double *grown = realloc(c->values[k], *room * sizeof *grown);
            if (!grown)
                return memory_short(path, e);
            c->values[k] = grown;
        }
    }
    size_t k = 0;
    char *field, *end;
    for (char *rest = line; (field = next_field(&rest)); k++) {
        double value = strtod(field, &end);
        if (k < c->count && (end == field || *end))
            return error_set(e, STATUS_USAGE, "%s:%ld: \"%.40s\" in column %zu is no number", path,
                             number, field, k + 1);
        if (k < c->count)
            c->values[k][c->rows] = value;
    }
    if (k != c->count)
        return error_set(e, STATUS_USAGE, "%s:%ld: %zu numbers, but there are names of %zu columns",
                         path, number, k, c->count);
    c->rows++;
    return STATUS_OK;
}

enum status columns_read(struct columns *columns, const char *path, struct error *e)
{
    char *line = NULL;
    size_t size = 0, room = 0;
    enum status status = STATUS_OK;
    *columns = (struct columns){0};
    FILE *file = fopen(path, "r");
    if (!file)
        return error_set(e, STATUS_USAGE, "%s: cannot be opened: %s", path, strerror(errno));
    for (long number = 1; !status && getline(&line, &size, file) > 0; number++) {
        if (line[0] == '#' || line[strspn(line, " \r\n")] == 0)
            continue;
        status = columns->names ? read_row(columns, line, &room, path, number, e)
                                : read_names(columns, line, path, e);
    }
    free(line);
    fclose(file);
    if (!status && !columns->rows)
        status = error_set(e, STATUS_USAGE, "%s: no numbers; give a line of names and then rows of "
                           "numbers, with commas between", path);
    return status;
}

void columns_free(struct columns *columns)
{
    for (size_t k = 0; k < columns->count; k++) {
        free(columns->names[k]);
        free(columns->values[k]);
    }
    free(columns->names);
    free(columns->values);
    *columns = (struct columns){0};
}

const double *columns_find(const struct columns *columns, const char *name)
{
    size_t length = strlen(name);
    for (size_t k = 0; k < columns->count; k++) {
        const char *rest = columns->names[k] + length;
        if (strncmp(columns->names[k], name, length) == 0 &&
            (!*rest || strncmp(rest, " (", 2) == 0))
            return columns->values[k];
    }
    return NULL;
}

const double *columns_need(const struct columns *columns, const char *name, struct error *e)
{
    const double *values = columns_find(columns, name);
    if (values)
        return values;
    struct suggest suggest;
    suggest_start(&suggest, name);
    for (size_t k = 0; k < columns->count; k++) {
        char bare[128];
        snprintf(bare, sizeof bare, "%.*s", (int)strcspn(columns->names[k], " "),
                 columns->names[k]);
        suggest_offer(&suggest, bare);
    }
    const char *best = suggest_best(&suggest);
    error_set(e, STATUS_USAGE, "there is no column \"%s\"%s%s%s", name, best ? "; did you mean \"" : "",
              best ? best : "", best ? "\"?" : "");
    return NULL;
}

const double *columns_time(const struct columns *columns)
{
    return columns->values[0];
}

long columns_row(const struct columns *columns, double time)
{
    const double *times = columns_time(columns);
    double near = 1e-6 * fmax(fabs(time), fabs(times[columns->rows - 1]));
    for (size_t k = 0; k < columns->rows; k++)
        if (fabs(times[k] - time) <= near)
            return (long)k;
    return -1;
}

size_t columns_line(const struct columns *columns, const char *name, const char *part, size_t row,
                    double *out, size_t most)
{
    size_t count = 0;
    for (; count < most; count++) {
        char column[256];
        snprintf(column, sizeof column, "%s.%zu.%s", name, count, part);
        const double *values = columns_find(columns, column);
        if (!values)
            break;
        out[count] = values[row];
    }
    return count;
}

double columns_interpolate(const double *xs, const double *ys, size_t count, double x)
{
    for (size_t k = 1; k < count; k++)
        if (xs[k - 1] <= x && x <= xs[k]) {
            double width = xs[k] - xs[k - 1];
            return width > 0 ? ys[k - 1] + (x - xs[k - 1]) / width * (ys[k] - ys[k - 1]) : ys[k];
        }
    return (double)NAN;
}
