/* Frames: what their kernels do for thread i. In the common subset of C and CUDA; the includer says how threads
 * add to a number that they share, order_add64. */
#ifndef BACKEND_CUDA_FRAME_H
#define BACKEND_CUDA_FRAME_H

#include "backend/cuda/frame_work.h"
#include "particles/hash.h"

static inline void frame_show(const struct shown *w, size_t i)
{
    shown_particle(w, i);
}

static inline void frame_hash(const struct hash_work *w, size_t i)
{
    order_add64(w->sum, hash_particle(w->id[i], &w->position[i], &w->motion[i], w->density[i]));
}

#endif
