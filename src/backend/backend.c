/* The table of back ends, and which one a run takes. */
#include "backend/backend.h"

#include "base/log.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static const struct variant *const rows[] = {
    &backend_cuda.variant,
    &backend_cpu.variant,
};

const struct variant_table backend_table = {
    .name = "backends",
    .doc = "where particles live and passes run",
    .rows = rows,
    .count = sizeof rows / sizeof *rows,
};

/* A whole number that ends at `end`, or -1. */
static long read_number(const char *text, char end)
{
    char *after;
    long number = isdigit((unsigned char)text[0]) ? strtol(text, &after, 10) : -1;
    return number >= 0 && *after == end ? number : -1;
}

/* ":N", ":N:B". */
static enum status read_device(const char *name, const char *colon, struct backend_place *place, struct error *e)
{
    const char *second = strchr(colon + 1, ':');
    const long number = read_number(colon + 1, second ? ':' : 0), block = second ? read_number(second + 1, 0) : 0;
    if (!place->row->has_devices)
        return error_set(e, STATUS_USAGE, "--backend %s: it has no devices to choose from; leave out the colon", name);
    if (number < 0 || number > 1023)
        return error_set(e, STATUS_USAGE, "--backend %s: give the number of a device after the colon, from 0", name);
    if (second && (block < 32 || block > BLOCK_MAX || block % 32))
        return error_set(e, STATUS_USAGE, "--backend %s: give threads of a block after the second colon: 32, 64, ... %d",
                         name, BLOCK_MAX);
    place->device = (int)number;
    place->block = (unsigned)block;
    return STATUS_OK;
}

enum status backend_find(const char *name, struct backend_place *place, struct error *e)
{
    const char *colon = strchr(name, ':');
    char word[32] = "";
    size_t length = colon ? (size_t)(colon - name) : strlen(name);
    *place = (struct backend_place){0};
    if (strcmp(name, "auto") == 0)
        return STATUS_OK;
    if (length < sizeof word)
        memcpy(word, name, length);
    place->row = (const struct backend_row *)variant_find(&backend_table, word);
    if (!place->row)
        return error_set(e, STATUS_USAGE, "--backend %s: there is no such back end; give auto, cpu, "
                         "cuda, or cuda:N for device N (sph-render list devices), cuda:N:B with B threads a block", name);
    if (place->row->variant.missing)
        return error_set(e, STATUS_BACKEND, "--backend %s: not in this build: %s", name,
                         place->row->variant.missing);
    return colon ? read_device(name, colon, place, e) : STATUS_OK;
}

const struct backend_row *backend_first(void)
{
    for (size_t i = 0; i < backend_table.count; i++) {
        const struct backend_row *row = (const struct backend_row *)rows[i];
        const char *why = row->variant.missing;
        if (!why && (!row->available || row->available(&why)))
            return row;
        log_detail("back end %s passed over: %s", row->variant.name, why);
    }
    return &backend_cpu;
}
