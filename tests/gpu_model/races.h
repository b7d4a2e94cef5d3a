/* ThreadSanitizer's view of the model, where MODEL_RACES is set and kernels are compiled with -fsanitize=thread: a
 * fiber is a thread; barriers order what those of a block do, and kernels follow one another. (A fiber is the thread
 * of that number in every block, so that what it did in one block is before what it does in the next.) */
#ifndef GPU_MODEL_RACES_H
#define GPU_MODEL_RACES_H

#include <stddef.h>

#ifdef MODEL_RACES
#include <sanitizer/tsan_interface.h>
#include <stdlib.h>

static char races_begun, races_ended;  /* of kernels */
static char races_met[1 << 16];        /* of blocks, used again after so many */
static size_t races_block;             /* that runs, of all since the start */
static void *races_scheduler;
static const bool races_no_barriers = getenv("GPU_MODEL_NO_BARRIERS") != NULL; /* to see that races are found */

static void races_kernel_begin()
{
    races_scheduler = __tsan_get_current_fiber();
    __tsan_release(&races_begun);
}
static void races_kernel_end()
{
    __tsan_acquire(&races_ended);
}
static void races_block_begin()
{
    races_block++;
}
/* Of the thread that runs: its first and last moments, and a barrier. */
static void races_thread_begin()
{
    __tsan_acquire(&races_begun);
}
static void races_thread_end()
{
    __tsan_release(&races_ended);
}
static void races_come()
{
    if (!races_no_barriers)
        __tsan_release(&races_met[races_block % sizeof races_met]);
}
static void races_go()
{
    if (!races_no_barriers)
        __tsan_acquire(&races_met[races_block % sizeof races_met]);
}
static void *races_fiber()
{
    return __tsan_create_fiber(0);
}
static void races_switch(void *fiber)
{
    __tsan_switch_to_fiber(fiber, __tsan_switch_to_fiber_no_sync);
}
static void races_switch_back()
{
    races_switch(races_scheduler);
}
#else
static inline void races_kernel_begin() {}
static inline void races_kernel_end() {}
static inline void races_block_begin() {}
static inline void races_thread_begin() {}
static inline void races_thread_end() {}
static inline void races_come() {}
static inline void races_go() {}
static inline void *races_fiber()
{
    return NULL;
}
static inline void races_switch(void *) {}
static inline void races_switch_back() {}
#endif

#endif
