/* Hands out aligned, zeroed blocks and keeps the account of each label. */
#include "base/memory.h"

#include <pthread.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

enum {
    ALIGNMENT = 64,        /* cache line, and the widest vector */
    HUGE_PAGE = 1 << 21,   /* bytes, on x86-64 and most others */
    ZERO_PARALLEL = 1 << 20, /* bytes; smaller blocks are not worth a parallel region */
    ZERO_CHUNK = 1 << 16     /* bytes */
};

static const size_t ADDRESS_MAX = SIZE_MAX >> 16; /* bytes; more than any processor maps */

struct account {
    struct account *next;
    size_t bytes, blocks;
    char label[]; /* a copy, since equal labels of different owners share the account */
};

/* In front of each block. */
union header {
    struct {
        struct account *account;
        size_t bytes;
    } block;
    char pad[ALIGNMENT];
};

static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
static struct account *accounts;
static size_t bytes_now, bytes_peak;

/* Under the mutex: the account of a label, made at first use; NULL when memory is short. */
static struct account *account_find(const char *label)
{
    struct account **end = &accounts;
    for (; *end; end = &(*end)->next)
        if (strcmp((*end)->label, label) == 0)
            return *end;
    struct account *made = calloc(1, sizeof *made + strlen(label) + 1);
    if (made)
        strcpy(made->label, label);
    return *end = made;
}

/* Under the mutex: drops an account that holds nothing. */
static void account_drop(struct account *account)
{
    struct account **link = &accounts;
    while (*link != account)
        link = &(*link)->next;
    *link = account->next;
    free(account);
}

/* Zeroes by the threads that will compute on the pages, so that each page lies near its user. */
static void zero(char *bytes, size_t size)
{
    if (size < ZERO_PARALLEL) {
        memset(bytes, 0, size);
        return;
    }
    size_t chunks = (size + ZERO_CHUNK - 1) / ZERO_CHUNK;
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < chunks; i++) {
        size_t start = i * ZERO_CHUNK;
        memset(bytes + start, 0, size - start < ZERO_CHUNK ? size - start : ZERO_CHUNK);
    }
}

/* Large blocks ask for huge pages: neighbours lie far apart, and address translation would cost more
 * than the data. */
static void *block_alloc(size_t bytes)
{
    if (bytes < HUGE_PAGE)
        return aligned_alloc(ALIGNMENT, bytes);
    void *block = aligned_alloc(HUGE_PAGE, (bytes + HUGE_PAGE - 1) / HUGE_PAGE * HUGE_PAGE);
    if (block)
        madvise(block, bytes, MADV_HUGEPAGE);
    return block;
}

void *memory_create(const char *label, size_t count, size_t size, struct error *e)
{
    size_t bytes;
    if (__builtin_mul_overflow(count, size, &bytes) || bytes > ADDRESS_MAX) {
        error_set(e, STATUS_RUN, "%s: %zu items of %zu bytes are more than an address can reach",
                  label, count, size);
        return NULL;
    }
    size_t rounded = (bytes + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
    union header *header = block_alloc(sizeof *header + rounded);
    struct account *account = NULL;
    if (header) {
        pthread_mutex_lock(&mutex);
        account = account_find(label);
        if (account) {
            account->bytes += bytes;
            account->blocks++;
            bytes_now += bytes;
            bytes_peak = bytes_now > bytes_peak ? bytes_now : bytes_peak;
        }
        pthread_mutex_unlock(&mutex);
    }
    if (!account) {
        free(header);
        error_set(e, STATUS_RUN, "%s: no memory for %.1f MB more (%.1f MB are in use); "
                  "use fewer particles or a smaller picture", label, 1e-6 * (double)bytes,
                  1e-6 * (double)memory_now());
        return NULL;
    }
    header->block.account = account;
    header->block.bytes = bytes;
    zero((char *)(header + 1), rounded);
    return header + 1;
}

void memory_free(void *block)
{
    if (!block)
        return;
    union header *header = (union header *)block - 1;
    struct account *account = header->block.account;
    pthread_mutex_lock(&mutex);
    bytes_now -= header->block.bytes;
    account->bytes -= header->block.bytes;
    if (--account->blocks == 0)
        account_drop(account);
    pthread_mutex_unlock(&mutex);
    free(header);
}

size_t memory_now(void)
{
    pthread_mutex_lock(&mutex);
    size_t bytes = bytes_now;
    pthread_mutex_unlock(&mutex);
    return bytes;
}

size_t memory_peak(void)
{
    pthread_mutex_lock(&mutex);
    size_t bytes = bytes_peak;
    pthread_mutex_unlock(&mutex);
    return bytes;
}

/* The mutex is held during the visits: visit() must not create or free blocks. */
void memory_each(void (*visit)(void *context, const char *label, size_t bytes), void *context)
{
    pthread_mutex_lock(&mutex);
    for (struct account *a = accounts; a; a = a->next)
        visit(context, a->label, a->bytes);
    pthread_mutex_unlock(&mutex);
}
