/* Finds out what a path names, and which sources go together. */
#include "compare/source.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

extern const struct source_row source_files, source_film;

static bool is_png(const char *path)
{
    static const unsigned char signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
    unsigned char start[8] = {0};
    FILE *file = fopen(path, "rb");
    bool is = file && fread(start, 1, 8, file) == 8 && memcmp(start, signature, 8) == 0;
    if (file)
        fclose(file);
    return is;
}

enum status source_find(enum source_kind *kind, const char *path, struct error *e)
{
    struct stat info;
    if (stat(path, &info) == 0) {
        const char *dot = strrchr(path, '.');
        bool png = is_png(path) || (dot && strcasecmp(dot, ".png") == 0);
        *kind = S_ISDIR(info.st_mode) ? SOURCE_NAMED : png ? SOURCE_PICTURE : SOURCE_FILM;
        return STATUS_OK;
    }
    if (errno != ENOENT && errno != ENOTDIR)
        return error_set(e, STATUS_USAGE, "cannot read %s: %s", path, strerror(errno));
    if (strchr(path, '%'))
        *kind = SOURCE_SEQUENCE;
    else if (strpbrk(path, "*?["))
        *kind = SOURCE_NAMED;
    else
        return error_set(e, STATUS_USAGE, "cannot read %s: there is no such file or directory", path);
    return STATUS_OK;
}

enum status source_order(enum source_order *order, const enum source_kind *kinds, size_t count,
                         struct error *e)
{
    size_t of[SOURCE_FILM + 1] = {0};
    for (size_t i = 0; i < count; i++)
        of[kinds[i]]++;
    if (of[SOURCE_PICTURE] == count)
        *order = SOURCE_ALONE;
    else if (of[SOURCE_PICTURE])
        return error_set(e, STATUS_USAGE, "a picture can be compared with pictures only, not with a "
                         "set or a film");
    else if (of[SOURCE_NAMED] == 0)
        *order = SOURCE_BY_NUMBER;
    else if (of[SOURCE_FILM])
        return error_set(e, STATUS_USAGE, "a film can be compared with films and numbered pictures "
                         "such as 'x-%%04d.png' only");
    else
        *order = SOURCE_BY_NAME;
    return STATUS_OK;
}

enum status source_open(struct source *source, const char *path, enum source_kind kind,
                        enum source_order order, struct error *e)
{
    *source = (struct source){.row = kind == SOURCE_FILM ? &source_film : &source_files,
                              .path = path};
    if (source->row->open(source, kind, order, e) == STATUS_OK)
        return STATUS_OK;
    source_close(source);
    return e->status;
}

void source_close(struct source *source)
{
    if (source->row)
        source->row->close(source);
    *source = (struct source){0};
}

int source_compare(const struct source *a, const struct source *b, enum source_order order)
{
    if (a->ended || b->ended)
        return a->ended - b->ended;
    if (order == SOURCE_BY_NAME)
        return strcmp(a->name, b->name);
    return order == SOURCE_BY_NUMBER ? (a->number > b->number) - (a->number < b->number) : 0;
}
