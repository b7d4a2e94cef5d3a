/* Frames from PNG files: one, those of a directory or a glob pattern, or a numbered sequence. */
#include "base/memory.h"
#include "base/sequence.h"
#include "compare/source.h"

#include <dirent.h>
#include <errno.h>
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

struct file {
    char *path;
    const char *name; /* the last part of path */
    long number;
};

struct files {
    struct file *list;
    size_t count, room, next;
};

static const char *last_part(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* Takes `path`, which is on the heap or NULL. */
static enum status add(struct files *files, char *path, long number, struct error *e)
{
    if (path && files->count == files->room) {
        size_t room = 2 * files->room + 64;
        struct file *grown = realloc(files->list, room * sizeof *grown);
        if (!grown) {
            free(path);
            path = NULL;
        } else {
            files->list = grown;
            files->room = room;
        }
    }
    if (!path)
        return error_set(e, STATUS_RUN, "memory is short");
    files->list[files->count++] = (struct file){path, last_part(path), number};
    return STATUS_OK;
}

/* Files "directory/NAME" that are PNG by name and, with a sequence, belong to it. */
static enum status list_directory(struct files *files, const char *directory, const char *prefix,
                                  const struct sequence *sequence, struct error *e)
{
    struct dirent *entry;
    DIR *open = opendir(directory);
    if (!open)
        return error_set(e, STATUS_USAGE, "cannot read directory %s: %s", directory,
                         strerror(errno));
    e->status = STATUS_OK;
    while (!e->status && (entry = readdir(open))) {
        const char *dot = strrchr(entry->d_name, '.');
        char *path = NULL;
        if (entry->d_name[0] == '.' || !dot || strcasecmp(dot, ".png") != 0)
            continue;
        if (asprintf(&path, "%s%s", prefix, entry->d_name) < 0)
            path = NULL;
        long number = path && sequence ? sequence_number(sequence, path) : 0;
        if (number < 0)
            free(path);
        else
            add(files, path, number, e);
    }
    closedir(open);
    return e->status;
}

static enum status list_glob(struct files *files, const char *pattern, struct error *e)
{
    glob_t found;
    int code = glob(pattern, GLOB_ERR | GLOB_NOSORT, NULL, &found);
    e->status = STATUS_OK;
    if (code && code != GLOB_NOMATCH)
        return error_set(e, code == GLOB_NOSPACE ? STATUS_RUN : STATUS_USAGE, "cannot look for %s",
                         pattern);
    for (size_t i = 0; !code && !e->status && i < found.gl_pathc; i++)
        add(files, strdup(found.gl_pathv[i]), 0, e);
    if (!code)
        globfree(&found);
    return e->status;
}

static enum status list_sequence(struct files *files, const char *path, struct error *e)
{
    struct sequence sequence;
    if (sequence_read(&sequence, "pictures", path, e))
        return e->status;
    size_t length = (size_t)(last_part(sequence.before) - sequence.before);
    char *prefix = strndup(sequence.before, length);
    if (!prefix)
        return error_set(e, STATUS_RUN, "memory is short");
    list_directory(files, length ? prefix : ".", prefix, &sequence, e);
    free(prefix);
    return e->status;
}

static enum status list(struct files *files, const char *path, enum source_kind kind,
                        struct error *e)
{
    char *prefix = NULL;
    struct stat info;
    if (kind == SOURCE_PICTURE)
        return add(files, strdup(path), 0, e);
    if (kind == SOURCE_SEQUENCE)
        return list_sequence(files, path, e);
    if (stat(path, &info) != 0)
        return list_glob(files, path, e);
    if (asprintf(&prefix, "%s/", path) < 0)
        return error_set(e, STATUS_RUN, "memory is short");
    list_directory(files, path, prefix, NULL, e);
    free(prefix);
    return e->status;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(((const struct file *)a)->name, ((const struct file *)b)->name);
}

static int by_number(const void *a, const void *b)
{
    long x = ((const struct file *)a)->number, y = ((const struct file *)b)->number;
    return (x > y) - (x < y);
}

static void set_head(struct source *source)
{
    const struct files *files = source->state;
    source->ended = files->next == files->count;
    if (source->ended)
        return;
    source->number = files->list[files->next].number;
    snprintf(source->name, sizeof source->name, "%s", files->list[files->next].name);
}

/* Files of one name in several directories of a glob pattern could not be told apart. */
static enum status check_twins(const struct files *files, struct error *e)
{
    for (size_t i = 1; i < files->count; i++)
        if (by_name(&files->list[i - 1], &files->list[i]) == 0)
            return error_set(e, STATUS_USAGE, "%s and %s have the same name; compare their "
                             "directories one by one", files->list[i - 1].path, files->list[i].path);
    return STATUS_OK;
}

static enum status files_open(struct source *source, enum source_kind kind,
                              enum source_order order, struct error *e)
{
    struct files *files = memory_create("compare", 1, sizeof *files, e);
    source->state = files;
    if (!files || list(files, source->path, kind, e))
        return e->status;
    if (!files->count)
        return error_set(e, STATUS_USAGE, "%s: there are no PNG pictures", source->path);
    qsort(files->list, files->count, sizeof *files->list,
          order == SOURCE_BY_NUMBER ? by_number : by_name);
    if (order == SOURCE_BY_NAME && check_twins(files, e))
        return e->status;
    set_head(source);
    return STATUS_OK;
}

static enum status files_next(struct source *source, struct error *e)
{
    (void)e;
    ((struct files *)source->state)->next++;
    set_head(source);
    return STATUS_OK;
}

static enum status files_read(struct source *source, struct image *image, struct error *e)
{
    const struct files *files = source->state;
    image_free(image);
    return image_read_png(image, files->list[files->next].path, e);
}

static void files_close(struct source *source)
{
    struct files *files = source->state;
    for (size_t i = 0; files && i < files->count; i++)
        free(files->list[i].path);
    if (files)
        free(files->list);
    memory_free(files);
}

extern const struct source_row source_files;
const struct source_row source_files = {files_open, files_next, files_read, files_close};
