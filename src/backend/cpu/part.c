/* Moves particles apart that share a place (solver/part.h): rarely any, between two row builds. */
#include "solver/part.h"

#include "backend/cpu/cpu.h"
#include "base/log.h"

#include <string.h>

/* Square of the distance in smoothing lengths; the same from either side. */
static float distance2(const float scale[3], const struct position *x, const struct position *y)
{
    float sum = 0;
    for (int a = 0; a < 3; a++) {
        float r = (float)(int32_t)(x->count[a] - y->count[a]) * scale[a];
        sum += r * r;
    }
    return sum;
}

/* The particle's place after parting; returns whether it moved. */
static bool part(const struct backend *b, size_t i, float near, struct position *x)
{
    const struct explicit_constants *c = &b->choice.each;
    const struct position *position = particles_position(&b->particles);
    const uint32_t *row = b->rows.block[i / PARTICLE_BLOCK].index + i % PARTICLE_BLOCK;
    const uint32_t *id = particles_id(&b->particles);
    float mass = c->mass[particles_fluid(&b->particles, i)];
    int32_t move[3] = {0};
    bool moved = false;
    *x = position[i];
    for (uint32_t k = 0; k < b->rows.count[i]; k++) {
        size_t j = row[(size_t)k * PARTICLE_BLOCK] / 2;
        if (!(distance2(b->choice.pair.scale, &position[i], &position[j]) < near))
            continue;
        float other = c->mass[particles_fluid(&b->particles, j)];
        part_pair(c, &position[i], &position[j], id[i], id[j], other / (mass + other), move);
        moved = true;
    }
    if (moved)
        part_move(c, move, x);
    return moved;
}

void cpu_part(struct backend *b, float near)
{
    struct particles *p = &b->particles;
    struct position *next = b->spare;
    size_t moved = 0;
#pragma omp parallel for schedule(static) reduction(+ : moved)
    for (size_t i = 0; i < p->count; i++)
        moved += part(b, i, near, &next[i]);
    memcpy(particles_position(p), next, p->count * sizeof *next);
    log_detail("%zu particles shared a place and were moved apart", moved);
}
