/* Allocates, frees, swaps and hashes particle fields. */
#include "particles/particles.h"

#include "base/memory.h"
#include "particles/hash.h"

#include <string.h>

const struct field_row field_table[FIELD_COUNT] = {
    [FIELD_POSITION] = {"position", "fixed-point position, volume", sizeof(struct position), 2},
    [FIELD_MOTION] = {"motion", "velocity, pressure", sizeof(struct motion), 2},
    [FIELD_DENSITY] = {"density", "density", sizeof(float), 2},
    [FIELD_RATE] = {"rate", "acceleration, density rate", sizeof(struct rate), 2},
    [FIELD_ID] = {"id", "identity", sizeof(uint32_t), 1},
    [FIELD_FLUID] = {"fluid", "index of the fluid", sizeof(uint8_t), 1},
    [FIELD_VISCOSITY] = {"viscosity", "dynamic viscosity", sizeof(float), 1},
    [FIELD_LOAD] = {"load", "position, volume times pressure", sizeof(struct position), 0},
    [FIELD_FLUX] = {"flux", "volume times trial velocity", sizeof(struct motion), 0},
    [FIELD_FACTOR] = {"factor", "kernel gradient sum, diagonal, walls, density", 8 * sizeof(float), 0},
    [FIELD_WARM] = {"warm", "pressures that solves hand on", 3 * sizeof(float), 1},
    [FIELD_SEARCH] = {"search", "search direction, viscosity", 4 * sizeof(float), 0},
    [FIELD_REMAINDER] = {"remainder", "residual of viscosity, drag of planes", 4 * sizeof(float), 0},
    [FIELD_BLOCK] = {"block", "preconditioner of viscosity, drag of planes", 9 * sizeof(float), 0},
    [FIELD_SHIFT] = {"shift", "velocity of shifting, depth in the fluid", 4 * sizeof(float), 2},
    [FIELD_SURFACE] = {"surface", "whether at a surface", sizeof(float), 2},
    [FIELD_STENCIL] = {"stencil", "kernel sums, walls and surface around", 32 * sizeof(float), 0},
    [FIELD_UNKNOWN] = {"unknown", "diagonal, residual, solution", 4 * sizeof(float), 0},
    [FIELD_TRIAL] = {"trial", "pressures and shift, of which gradients are taken", 4 * sizeof(float), 0},
    [FIELD_DIRECTION] = {"direction", "search direction", sizeof(float), 0},
    [FIELD_PRODUCT] = {"product", "matrix times direction", sizeof(float), 0},
    [FIELD_NORMAL] = {"normal", "normal of the fluid's surface", 4 * sizeof(float), 0},
    [FIELD_GRADIENT] = {"gradient", "density and its gradient", 4 * sizeof(float), 0},
    [FIELD_VORTICITY] = {"vorticity", "magnitude of the curl of velocity", sizeof(float), 0},
};

enum status particles_create(struct particles *particles, size_t count, unsigned fields,
                             struct error *e)
{
    *particles = (struct particles){.count = count, .fields = fields};
    size_t padded = (count / PARTICLE_BLOCK + 2) * PARTICLE_BLOCK;
    for (int f = 0; f < FIELD_COUNT; f++) {
        const struct field_row *row = &field_table[f];
        if (!(fields & FIELD_BIT(f)))
            continue;
        particles->now[f] = memory_create(row->name, padded, row->size, e);
        if (row->copies == 2)
            particles->before[f] = memory_create(row->name, padded, row->size, e);
        if (!particles->now[f] || (row->copies == 2 && !particles->before[f])) {
            particles_free(particles);
            return e->status;
        }
    }
    return STATUS_OK;
}

void particles_free(struct particles *particles)
{
    for (int f = 0; f < FIELD_COUNT; f++) {
        memory_free(particles->now[f]);
        memory_free(particles->before[f]);
    }
    *particles = (struct particles){0};
}

void particles_swap(struct particles *particles)
{
    for (int f = 0; f < FIELD_COUNT; f++) {
        void *now = particles->now[f];
        if (!particles->before[f])
            continue;
        particles->now[f] = particles->before[f];
        particles->before[f] = now;
    }
}

uint64_t particles_hash(const struct particles *particles)
{
    const struct position *position = particles_position(particles);
    const struct motion *motion = particles_motion(particles);
    const float *density = particles_density(particles);
    const uint32_t *id = particles_id(particles);
    uint64_t sum = hash_mix(particles->count);
#pragma omp parallel for reduction(+ : sum)
    for (size_t i = 0; i < particles->count; i++)
        sum += hash_particle(id[i], &position[i], &motion[i], density[i]);
    return sum;
}
