/* Writes files of one frame each that take their names together. */
#include "encode/numbered.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum status numbered_names(struct sequence *names, const struct encode_target *target,
                           const char *ending, struct error *e)
{
    const char *path = target->path;
    if (sequence_read(names, "output", path, e))
        return e->status;
    if (!names->digits && !target->single)
        return error_set(e, STATUS_USAGE, "output \"%s\": each frame would replace the one before; "
                         "write for example %.*s-%%04d%s, or ask for one frame with --at T", path,
                         (int)(strlen(path) - strlen(ending)), path, ending);
    return STATUS_OK;
}

/* The waiting file's name. */
static void staged_name(const struct numbered *numbered, long index, char name[SEQUENCE_NAME + 8])
{
    sequence_name(&numbered->names, index, name, SEQUENCE_NAME);
    strcat(name, ".new");
}

/* Makes room for the number first, so that no file is left that nobody knows of. */
enum status numbered_open(struct numbered *numbered, long index, struct output_file *file,
                          struct error *e)
{
    char name[SEQUENCE_NAME + 8];
    staged_name(numbered, index, name);
    if (numbered->count == numbered->room) {
        size_t room = 2 * numbered->room + 16;
        long *grown = realloc(numbered->frames, room * sizeof *grown);
        if (!grown)
            return error_set(e, STATUS_RUN, "%s: no memory", name);
        numbered->frames = grown;
        numbered->room = room;
    }
    return output_open(file, name, e);
}

enum status numbered_close(struct numbered *numbered, long index, struct output_file *file, bool keep,
                           struct error *e)
{
    enum status status = output_close(file, keep, e);
    if (keep && !status)
        numbered->frames[numbered->count++] = index;
    return status;
}

enum status numbered_end(struct numbered *numbered, bool keep, struct error *e)
{
    enum status status = STATUS_OK;
    char name[SEQUENCE_NAME], staged[SEQUENCE_NAME + 8];
    for (size_t i = 0; i < numbered->count; i++) {
        sequence_name(&numbered->names, numbered->frames[i], name, sizeof name);
        staged_name(numbered, numbered->frames[i], staged);
        if (!keep)
            unlink(staged);
        else if (rename(staged, name))
            status = error_set(e, STATUS_OUTPUT, "%s: %s", name, strerror(errno));
    }
    free(numbered->frames);
    return status;
}
