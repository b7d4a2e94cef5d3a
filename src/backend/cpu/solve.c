/* The implicit solver's passes on the cpu: bodies from solver/implicit.h, loops over threads here. */
#include "backend/cpu/cpu.h"

#include <float.h>
#include <math.h>

void cpu_solve_start(struct backend *b)
{
    struct particles *p = &b->particles;
    for (size_t i = 0; i < p->count; i++)
        particles_position(p)[i].volume = b->choice.implicit.volume[particles_fluid(p, i)];
}

/* Means over the particles of what blocks left; the sum of integers does not depend on its order. */
static void mean_residual(const struct backend *b, struct step *step)
{
    size_t blocks = (b->particles.count + PARTICLE_BLOCK - 1) / PARTICLE_BLOCK;
    double one = b->particles.count ? 0x1p-40 / (double)b->particles.count : 0;
    int64_t error = 0, signed_sum = 0;
#pragma omp parallel for schedule(static) reduction(+ : error, signed_sum)
    for (size_t k = 0; k < blocks; k++) {
        error += b->residual[2 * k];
        signed_sum += b->residual[2 * k + 1];
    }
    step->residual = (double)error * one;
    step->offset = b->choice.enclosed && step->solve == SOLVE_VELOCITY ? (float)((double)signed_sum * one) : 0;
}

/* The density ratio to aim at: where fluid fills the domain its mean cannot change. */
static void find_target(const struct backend *b, struct step *step)
{
    const struct factor *factor = b->particles.now[FIELD_FACTOR];
    int64_t sum = 0;
    step->target = 1;
    if (!b->choice.enclosed || b->particles.count == 0)
        return;
#pragma omp parallel for schedule(static) reduction(+ : sum)
    for (size_t i = 0; i < b->particles.count; i++) {
        float excess = factor[i].ratio - 1;
        sum += (int64_t)((excess > 1 ? 1 : excess < -1 ? -1 : excess) * 0x1p40f);
    }
    step->target += (float)((double)sum * 0x1p-40 / (double)b->particles.count);
}

void cpu_invert_densities(struct backend *b)
{
    if (!b->inverse_density)
        return;
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < b->particles.count; i++)
        b->inverse_density[i] =
            1 / b->choice.each.rest_density[particles_fluid(&b->particles, i)];
}

void cpu_solve(struct backend *b, struct step *step, enum pair_pass pass)
{
    struct particles *p = &b->particles;
    struct solve_work solve = {
        .each = &b->choice.each,
        .implicit = &b->choice.implicit,
        .solve = step->solve,
        .dt = step->dt,
        .relax = step->relax,
        .momentum = step->momentum,
        .target = step->target,
        .offset = step->offset,
        .load = p->now[FIELD_LOAD],
        .flux = p->now[FIELD_FLUX],
        .motion = particles_motion(p),
        .factor = p->now[FIELD_FACTOR],
        .warm = p->now[FIELD_WARM],
        .search = p->now[FIELD_SEARCH],
        .remainder = p->now[FIELD_REMAINDER],
        .product = p->now[FIELD_FLUX],
        .block = p->now[FIELD_BLOCK],
        .density = particles_density(p),
        .residual = b->residual,
    };
    struct pair_work work = cpu_pair_work(b);
    work.motion = p->before[FIELD_MOTION];
    work.solve = &solve;
    if (pass == PAIR_PASS_FACTOR)
        cpu_invert_densities(b);
    work.inverse_density = b->inverse_density;
    cpu_pair_blocks(b, &work, b->isa->find(pass, b->choice.flags, b->wall.count > 0));
    if (pass == PAIR_PASS_SWEEP)
        mean_residual(b, step);
    else if (pass == PAIR_PASS_FACTOR)
        find_target(b, step);
}

void cpu_kick(struct backend *b, struct step *step)
{
    struct particles *p = &b->particles;
    const struct motion *before = p->before[FIELD_MOTION];
    const struct rate *rate = p->now[FIELD_RATE];
    struct warm *warm = p->now[FIELD_WARM];
    struct position *load = p->now[FIELD_LOAD];
    const float *gravity = b->choice.pair.gravity, one = 1 / b->choice.implicit.pressure;
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->count; i++) {
        struct motion *motion = &particles_motion(p)[i];
        const float *a = rate ? rate[i].acceleration : gravity;
        for (int d = 0; d < 3; d++)
            motion->velocity[d] += step->dt * a[d];
        motion->pressure = warm[i].last = before[i].pressure * one;
        load[i].volume = b->choice.implicit.volume[particles_fluid(p, i)] * motion->pressure;
    }
}

void cpu_resume(struct backend *b, const struct step *step)
{
    struct particles *p = &b->particles;
    struct warm *warm = p->now[FIELD_WARM];
    struct position *load = p->now[FIELD_LOAD];
    float part = step->resume / (step->dt * step->dt);
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->count; i++) {
        struct motion *motion = &particles_motion(p)[i];
        warm[i].velocity = motion->pressure;
        motion->pressure = warm[i].last = part > 0 ? part * warm[i].shift : 0;
        load[i].volume = b->choice.implicit.volume[particles_fluid(p, i)] * motion->pressure;
    }
}

void cpu_move(struct backend *b, struct step *step)
{
    const struct explicit_constants *c = &b->choice.each;
    struct particles *p = &b->particles;
    const struct position *x0 = p->before[FIELD_POSITION];
    const struct motion *v0 = p->before[FIELD_MOTION], *flux = p->now[FIELD_FLUX];
    const float *gravity = b->choice.pair.gravity;
    struct warm *warm = p->now[FIELD_WARM];
    const struct factor *factor = p->now[FIELD_FACTOR];
    float limit = 0.25f * c->spacing * c->spacing; /* half a spacing */
    struct extremes all = extremes_none();
#pragma omp parallel
    {
        struct extremes own = extremes_none();
#pragma omp for schedule(static)
        for (size_t i = 0; i < p->count; i++) {
            struct motion *v = &particles_motion(p)[i];
            float v2 = 0, a2 = 0, one = 1 / b->choice.implicit.volume[particles_fluid(p, i)];
            float shift[3];
            for (int d = 0; d < 3; d++)
                shift[d] = one * flux[i].velocity[d] / factor[i].along[d];
            implicit_bound(c, step->dt, shift);
            for (int d = 0; d < 3 && warm[i].velocity == 0; d++)
                shift[d] -= 0.5f * step->dt * gravity[d]; /* falling freely: the mean velocity */
            float move2 = implicit_move(c, step->dt, &x0[i], shift, &particles_position(p)[i], v);
            warm[i].shift = v->pressure * (step->dt * step->dt);
            v->pressure = b->choice.implicit.pressure * warm[i].velocity;
            for (int d = 0; d < 3; d++) {
                float a = (v->velocity[d] - v0[i].velocity[d]) / step->dt;
                v2 += v->velocity[d] * v->velocity[d];
                a2 += a * a;
            }
            own.move2 = move2 > own.move2 ? move2 : own.move2;
            own.speed2 = v2 > own.speed2 ? v2 : own.speed2;
            own.acceleration2 = a2 > own.acceleration2 ? a2 : own.acceleration2;
            if (!(move2 <= limit) || !(v2 < FLT_MAX) || !(v->pressure < FLT_MAX))
                own.bad = particles_id(p)[i] < own.bad ? particles_id(p)[i] : own.bad;
        }
#pragma omp critical
        extremes_merge(&all, &own);
    }
    step->extremes = all;
}
