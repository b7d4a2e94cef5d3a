/* Labelled memory: aligned, zeroed, and accounted, so that a run can say what it paid for. */
#ifndef BASE_MEMORY_H
#define BASE_MEMORY_H

#include "base/error.h"

#include <stddef.h>

/* count * size bytes, 64-byte aligned, zeroed in parallel (first touch); NULL with STATUS_RUN in
 * `e` when memory is short or the product overflows. `label` must outlive the block. */
void *memory_create(const char *label, size_t count, size_t size, struct error *e);
void memory_free(void *block);

/* Bytes now held, and the most ever held, by all labelled blocks. */
size_t memory_now(void);
size_t memory_peak(void);

/* Calls visit(label, bytes) for each label that holds memory now. */
void memory_each(void (*visit)(void *context, const char *label, size_t bytes), void *context);

#endif
