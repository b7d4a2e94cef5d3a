/* The passes over particles on the cpu: bodies from solver/, loops over threads from here. */
#include "backend/cpu/cpu.h"

#include <float.h>
#include <math.h>

struct extremes extremes_none(void)
{
    return (struct extremes){.bad = UINT32_MAX};
}

void extremes_merge(struct extremes *a, const struct extremes *b)
{
    a->speed2 = b->speed2 > a->speed2 ? b->speed2 : a->speed2;
    a->acceleration2 = b->acceleration2 > a->acceleration2 ? b->acceleration2 : a->acceleration2;
    a->move2 = b->move2 > a->move2 ? b->move2 : a->move2;
    a->bad = b->bad < a->bad ? b->bad : a->bad;
}

static float square(const float v[3])
{
    return v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
}

void cpu_predict(struct backend *b, struct step *step)
{
    const struct explicit_constants *c = &b->choice.each;
    struct particles *p = &b->particles;
    const struct position *x0 = p->before[FIELD_POSITION];
    const struct motion *v0 = p->before[FIELD_MOTION];
    const struct rate *rate = p->before[FIELD_RATE];
    const float *density0 = p->before[FIELD_DENSITY];
    const struct shift *shift = p->before[FIELD_SHIFT];
    float limit = 0.25f * c->spacing * c->spacing; /* half a spacing */
    struct extremes all = extremes_none();
#pragma omp parallel
    {
        struct extremes own = extremes_none();
#pragma omp for schedule(static)
        for (size_t i = 0; i < p->count; i++) {
            float density = 0;
            float move2 = explicit_predict(c, particles_fluid(p, i), step->dt, &x0[i], &v0[i],
                                           &rate[i], density0[i], shift ? shift[i].velocity : NULL,
                                           &particles_position(p)[i],
                                           &particles_motion(p)[i], &density);
            particles_density(p)[i] = density;
            own.move2 = move2 > own.move2 ? move2 : own.move2;
            if (!(move2 <= limit) || !(density > 0)) {
                uint32_t id = particles_id(p)[i];
                own.bad = id < own.bad ? id : own.bad;
            }
        }
#pragma omp critical
        extremes_merge(&all, &own);
    }
    step->extremes = all;
}

void cpu_correct(struct backend *b, struct step *step)
{
    struct particles *p = &b->particles;
    const struct rate *old = p->before[FIELD_RATE], *rate = particles_rate(p);
    struct motion *motion = particles_motion(p);
    float *density = particles_density(p);
    const float *rest = b->choice.each.rest_density;
    struct extremes all = extremes_none();
#pragma omp parallel
    {
        struct extremes own = extremes_none();
#pragma omp for schedule(static)
        for (size_t i = 0; i < p->count; i++) {
            explicit_correct(&b->choice.each, step->dt, &old[i], &rate[i], &motion[i], &density[i]);
            float v2 = square(motion[i].velocity), a2 = square(rate[i].acceleration);
            float ratio = density[i] / rest[particles_fluid(p, i)];
            own.speed2 = v2 > own.speed2 ? v2 : own.speed2;
            own.acceleration2 = a2 > own.acceleration2 ? a2 : own.acceleration2;
            if (!(v2 < FLT_MAX) || !(a2 < FLT_MAX) || !(ratio > 0.05f && ratio < 20))
                own.bad = particles_id(p)[i] < own.bad ? particles_id(p)[i] : own.bad;
        }
#pragma omp critical
        extremes_merge(&all, &own);
    }
    step->extremes = all;
}

void cpu_pressure(struct backend *b)
{
    const struct explicit_constants *c = &b->choice.each;
    struct particles *p = &b->particles;
    float *density = particles_density(p);
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->count; i++) {
        struct position *x = &particles_position(p)[i];
        int fluid = particles_fluid(p, i);
        if (!b->choice.continuity)
            density[i] = explicit_summed_density(c, fluid, x, b->number[i]);
        explicit_state(c, fluid, density[i], &particles_motion(p)[i].pressure, &x->volume);
    }
}

void cpu_walls(struct backend *b)
{
    const struct explicit_constants *c = &b->choice.each;
    const struct particles *p = &b->particles;
    const float *density = particles_density(p);
    const struct position *position = cpu_position(b);
    bool pushes = !(b->choice.flags & PAIR_DRAG_ONLY);
    const struct shift *shift = p->before[FIELD_SHIFT];
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->count; i++) {
        int fluid = particles_fluid(p, i);
        explicit_walls(c, fluid, &position[i], &particles_motion(p)[i],
                       pushes ? density[i] : c->rest_density[fluid], pushes,
                       shift ? 1 - shift[i].deep : 1, &particles_rate(p)[i]);
    }
}

const struct position *cpu_position(const struct backend *b)
{
    const struct particles *p = &b->particles;
    return b->choice.is_implicit ? p->before[FIELD_POSITION] : p->now[FIELD_POSITION];
}

struct pair_work cpu_pair_work(const struct backend *b)
{
    const struct particles *p = &b->particles;
    return (struct pair_work){
        .constants = b->choice.pair,
        .position = cpu_position(b),
        .motion = particles_motion(p),
        .viscosity = p->now[FIELD_VISCOSITY],
        .rest = b->rest,
        .density = b->choice.is_implicit ? NULL : particles_density(p),
        .rest_density = b->choice.each.rest_density,
        .softness = b->choice.continuity && b->choice.mixed ? b->choice.softness : NULL,
        .fluid = p->now[FIELD_FLUID],
        .shift = p->before[FIELD_SHIFT],
        .rate = particles_rate(p),
        .number = b->number,
        .rows = b->rows.block,
        .row_count = b->rows.count,
        .wall = b->wall.count ? particles_position(&b->wall) : NULL,
        .wall_rows = b->wall_rows.block,
        .wall_row_count = b->wall_rows.count,
        .count = p->count,
    };
}

void cpu_pair_blocks(struct backend *b, const struct pair_work *work, pair_function *pass)
{
    size_t blocks = (work->count + PARTICLE_BLOCK - 1) / PARTICLE_BLOCK;
#pragma omp parallel for schedule(dynamic, 16)
    for (size_t block = 0; block < blocks; block++)
        pass(work, block, block + 1);
    b->counts.pairs += b->rows.entries + b->wall_rows.entries;
}

void cpu_pairs(struct backend *b, pair_function *pass)
{
    struct pair_work work = cpu_pair_work(b);
    cpu_pair_blocks(b, &work, pass);
}

void cpu_diffusion(struct backend *b, enum pair_pass pass)
{
    struct diffusion_work diffusion = {.each = &b->choice.each,
                                       .gradient = b->particles.now[FIELD_GRADIENT]};
    struct pair_work work = cpu_pair_work(b);
    work.diffusion = &diffusion;
    cpu_pair_blocks(b, &work, b->isa->find(pass, b->choice.flags, false));
}

void cpu_shift(struct backend *b)
{
    const struct particles *p = &b->particles;
    struct shift_work shifting = {
        .each = &b->choice.each,
        .id = particles_id(p),
        .surface = p->before[FIELD_SURFACE],
        .now = p->now[FIELD_SHIFT],
        .surface_now = p->now[FIELD_SURFACE],
        .closeness = b->choice.closeness,
    };
    struct pair_work work = cpu_pair_work(b);
    work.shifting = &shifting;
    cpu_pair_blocks(b, &work, b->isa->find(PAIR_PASS_SHIFT, b->choice.flags, false));
}
