/* The projection solver's passes on the cpu: loops over particles, and conjugate gradients, whose sums
 * are of blocks in order of the particles and then exact, so that they have the same bits for any
 * number of threads. */
#include "backend/cpu/cpu.h"

#include "base/exact_sum.h"

#include <float.h>
#include <math.h>

static size_t block_count(const struct backend *b)
{
    return (b->particles.count + PARTICLE_BLOCK - 1) / PARTICLE_BLOCK;
}

static size_t block_end(const struct backend *b, size_t block)
{
    size_t end = (block + 1) * PARTICLE_BLOCK;
    return end < b->particles.count ? end : b->particles.count;
}

/* Sums over particles of two terms. */
struct sums {
    struct exact_sum first, second;
};

static void merge(struct sums *all, const struct sums *own)
{
#pragma omp critical(projection)
    {
        exact_merge(&all->first, &own->first);
        exact_merge(&all->second, &own->second);
    }
}

void cpu_projection(struct backend *b, const struct step *step, enum pair_pass pass)
{
    const struct particles *p = &b->particles;
    struct projection_work projection = {
        .each = &b->choice.each,
        .constants = &b->choice.projection,
        .id = particles_id(p),
        .before = step->before,
        .dt = step->dt,
        .stencil = p->now[FIELD_STENCIL],
        .unknown = p->now[FIELD_UNKNOWN],
        .trial = p->now[FIELD_TRIAL],
        .motion = particles_motion(p),
        .density = particles_density(p),
        .surface = p->now[FIELD_SURFACE],
        .violent = p->before[FIELD_SURFACE],
        .direction = p->now[FIELD_DIRECTION],
        .product = p->now[FIELD_PRODUCT],
    };
    struct pair_work work = cpu_pair_work(b);
    struct tension_work tension = cpu_tension_work(b, projection.direction);
    work.projection = &projection;
    if (pass == PAIR_PASS_JUMP)
        work.tension = &tension;
    if (b->choice.projection.mixed) {
        if (pass == PAIR_PASS_STENCIL)
            cpu_invert_densities(b);
        work.inverse_density = b->inverse_density;
    }
    cpu_pair_blocks(b, &work, b->isa->find(pass, b->choice.flags, false));
}

void cpu_rewind(struct backend *b, const struct step *step)
{
    struct particles *p = &b->particles;
    float *direction = p->now[FIELD_DIRECTION];
    const struct motion *v0 = p->before[FIELD_MOTION];
    const struct rate *old = p->before[FIELD_RATE];
    const float *gravity = b->choice.pair.gravity, half = 0.5f * step->before;
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->count; i++) {
        struct motion *v = &particles_motion(p)[i];
        for (int a = 0; a < 3; a++) {
            v->velocity[a] = v0[i].velocity[a] - half * old[i].acceleration[a];
            particles_rate(p)[i].acceleration[a] = gravity[a];
        }
        v->pressure = v0[i].pressure;
        direction[i] = step->resume * old[i].density;
    }
}

void cpu_advance(struct backend *b, const struct step *step)
{
    struct particles *p = &b->particles;
    const float half = 0.5f * step->before;
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->count; i++)
        for (int a = 0; a < 3; a++)
            particles_motion(p)[i].velocity[a] += half * particles_rate(p)[i].acceleration[a];
}

/* Mean of a member of the particles' records, `stride` floats apart; 0 where fluid is not enclosed. */
static float enclosed_mean(const struct backend *b, const float *member, size_t stride)
{
    struct sums all = {0};
    if (!b->choice.enclosed || b->particles.count == 0)
        return 0;
#pragma omp parallel
    {
        struct sums own = {0};
#pragma omp for schedule(static)
        for (size_t i = 0; i < b->particles.count; i++)
            exact_add(&own.first, (double)member[i * stride]);
        merge(&all, &own);
    }
    return (float)(exact_value(&all.first) / (double)b->particles.count);
}

void cpu_crowding(struct backend *b, const struct step *step)
{
    const struct projection_constants *c = &b->choice.projection;
    struct particles *p = &b->particles;
    const struct rate *old = p->before[FIELD_RATE];
    const struct stencil *stencil = p->now[FIELD_STENCIL];
    struct unknown *unknown = p->now[FIELD_UNKNOWN];
    struct trial *trial = p->now[FIELD_TRIAL];
    float mean = -enclosed_mean(b, &stencil->lack, sizeof *stencil / sizeof(float));
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->count; i++)
        projection_pressures(c, b->choice.each.h, &stencil[i], mean, step->before,
                             particles_motion(p)[i].pressure, step->resume * old[i].density,
                             &unknown[i], &trial[i]);
}

/* Keeps the solution of the equation of the shift for the slopes. */
void cpu_shifted(struct backend *b)
{
    struct particles *p = &b->particles;
    const struct unknown *unknown = p->now[FIELD_UNKNOWN];
    struct trial *trial = p->now[FIELD_TRIAL];
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->count; i++)
        trial[i].shift = unknown[i].value;
}

/* Residuals as a solve's tolerance counts them. */
static double residual_scale(const struct backend *b, const struct step *step)
{
    double n = b->particles.count ? (double)b->particles.count : 1;
    if (step->solve == SOLVE_SHIFT)
        return 1 / ((double)b->choice.projection.gain * n);
    double dt = (double)step->before;
    return dt * dt / (2 * (double)b->choice.projection.reference * n);
}

void cpu_residual(struct backend *b, struct step *step)
{
    struct particles *p = &b->particles;
    struct unknown *unknown = p->now[FIELD_UNKNOWN];
    /* Where nothing is fixed the pressure is known but for a constant: the residual has no mean. */
    const float mean = enclosed_mean(b, &unknown->residual, sizeof *unknown / sizeof(float));
    float *direction = p->now[FIELD_DIRECTION];
    struct sums all = {0};
#pragma omp parallel
    {
        struct sums own = {0};
#pragma omp for schedule(static)
        for (size_t block = 0; block < block_count(b); block++) {
            double square = 0, size = 0;
            for (size_t i = block * PARTICLE_BLOCK; i < block_end(b, block); i++) {
                struct unknown *u = &unknown[i];
                u->residual = u->inverse > 0 ? u->residual - mean : 0;
                direction[i] = u->residual * u->inverse;
                square += (double)u->residual * (double)direction[i];
                size += fabs((double)u->residual);
            }
            exact_add(&own.first, square);
            exact_add(&own.second, size);
        }
        merge(&all, &own);
    }
    b->descent = exact_value(&all.first);
    step->residual = exact_value(&all.second) * residual_scale(b, step);
}

/* direction . matrix . direction */
static double curvature(const struct backend *b)
{
    const float *product = b->particles.now[FIELD_PRODUCT];
    const float *direction = b->particles.now[FIELD_DIRECTION];
    struct sums all = {0};
#pragma omp parallel
    {
        struct sums own = {0};
#pragma omp for schedule(static)
        for (size_t block = 0; block < block_count(b); block++) {
            double sum = 0;
            for (size_t i = block * PARTICLE_BLOCK; i < block_end(b, block); i++)
                sum += (double)direction[i] * (double)product[i];
            exact_add(&own.first, sum);
        }
        merge(&all, &own);
    }
    return exact_value(&all.first);
}

static struct sums go_ahead(struct backend *b, float length)
{
    struct unknown *unknown = b->particles.now[FIELD_UNKNOWN];
    const float *product = b->particles.now[FIELD_PRODUCT];
    const float *direction = b->particles.now[FIELD_DIRECTION];
    struct sums all = {0};
#pragma omp parallel
    {
        struct sums own = {0};
#pragma omp for schedule(static)
        for (size_t block = 0; block < block_count(b); block++) {
            double square = 0, size = 0;
            for (size_t i = block * PARTICLE_BLOCK; i < block_end(b, block); i++) {
                struct unknown *u = &unknown[i];
                u->value += length * direction[i];
                u->residual = u->inverse > 0 ? u->residual - length * product[i] : 0;
                square += (double)u->residual * (double)(u->residual * u->inverse);
                size += fabs((double)u->residual);
            }
            exact_add(&own.first, square);
            exact_add(&own.second, size);
        }
        merge(&all, &own);
    }
    return all;
}

static void turn(struct backend *b, float keep)
{
    const struct unknown *unknown = b->particles.now[FIELD_UNKNOWN];
    float *direction = b->particles.now[FIELD_DIRECTION];
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < b->particles.count; i++)
        direction[i] = unknown[i].residual * unknown[i].inverse + keep * direction[i];
}

/* Sums that are not finite make velocities so, and the step is rejected when particles move. */
void cpu_descent(struct backend *b, struct step *step)
{
    double curved = curvature(b), before = b->descent;
    double length = curved > 0 ? before / curved : curved <= 0 ? 0 : (double)NAN;
    struct sums sums = go_ahead(b, (float)length);
    b->descent = exact_value(&sums.first);
    turn(b, before > 0 ? (float)(b->descent / before) : 0);
    step->residual = exact_value(&sums.second) * residual_scale(b, step);
}

void cpu_drift(struct backend *b, struct step *step)
{
    const struct explicit_constants *c = &b->choice.each;
    struct particles *p = &b->particles;
    const struct position *x0 = p->before[FIELD_POSITION];
    const struct rate *rate = particles_rate(p);
    const struct stencil *stencil = p->now[FIELD_STENCIL];
    float limit = 0.25f * c->spacing * c->spacing; /* half a spacing */
    struct extremes all = extremes_none();
#pragma omp parallel
    {
        struct extremes own = extremes_none();
#pragma omp for schedule(static)
        for (size_t i = 0; i < p->count; i++) {
            struct motion *v = &particles_motion(p)[i];
            float v2 = 0, a2 = 0;
            float move2 = projection_move(c, step->dt, &x0[i], rate[i].acceleration,
                                          stencil[i].crowd, &particles_position(p)[i], v);
            for (int a = 0; a < 3; a++) {
                v2 += v->velocity[a] * v->velocity[a];
                a2 += rate[i].acceleration[a] * rate[i].acceleration[a];
            }
            own.move2 = move2 > own.move2 ? move2 : own.move2;
            own.speed2 = v2 > own.speed2 ? v2 : own.speed2;
            own.acceleration2 = a2 > own.acceleration2 ? a2 : own.acceleration2;
            if (!(move2 <= limit) || !(v2 < FLT_MAX) || !(fabsf(v->pressure) < FLT_MAX))
                own.bad = particles_id(p)[i] < own.bad ? particles_id(p)[i] : own.bad;
        }
#pragma omp critical
        extremes_merge(&all, &own);
    }
    step->extremes = all;
}
