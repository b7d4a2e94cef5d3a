/* The pair sums of solver/pair.h in plain double precision, from their equations. */
#ifndef TESTS_PAIRS_REFERENCE_H
#define TESTS_PAIRS_REFERENCE_H

#include "pairs.h"

/* A sum, and how large its terms can be: rounding is judged by that. */
struct reference {
    double rate[4], scale[4]; /* dv/dt, drho/dt */
};

/* w'(q)/q of the kernel that the flags select; poly6's sigma goes with Mueller's spiky. */
static inline double reference_slope(unsigned flags, double q)
{
    double u = q / 2;
    if (q >= 2 || (q == 0 && flags & (PAIR_MULLER | 1))) /* no direction, and no singularity */
        return 0;
    if (flags & PAIR_MULLER)
        return -32.0 / 7 * (1 - u) * (1 - u) / q;
    if (flags & 1)
        return q < 1 ? -3 + 2.25 * q : -0.75 * (2 - q) * (2 - q) / q;
    return -5 * (1 - u) * (1 - u) * (1 - u);
}

static inline double reference_value(unsigned flags, double q)
{
    return q >= 2 ? 0
           : flags & PAIR_MULLER ? kernel_poly6.value(q)
           : flags & 1           ? kernel_cubic_spline.value(q)
                                 : kernel_wendland_c2.value(q);
}

static inline double reference_between(const struct cloud *c, const struct position *i,
                                       const struct position *j, double x[3])
{
    double q2 = 0;
    for (int a = 0; a < 3; a++) {
        x[a] = (int32_t)(i->count[a] - j->count[a]) * c->space.unit[a];
        q2 += x[a] * x[a];
    }
    return sqrt(q2);
}

static inline double reference_number(const struct cloud *c, unsigned flags, size_t i)
{
    const struct position *x = particles_position(&c->particles);
    double sum = 0, apart[3];
    const struct position *wall = particles_position(&c->wall);
    for (size_t j = 0; j < c->count; j++)
        sum += reference_value(flags, reference_between(c, &x[i], &x[j], apart));
    for (size_t j = 0; j < c->wall_count; j++)
        sum += wall[j].volume * reference_value(flags, reference_between(c, &x[i], &wall[j], apart));
    return sum;
}

/* One side of a pair: a particle, or a wall particle as i sees it. */
struct reference_side {
    double volume, velocity[3], pressure, viscosity, rest;
};

static inline struct reference_side reference_side(const struct cloud *c, size_t i)
{
    const struct motion *m = &particles_motion(&c->particles)[i];
    return (struct reference_side){
        particles_position(&c->particles)[i].volume,
        {m->velocity[0], m->velocity[1], m->velocity[2]},
        m->pressure,
        ((const float *)c->particles.now[FIELD_VISCOSITY])[i],
        c->rest_density[particles_fluid(&c->particles, i)]};
}

/* Adds what j does to i, x = x_i - x_j, both in units of h = 1 m and V in d^3. */
static inline void reference_add(const struct cloud *c, unsigned flags, struct reference *r,
                                 size_t at, const struct reference_side *i,
                                 const struct reference_side *j, const double x[3], double q)
{
    const struct pair_constants *k = &c->constants;
    double rho = particles_density(&c->particles)[at], front = k->gradient / rho;
    double rho0 = c->rest_density[particles_fluid(&c->particles, at)];
    double slope = reference_slope(flags, q), most = q < 2.001 ? 5 / fmax(fmin(q, 0.5), 1e-9) : 0;
    double dot = 0, v = 0, head = 0, mu = 2 * 0.7;
    for (int a = 0; a < 3; a++) {
        dot += (i->velocity[a] - j->velocity[a]) * x[a];
        v += fabs(i->velocity[a] - j->velocity[a]);
        head += k->head[a] * rho0 * x[a];
    }
    double push = j->volume * (i->pressure + j->pressure), pull = 0;
    double size = fabs(i->pressure) + fabs(j->pressure);
    if (flags & PAIR_SYMMETRIC)
        push = i->volume * i->pressure + j->volume * j->volume / i->volume * j->pressure;
    double both = i->rest + j->rest, mean = flags & PAIR_MIXED ? 2 * i->rest * j->rest / both : 1;
    if (flags & PAIR_MIXED)
        push = 2 * j->volume * (j->rest * i->pressure + i->rest * j->pressure) / both;
    if (flags & PAIR_ARTIFICIAL)
        push += j->volume * k->artificial * mean * (dot < 0 ? -dot / q : 0.0);
    if (flags & PAIR_DRAG_ONLY)
        push = 0;
    if (flags & PAIR_OWN_VISCOSITY)
        mu = i->viscosity + j->viscosity;
    if (flags & (PAIR_VISCOUS | PAIR_OWN_VISCOSITY))
        pull = mu * j->volume * (flags & PAIR_MULLER ? -16.0 / 7 * (q < 2 ? 1 - q / 2 : 0) : slope);
    double central = flags & PAIR_CENTRAL ? 1 : 0;
    for (int a = 0; a < 3; a++) {
        double drag = (1 - central) * (i->velocity[a] - j->velocity[a]);
        drag += central * k->central * dot * x[a];
        r->rate[a] += front * (pull * drag - slope * push * x[a]);
        r->scale[a] += front * most * (5 * size + 400 * mean * v) * fmin(q, 1) + front * (15 + 75 * central) * v;
    }
    if (flags & PAIR_CONTINUITY)
        r->rate[3] += k->gradient * rho * j->volume * slope * dot;
    if (flags & PAIR_DIFFUSION && (!(flags & PAIR_MIXED) || i->rest == j->rest))
        r->rate[3] += k->gradient * k->diffusion * j->volume * slope *
                      (i->pressure - j->pressure - head);
    r->scale[3] += k->gradient * most * (2 * rho * v * fmin(q, 1) +
                                         k->diffusion * (size + fabs(head) + 1e4));
}

static inline struct reference reference_rate(const struct cloud *c, unsigned flags, bool walls,
                                              size_t at)
{
    const struct position *position = particles_position(&c->particles);
    struct reference_side i = reference_side(c, at);
    struct reference r = {{0}, {1, 1, 1, 1}};
    double x[3];
    for (int a = 0; a < 3; a++)
        r.rate[a] = c->constants.gravity[a];
    for (size_t j = 0; j < c->count; j++) {
        double q = reference_between(c, &position[at], &position[j], x);
        struct reference_side other = reference_side(c, j);
        if (j != at)
            reference_add(c, flags, &r, at, &i, &other, x, q);
    }
    for (size_t j = 0; walls && j < c->wall_count; j++) {
        const struct position *wall = &particles_position(&c->wall)[j];
        double q = reference_between(c, &position[at], wall, x);
        double own = fmax(i.pressure, 0), head = 0;
        for (int a = 0; a < 3; a++)
            head -= c->constants.head[a] * c->rest_density[particles_fluid(&c->particles, at)] * x[a];
        struct reference_side other = {wall->volume, {0}, fmax(own + fmin(head, 8 * own), 0),
                                       i.viscosity, i.rest};
        reference_add(c, flags & ~(unsigned)(PAIR_DIFFUSION | PAIR_SYMMETRIC), &r, at, &i, &other, x,
                      q);
    }
    return r;
}

#endif
