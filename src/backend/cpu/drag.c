/* Conjugate gradients of implicit viscosity on the cpu: what is around the matrix products. */
#include "backend/cpu/cpu.h"

#include "base/exact_sum.h"

#include <math.h>

/* Two inner products over particles, weighted by mass. */
struct sums {
    struct exact_sum first, second;
};

static void merge(struct sums *all, const struct sums *own)
{
#pragma omp critical(drag)
    {
        exact_merge(&all->first, &own->first);
        exact_merge(&all->second, &own->second);
    }
}

static double mass(const struct backend *b, size_t i)
{
    return (double)b->choice.each.mass[particles_fluid(&b->particles, i)];
}

static struct drag_block *block_of(const struct backend *b, size_t i)
{
    struct drag_block *block = b->particles.now[FIELD_BLOCK];
    return block ? &block[i] : NULL;
}

void cpu_drag_begin(struct backend *b, const struct step *step)
{
    struct particles *p = &b->particles;
    struct drag *search = p->now[FIELD_SEARCH], *remainder = p->now[FIELD_REMAINDER];
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->count; i++)
        drag_begin(&b->choice.each, particles_fluid(p, i), step->dt, &cpu_position(b)[i],
                   &particles_motion(p)[i], &search[i], &remainder[i], block_of(b, i));
}

static struct drag conditioned(const struct backend *b, size_t i)
{
    const struct drag *remainder = b->particles.now[FIELD_REMAINDER];
    const struct drag *product = b->particles.now[FIELD_FLUX];
    return drag_conditioned(&remainder[i], &product[i], block_of(b, i));
}

/* Residuals are relative to the velocities or to the first residual, which is the change by
 * viscosity, whichever is less; but not to less than rounding leaves. */
static double scale2(double speed2, double first)
{
    return fmax(fmin(speed2, first), 1e-6 * speed2);
}

void cpu_drag_residual(struct backend *b, struct step *step)
{
    const struct particles *p = &b->particles;
    struct drag *search = p->now[FIELD_SEARCH], *remainder = p->now[FIELD_REMAINDER];
    const struct drag *product = p->now[FIELD_FLUX];
    struct sums all = {0}, squares = {0};
#pragma omp parallel
    {
        struct sums own = {0}, own_squares = {0};
#pragma omp for schedule(static)
        for (size_t i = 0; i < p->count; i++) {
            struct drag *r = &remainder[i], z;
            exact_add(&own_squares.first, mass(b, i) * drag_speed2(step->dt, &search[i], r,
                                                                    block_of(b, i)));
            for (int a = 0; a < 3; a++)
                r->along[a] -= product[i].along[a];
            z = conditioned(b, i);
            exact_add(&own_squares.second, mass(b, i) * drag_dot(r, r));
            exact_add(&own.first, mass(b, i) * drag_dot(r, &z));
            for (int a = 0; a < 3; a++)
                search[i].along[a] = z.along[a];
        }
        merge(&all, &own);
        merge(&squares, &own_squares);
    }
    b->drag.product = exact_value(&all.first);
    b->drag.scale2 = scale2(exact_value(&squares.first), exact_value(&squares.second));
}

/* search . M search */
static double curvature(const struct backend *b)
{
    const struct particles *p = &b->particles;
    const struct drag *search = p->now[FIELD_SEARCH], *product = p->now[FIELD_FLUX];
    struct sums all = {0};
#pragma omp parallel
    {
        struct sums own = {0};
#pragma omp for schedule(static)
        for (size_t i = 0; i < p->count; i++)
            exact_add(&own.first, mass(b, i) * drag_dot(&search[i], &product[i]));
        merge(&all, &own);
    }
    return exact_value(&all.first);
}

/* Goes `length` search directions ahead; sums the residual's squares, preconditioned and not. */
static struct sums go_ahead(struct backend *b, float length)
{
    struct particles *p = &b->particles;
    struct drag *search = p->now[FIELD_SEARCH], *remainder = p->now[FIELD_REMAINDER];
    const struct drag *product = p->now[FIELD_FLUX];
    struct sums all = {0};
#pragma omp parallel
    {
        struct sums own = {0};
#pragma omp for schedule(static)
        for (size_t i = 0; i < p->count; i++) {
            struct drag *r = &remainder[i];
            for (int a = 0; a < 3; a++) {
                particles_motion(p)[i].velocity[a] += length * search[i].along[a];
                r->along[a] -= length * product[i].along[a];
            }
            struct drag z = conditioned(b, i);
            exact_add(&own.first, mass(b, i) * drag_dot(r, &z));
            exact_add(&own.second, mass(b, i) * drag_dot(r, r));
        }
        merge(&all, &own);
    }
    return all;
}

static void turn(struct backend *b, float keep)
{
    struct particles *p = &b->particles;
    struct drag *search = p->now[FIELD_SEARCH];
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < p->count; i++) {
        struct drag z = conditioned(b, i);
        for (int a = 0; a < 3; a++)
            search[i].along[a] = z.along[a] + keep * search[i].along[a];
    }
}

/* Sums that are not finite make velocities so, and the step is rejected when particles move. */
void cpu_drag_step(struct backend *b, struct step *step)
{
    double curved = curvature(b), before = b->drag.product;
    double length = curved > 0 ? before / curved : curved <= 0 ? 0 : (double)NAN;
    struct sums sums = go_ahead(b, (float)length);
    double next = exact_value(&sums.first), square = exact_value(&sums.second);
    turn(b, before > 0 ? (float)(next / before) : 0);
    b->drag.product = next;
    step->residual = square == 0 ? 0 : sqrt(square / b->drag.scale2);
}

/* v + r = v* + dt (A v + pull): the forces of pairs, as explicit steps add them, cancel in momentum and
 * what they keep of angular momentum; the residual alone would not. */
void cpu_drag_end(struct backend *b)
{
    const struct drag *remainder = b->particles.now[FIELD_REMAINDER];
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < b->particles.count; i++)
        for (int a = 0; a < 3; a++)
            particles_motion(&b->particles)[i].velocity[a] += remainder[i].along[a];
}
