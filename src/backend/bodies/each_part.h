/* Moves particle i apart from those that share its place (solver/part.h): rarely any, between two row
 * builds. Common subset of C and CUDA. */
#ifndef BACKEND_BODIES_EACH_PART_H
#define BACKEND_BODIES_EACH_PART_H

#include "backend/bodies/near.h"
#include "backend/work.h"
#include "solver/part.h"

/* The particle's new place goes to `parted`; returns whether it is another. */
static inline int64_t each_part(const struct work *w, size_t i)
{
    const struct explicit_constants *c = &w->choice->each;
    const struct position *position = w->state.position;
    const uint32_t *row = w->rows[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
    const float near = part_near2(w->choice->spacing, w->choice->smoothing_length);
    float mass = c->mass[work_fluid(w, i)];
    int32_t move[3] = {0, 0, 0};
    bool moved = false;
    for (uint32_t k = 0; k < w->row_count[i]; k++) {
        size_t j = row[(size_t)k * PARTICLE_BLOCK] / 2;
        if (!(near_q2(position[i].count, position[j].count, w->constants.scale) < near))
            continue;
        float other = c->mass[work_fluid(w, j)];
        part_pair(c, &position[i], &position[j], w->id[i], w->id[j], other / (mass + other), move);
        moved = true;
    }
    w->parted[i] = position[i];
    if (moved)
        part_move(c, move, &w->parted[i]);
    return moved;
}

static inline void each_parted(const struct work *w, size_t i)
{
    w->state.position[i] = w->parted[i];
}

#endif
