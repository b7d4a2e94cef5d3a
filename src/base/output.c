/* Says whether a file can be written, keeps two writers apart, and lets a file appear whole. */
#include "base/output.h"

#include <errno.h>
#include <fcntl.h>
#include <libgen.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

enum status output_check(const char *path, struct error *e)
{
    char copy[PATH_MAX];
    struct stat info;
    if (strlen(path) >= sizeof copy - 16)
        return error_set(e, STATUS_OUTPUT, "output \"%s\": the name is too long", path);
    strcpy(copy, path);
    const char *directory = dirname(copy);
    if (stat(directory, &info))
        return error_set(e, STATUS_OUTPUT, "output \"%s\": directory \"%s\": %s%s", path, directory,
                         strerror(errno), errno == ENOENT ? "; create it first" : "");
    if (!S_ISDIR(info.st_mode))
        return error_set(e, STATUS_OUTPUT, "output \"%s\": \"%s\" is no directory", path,
                         directory);
    if (access(directory, W_OK | X_OK))
        return error_set(e, STATUS_OUTPUT, "output \"%s\": cannot write to directory \"%s\": %s",
                         path, directory, strerror(errno));
    if (stat(path, &info) == 0 && !S_ISREG(info.st_mode))
        return error_set(e, STATUS_OUTPUT, "output \"%s\": exists and is no regular file", path);
    return STATUS_OK;
}

static bool same_inode(const char *a, const char *b)
{
    struct stat one, other;
    return stat(a, &one) == 0 && stat(b, &other) == 0 && one.st_ino == other.st_ino && one.st_dev == other.st_dev;
}

bool output_same(const char *a, const char *b)
{
    char one[PATH_MAX], other[PATH_MAX];
    if (strlen(a) >= sizeof one || strlen(b) >= sizeof other)
        return false;
    if (same_inode(a, b))
        return true;
    bool alike = strcmp(basename(strcpy(one, a)), basename(strcpy(other, b))) == 0;
    return alike && same_inode(dirname(strcpy(one, a)), dirname(strcpy(other, b)));
}

enum status output_make_directories(const char *path, struct error *e)
{
    char copy[PATH_MAX];
    if (strlen(path) >= sizeof copy - 256) /* room for names in it */
        return error_set(e, STATUS_OUTPUT, "directory \"%.100s...\": the name is too long", path);
    strcpy(copy, path);
    for (char *slash = copy; slash;) {
        slash = strchr(slash + 1, '/');
        if (slash)
            *slash = 0;
        if (mkdir(copy, 0777) && errno != EEXIST)
            return error_set(e, STATUS_OUTPUT, "directory \"%s\" cannot be made: %s", copy,
                             strerror(errno));
        if (slash)
            *slash = '/';
    }
    return STATUS_OK;
}

/* The holder before may have removed the file between our opening and locking it. */
static bool still_named(int file, const char *path)
{
    struct stat ours, named;
    return fstat(file, &ours) == 0 && stat(path, &named) == 0 && ours.st_ino == named.st_ino &&
           ours.st_dev == named.st_dev;
}

/* A file system without locks gives no claim, and no error: the run is as safe as it can be. */
enum status output_claim(struct output_claim *claim, const char *path, struct error *e)
{
    *claim = (struct output_claim){NULL, -1};
    if (asprintf(&claim->path, "%s.lock", path) < 0) {
        claim->path = NULL;
        return error_set(e, STATUS_RUN, "%s: no memory", path);
    }
    for (;;) {
        claim->file = open(claim->path, O_RDWR | O_CREAT | O_CLOEXEC, 0666);
        if (claim->file < 0) {
            error_set(e, STATUS_OUTPUT, "%s: %s", claim->path, strerror(errno));
            break;
        }
        bool locked = flock(claim->file, LOCK_EX | LOCK_NB) == 0;
        if (!locked && errno == EWOULDBLOCK) {
            error_set(e, STATUS_OUTPUT, "output \"%s\" is being written already, by another run or "
                      "another -o; wait for it or choose another name", path);
            break;
        }
        if (!locked || still_named(claim->file, claim->path))
            return STATUS_OK;
        close(claim->file);
    }
    if (claim->file >= 0)
        close(claim->file);
    free(claim->path);
    *claim = (struct output_claim){NULL, -1};
    return e->status;
}

void output_release(struct output_claim *claim)
{
    if (!claim->path)
        return;
    unlink(claim->path); /* before the lock ends, so that nobody's later claim is removed */
    close(claim->file);
    free(claim->path);
    *claim = (struct output_claim){NULL, -1};
}

enum status output_open(struct output_file *file, const char *path, struct error *e)
{
    *file = (struct output_file){0};
    if (output_check(path, e)) /* a rename would replace even a device */
        return e->status;
    file->path = strdup(path);
    if (asprintf(&file->part, "%s.part", path) < 0)
        file->part = NULL;
    if (!file->path || !file->part)
        error_set(e, STATUS_RUN, "%s: no memory", path);
    else if ((file->stream = fopen(file->part, "wb")))
        return STATUS_OK;
    else
        error_set(e, STATUS_OUTPUT, "cannot write %s: %s", file->part, strerror(errno));
    free(file->path);
    free(file->part);
    *file = (struct output_file){0};
    return e->status;
}

enum status output_close(struct output_file *file, bool keep, struct error *e)
{
    if (!file->stream)
        return STATUS_OK;
    enum status status = STATUS_OK;
    errno = 0;
    bool good = !keep || (!ferror(file->stream) && fflush(file->stream) == 0 &&
                          fsync(fileno(file->stream)) == 0);
    int why = errno;
    if (!good && why == 0 && write(fileno(file->stream), "", 1) < 0)
        why = errno; /* what stopped an earlier write stops one more: it says why */
    if (fclose(file->stream) != 0 && good && keep) {
        good = false;
        why = errno;
    }
    if (!good)
        status = error_set(e, STATUS_OUTPUT, "cannot write %s: %s", file->part,
                           why ? strerror(why) : "an earlier write failed");
    else if (keep && rename(file->part, file->path) != 0)
        status = error_set(e, STATUS_OUTPUT, "cannot rename %s to %s: %s", file->part, file->path,
                           strerror(errno));
    if (!keep || status)
        unlink(file->part);
    free(file->path);
    free(file->part);
    *file = (struct output_file){0};
    return status;
}
