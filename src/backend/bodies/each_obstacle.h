/* What stops particle i at obstacles, after it has moved (solver/obstacle.h). Common subset of C and CUDA. */
#ifndef BACKEND_BODIES_EACH_OBSTACLE_H
#define BACKEND_BODIES_EACH_OBSTACLE_H

#include "backend/work.h"

static inline void each_stop(const struct work *w, size_t i)
{
    const struct state_work *s = &w->state;
    const struct position before = s->position0[i];
    struct position x = s->position[i];
    struct motion v = s->motion[i];
    if (!obstacles_stop(&w->choice->each.obstacles, before.count, x.count, v.velocity))
        return;
    s->position[i] = x;
    s->motion[i] = v;
}

#endif
