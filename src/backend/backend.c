/* The table of back ends, and which one a run takes. */
#include "backend/backend.h"

#include "base/log.h"

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

enum status backend_find(const char *name, const struct backend_row **row, int *device,
                         struct error *e)
{
    const char *colon = strchr(name, ':');
    char word[32] = "", *end = NULL;
    size_t length = colon ? (size_t)(colon - name) : strlen(name);
    *row = NULL;
    *device = 0;
    if (strcmp(name, "auto") == 0)
        return STATUS_OK;
    if (length < sizeof word)
        memcpy(word, name, length);
    *row = (const struct backend_row *)variant_find(&backend_table, word);
    if (!*row)
        return error_set(e, STATUS_USAGE, "--backend %s: there is no such back end; give auto, cpu, "
                         "cuda, or cuda:N for device N (sph-render list devices)", name);
    if ((*row)->variant.missing)
        return error_set(e, STATUS_BACKEND, "--backend %s: not in this build: %s", name,
                         (*row)->variant.missing);
    if (!colon)
        return STATUS_OK;
    long number = strtol(colon + 1, &end, 10);
    if (!(*row)->has_devices || end == colon + 1 || *end || number < 0 || number > 1023)
        return error_set(e, STATUS_USAGE, "--backend %s: %s", name,
                         (*row)->has_devices ? "give the number of a device after the colon, from 0"
                                             : "it has no devices to choose from; leave out the colon");
    *device = (int)number;
    return STATUS_OK;
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
