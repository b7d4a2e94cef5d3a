/* Reads and makes the names of numbered frames. */
#include "base/sequence.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static enum status fault(const char *what, const char *path, const char *why, struct error *e)
{
    return error_set(e, STATUS_USAGE, "%s \"%s\": %s; write for example x-%%04d.png", what, path,
                     why);
}

/* Reads %d or %0Nd at *text and moves past it; 0 when it is neither. */
static int read_number(const char **text)
{
    const char *p = *text + 1;
    int digits = 1;
    if (p[0] == '0' && p[1] >= '1' && p[1] <= '9') {
        digits = p[1] - '0';
        p += 2;
    }
    if (*p != 'd')
        return 0;
    *text = p + 1;
    return digits;
}

enum status sequence_read(struct sequence *sequence, const char *what, const char *path,
                          struct error *e)
{
    const char *p = path;
    char *out = sequence->before;
    sequence->digits = 0;
    sequence->after[0] = 0;
    if (strlen(path) >= PATH_MAX - 16)
        return error_set(e, STATUS_OUTPUT, "%s \"%s\": the name is too long", what, path);
    while (*p) {
        if (*p != '%') {
            *out++ = *p++;
        } else if (p[1] == '%') {
            *out++ = '%';
            p += 2;
        } else if (sequence->digits) {
            return fault(what, path, "has more than one frame number (%% is a percent sign)", e);
        } else if (!(sequence->digits = read_number(&p))) {
            return fault(what, path, "has a % that is no frame number: %d and %04d are", e);
        } else {
            *out = 0;
            out = sequence->after;
        }
    }
    *out = 0;
    if (strchr(sequence->after, '/'))
        return fault(what, path, "has its frame number in the directory", e);
    return STATUS_OK;
}

void sequence_name(const struct sequence *sequence, long index, char *name, size_t size)
{
    if (sequence->digits)
        snprintf(name, size, "%s%0*ld%s", sequence->before, sequence->digits, index,
                 sequence->after);
    else
        snprintf(name, size, "%s", sequence->before);
}

long sequence_number(const struct sequence *sequence, const char *path)
{
    size_t length = strlen(sequence->before);
    char again[SEQUENCE_NAME];
    if (!sequence->digits || strncmp(path, sequence->before, length) != 0 ||
        !isdigit((unsigned char)path[length]))
        return -1;
    errno = 0;
    long number = strtol(path + length, NULL, 10);
    sequence_name(sequence, number, again, sizeof again);
    return errno == 0 && strcmp(again, path) == 0 ? number : -1;
}
