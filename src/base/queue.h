/* A queue between threads. What bounds it is the pool that its items come from. */
#ifndef BASE_QUEUE_H
#define BASE_QUEUE_H

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>

enum { QUEUE_SIZE = 32 };

struct queue {
    pthread_mutex_t mutex;
    pthread_cond_t changed;
    void *items[QUEUE_SIZE];
    size_t first, count;
    bool closed;
};

void queue_init(struct queue *queue);
void queue_destroy(struct queue *queue); /* no thread may be using it */

/* Never blocks. At most QUEUE_SIZE items may be in a queue. */
void queue_push(struct queue *queue, void *item);

/* Waits for the oldest item; NULL when the queue is closed and empty. */
void *queue_pop(struct queue *queue);

/* Nothing will be pushed any more: wakes those who wait. */
void queue_close(struct queue *queue);

#endif
