/* What the kernels of frames work on. In the common subset of C and CUDA. */
#ifndef BACKEND_CUDA_FRAME_WORK_H
#define BACKEND_CUDA_FRAME_WORK_H

#include "particles/shown.h"

struct hash_work {
    const struct position *position;
    const struct motion *motion;
    const float *density;
    const uint32_t *id;
    uint64_t *sum; /* of all particles */
};

#endif
