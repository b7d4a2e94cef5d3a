/* Particles as arrays of records, allocated for the planned fields only. */
#ifndef PARTICLES_PARTICLES_H
#define PARTICLES_PARTICLES_H

#include "base/error.h"

#include <stdalign.h>
#include <stddef.h>
#include <stdint.h>

/* 16-byte records: a neighbour is fetched as one or two of them, and a GPU moves 16 bytes at once where they are
 * aligned. */
struct position {
    alignas(16) uint32_t count[3]; /* fixed point, particles/space.h */
    float volume;      /* present volume / d^3; of a wall particle: V_b / d^3 */
};
struct motion {
    alignas(16) float velocity[3]; /* m/s */
    float pressure;    /* Pa */
};
struct rate {
    alignas(16) float acceleration[3]; /* m/s^2 */
    float density;         /* d(rho)/dt, kg/(m^3 s) */
};

enum field {
    FIELD_POSITION,
    FIELD_MOTION,
    FIELD_DENSITY, /* float, kg/m^3 */
    FIELD_RATE,
    FIELD_ID,        /* uint32_t, 0 .. count-1 in order of filling, never changes */
    FIELD_FLUID,     /* uint8_t, index into the scene's fluids; absent with one fluid */
    FIELD_VISCOSITY, /* float, Pa s; absent unless fluids differ in it */
    FIELD_LOAD,      /* struct position with volume = V P / d^3 (Pa), of the implicit solver */
    FIELD_FLUX,      /* struct motion with velocity = V (v + dt a) / d^3 (m/s);
                        before that struct drag: product of implicit viscosity */
    FIELD_FACTOR,    /* struct factor (solver/implicit.h) */
    FIELD_WARM,      /* struct warm (solver/implicit.h) */
    FIELD_SEARCH,    /* struct drag (solver/drag.h): search direction of implicit viscosity */
    FIELD_REMAINDER, /* struct drag: its residual */
    FIELD_BLOCK,     /* struct drag_block: its preconditioner along the line of centres */
    FIELD_SHIFT,     /* struct shift (solver/shift.h) */
    FIELD_SURFACE,   /* float: 0 inside the fluid, 1 at its surface (solver/shift.h) */
    FIELD_NORMAL,    /* struct normal (solver/tension.h) */
    FIELD_STENCIL,   /* struct stencil (solver/projection.h) */
    FIELD_UNKNOWN,   /* struct unknown: a row of a linear system */
    FIELD_TRIAL,     /* struct trial: what gradients are taken of */
    FIELD_DIRECTION, /* float: search direction of conjugate gradients */
    FIELD_PRODUCT,   /* float: the matrix times it */
    FIELD_GRADIENT,  /* struct gradient (solver/diffusion.h) */
    FIELD_VORTICITY, /* float, 1/s (solver/curl.h): of frames */
    FIELD_COUNT
};

struct field_row {
    const char *name, *doc;
    size_t size;   /* bytes per particle */
    int copies;    /* 2: the state before the step is kept, so that a step can be redone;
                      0: one, of use within a step only, which sorting leaves alone */
};
extern const struct field_row field_table[FIELD_COUNT];

/* Bytes that a field takes of each particle. */
static inline size_t field_bytes(const struct field_row *row)
{
    return row->copies == 2 ? 2 * row->size : row->size;
}

#define FIELD_BIT(f) (1u << (f))

/* Arrays are padded to a whole block of lanes; padding repeats no particle and is never summed. */
enum { PARTICLE_BLOCK = 16 };

struct particles {
    size_t count;
    unsigned fields;           /* FIELD_BIT mask of those allocated */
    void *now[FIELD_COUNT];    /* the present state */
    void *before[FIELD_COUNT]; /* the state at the start of the step, where copies == 2 */
};

/* Zeroed arrays for `fields`; STATUS_RUN when memory is short. */
enum status particles_create(struct particles *particles, size_t count, unsigned fields,
                             struct error *e);
void particles_free(struct particles *particles);

/* Exchanges the present state with the one before, in the fields that keep both. */
void particles_swap(struct particles *particles);

#ifndef __cplusplus /* CUDA sees addresses in struct work only */
static inline struct position *particles_position(const struct particles *p)
{
    return p->now[FIELD_POSITION];
}
static inline struct motion *particles_motion(const struct particles *p)
{
    return p->now[FIELD_MOTION];
}
static inline float *particles_density(const struct particles *p)
{
    return p->now[FIELD_DENSITY];
}
static inline struct rate *particles_rate(const struct particles *p)
{
    return p->now[FIELD_RATE];
}
static inline float *particles_vorticity(const struct particles *p)
{
    return p->now[FIELD_VORTICITY];
}
static inline uint32_t *particles_id(const struct particles *p)
{
    return p->now[FIELD_ID];
}
static inline int particles_fluid(const struct particles *p, size_t i)
{
    const uint8_t *fluid = p->now[FIELD_FLUID];
    return fluid ? fluid[i] : 0;
}
#endif

/* The fields that the hash reads. */
#define PARTICLES_HASHED                                                                           \
    (FIELD_BIT(FIELD_ID) | FIELD_BIT(FIELD_POSITION) | FIELD_BIT(FIELD_MOTION) | FIELD_BIT(FIELD_DENSITY))

/* Hash of the state: ids, positions, velocities and densities; independent of the order in memory. */
uint64_t particles_hash(const struct particles *particles);

#endif
