/* What the projection solver does to each particle, around the sums over its neighbours.
 *
 * Incompressible SPH by projection (Cummins & Rudman 1999; Lind et al. 2012), in kick-drift-kick
 * form. A step begins with positions x(n), the velocity w(n) = v(n-1/2) + a dt/2 predicted there and
 * the pressure Q of the last step:
 *   u = v(n-1/2) + dt/2 (g + viscosity)                       kick without pressure
 *   sum_j F_ij (P_i - P_j) + s_i P_i = -2 rho/dt div_i u      Poisson's equation
 *   v(n) = u - dt/(2 rho) grad P,   Q <- (Q + P)/2
 *   a = g + viscosity - grad Q/rho
 *   v(n+1/2) = v(n) + a dt/2;  x(n+1) = x(n) + dt v(n+1/2) + shift
 * Q is the mean pressure of the step that ended; P makes up for what it was wrong by, so that the
 * two half kicks together are of second order and no error of Q alternates from step to step.
 *
 * F_ij = -2 V_j W'/r is the Laplacian of Morris et al. 1997: symmetric, its off-diagonal entries of
 * one sign, so that P >= 0 wherever fluid is compressed and conjugate gradients converge fast.
 *   walls   dP/dn = 0 as F lacks the neighbours behind it; fluid mirrored in the plane comes closer
 *           at twice the normal speed, which makes div u consistent with F for P linear
 *   surface P = 0 at a distance e above the particle: s = 2 |G|/e, with G what the gradients of the
 *           kernel lack and e from the lack of density by the inverse of the half space's table.
 *           A linear P is then exact there too. (Instead of particles declared to be the surface.)
 * Where fluids differ in density, F_ij is 2 R / (rho0_i + rho0_j) times as large, with R the largest of
 * them, in this equation and in the gradients of P and of the shift, so that the flux between two
 * fluids is continuous; R then stands for rho.
 * Deep inside, gradients are corrected by the inverse first moment (Randles & Libersky 1996) and use
 * P_j - P_i; near a surface they use P_j + P_i, which with the plain divergence is its adjoint and
 * gains no energy. In the common subset of C and CUDA. */
#ifndef SOLVER_PROJECTION_H
#define SOLVER_PROJECTION_H

#include "solver/explicit.h"
#include "solver/stir.h"
#include "solver/tension.h"

struct projection_constants {
    float gradient;   /* struct pair_constants */
    float laplacian;  /* -2 gradient / h, 1/m^2: times V slope it is F */
    float volume[FLUIDS_MAX]; /* V = m / rho0, in d^3 */
    float reference;  /* the largest rest density R, kg/m^3 */
    float lighter[FLUIDS_MAX]; /* R / rho0 */
    bool mixed;       /* fluids differ in rest density */
    float loose;      /* lack of density from which a particle is at the surface */
    float torn;       /* and from which its fluid comes apart without resistance */
    float gain;       /* part of a density error that a step's shift takes back */
    float slack;      /* density error that is left at a surface */
    float most;       /* density error that one step takes back at most */
    float fickian;    /* 2 A h, m: shift per gradient of concentration, speed and time */
    float fringe;     /* part of it at a surface */
    float whole;      /* sum F on the lattice, 1/m^2 */
    float self;       /* F of a neighbour at d/2, which a particle counts itself as */
    float closeness;  /* 1 / w(d) */
    float slope;      /* of the kernel at d, as in F; negative */
    bool enclosed;    /* no surface */
};

/* What does not change during a step's solves: 32 words. */
struct stencil {
    alignas(16) float inverse[6];  /* B, inverse of -sum V_j x (x) grad W with what walls lack: xx yy zz xy xz yz */
    float toward[3];   /* G = sum V_j grad W, 1/m */
    float wall[3];     /* what walls add to it, 1/m */
    float missing[3];  /* what they lack in the first moment, along their normals */
    float along[3];    /* 1 / what other axes' walls leave open */
    float crowd[3];    /* sum V_j (1 + 0.2 (W/W(d))^4) grad W with walls, 1/m; then the shift, m */
    float carried[3];  /* what the velocity changes by along the shift, m/s */
    float lack;        /* 1 - rho/rho0 */
    float spread;      /* sum F, 1/m^2 */
    float fringe;      /* 1 near a surface, 0 inside */
    float speed;       /* U: largest close speed difference to a neighbour, m/s */
    float crowding;    /* sum F_ij f_j of the last step's shift */
    float jump;        /* pressure of the surface by its tension, Pa */
    float spare[2];
};

/* One row of a linear system that conjugate gradients solve. */
struct unknown {
    alignas(16) float diagonal; /* 1/m^2 */
    float inverse;  /* 1 / diagonal; 0: the unknown stays as it is */
    float residual;
    float value;    /* Pa; of a shift m^2 */
};

/* What gradients are taken of. */
struct trial {
    alignas(16) float pressure; /* P, Pa */
    float mean;     /* Q, Pa */
    float shift;    /* m^2: its negative gradient is the displacement */
    float spare;
};

/* Sums over the neighbours of what first depends on positions only. */
struct stencil_sums {
    float number;    /* sum V_j w, with wall particles */
    float toward[3]; /* sum V_j slope x */
    float crowd[3];  /* the same, closer ones counting more */
    float moment[6]; /* sum V_j slope x (x) x: xx yy zz xy xz yz */
    float weight;    /* sum F */
    float wall_number, wall_toward[3], wall_moment[3]; /* of wall particles alone: xx yy zz */
};

/* Walls' shares: `wall`, `missing`, `along`; returns the share of the density. */
static inline float projection_walls(const struct explicit_constants *c, const struct position *x,
                                     struct stencil *s)
{
    float open[3];
    for (int a = 0; a < 3; a++)
        s->wall[a] = s->missing[a] = 0;
    bool near = explicit_open(c, x, open);
    for (int a = 0; a < 3; a++)
        s->along[a] = 1 / (open[(a + 1) % 3] * open[(a + 2) % 3]);
    if (!near)
        return 0;
    for (int face = 0; face < 6; face++) {
        int n = face / 2;
        uint32_t count = plane_counts(c, face, x);
        if (count >= c->near[n])
            continue;
        float q = (float)count * c->q_per_count[n];
        float part = open[(n + 1) % 3] * open[(n + 2) % 3];
        float area = c->normal * part * plane_value(c->planes.area, q);
        s->wall[n] += (face & 1 ? area : -area) / c->h;
        s->missing[n] += part * plane_value(c->planes.volume, q) + area * q;
    }
    return 1 - open[0] * open[1] * open[2];
}

/* Adds wall particles, as if they were a plane across the sum of their gradients. */
static inline void projection_wall_particles(const struct explicit_constants *c,
                                             const struct projection_constants *m,
                                             const struct stencil_sums *sums, struct stencil *s)
{
    float g[3], size2 = 0;
    for (int a = 0; a < 3; a++) {
        g[a] = m->gradient * sums->wall_toward[a];
        size2 += g[a] * g[a];
    }
    if (!(size2 * c->h * c->h > 1e-8f))
        return;
    for (int a = 0; a < 3; a++) {
        float across = g[a] * g[a] / size2;
        float open = 1 - c->number_density * sums->wall_number * (1 - across);
        s->wall[a] += g[a];
        s->missing[a] -= across * m->gradient * c->h * sums->wall_moment[a];
        s->along[a] /= open > 0.25f ? open : 0.25f;
    }
}

/* B from the first moment; the identity where too few neighbours span it. Returns whether it is. */
static inline bool projection_inverse(const float m[6], float inverse[6])
{
    float xx = m[1] * m[2] - m[5] * m[5], xy = m[4] * m[5] - m[3] * m[2];
    float xz = m[3] * m[5] - m[4] * m[1];
    float det = m[0] * xx + m[3] * xy + m[4] * xz;
    bool spanned = det > 0.1f;
    float one = spanned ? 1 / det : 0, same = spanned ? 0 : 1;
    inverse[0] = one * xx + same;
    inverse[1] = one * (m[0] * m[2] - m[4] * m[4]) + same;
    inverse[2] = one * (m[0] * m[1] - m[3] * m[3]) + same;
    inverse[3] = one * xy;
    inverse[4] = one * xz;
    inverse[5] = one * (m[3] * m[4] - m[0] * m[5]);
    return spanned;
}

/* From the sums, and whether flow was `violent` before; returns rho/rho0. */
static inline float projection_stencil(const struct explicit_constants *c,
                                       const struct projection_constants *m,
                                       const struct position *x, float violent,
                                       const struct stencil_sums *sums, struct stencil *s)
{
    float share = projection_walls(c, x, s), moment[6];
    float ratio = c->number_density * sums->number + share;
    projection_wall_particles(c, m, sums, s);
    for (int k = 0; k < 6; k++)
        moment[k] = -m->gradient * c->h * sums->moment[k];
    for (int a = 0; a < 3; a++) {
        moment[a] += s->missing[a];
        s->toward[a] = m->gradient * sums->toward[a];
        s->crowd[a] = m->gradient * sums->crowd[a] + s->wall[a];
    }
    s->fringe = projection_inverse(moment, s->inverse) && !(violent > 0.3f) ? 0 : 1;
    s->lack = 1 - ratio;
    s->spread = sums->weight;
    /* Dense by walls alone, as a drop in an edge of the tank, is torn: it must be able to fall off. */
    if (sums->weight < 0.3f * m->whole * (1 - share) && s->lack < 1.01f * m->torn && !m->enclosed)
        s->lack = 1.01f * m->torn;
    s->speed = 0;
    return ratio;
}

/* The distance to the surface, in smoothing lengths, of fluid with a flat surface that lacks so much
 * density: where the table of half spaces, which falls, has that value. */
static inline float projection_depth(const struct explicit_constants *c, float lack)
{
    int low = 0, high = PLANE_STEPS;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (c->planes.volume[middle] > lack)
            low = middle;
        else
            high = middle;
    }
    float step = c->planes.volume[low] - c->planes.volume[high];
    float part = step > 0 ? (c->planes.volume[low] - lack) / step : 0;
    part = part < 0 ? 0 : part > 1 ? 1 : part;
    return ((float)low + part) * (2.0f / (float)PLANE_STEPS);
}

/* After `loose` is known of the particle and its neighbours (1 of any): what depends on the surface.
 * Inside, walls make up exactly for what the kernel's gradients lack. `crowding` is kept. */
static inline void projection_surface(const struct explicit_constants *c,
                                      const struct projection_constants *m, int fluid,
                                      float loose, float crowding, struct stencil *s,
                                      struct unknown *row)
{
    float sink = 0, size2 = 0;
    if (loose > 0)
        s->fringe = 1;
    for (int a = 0; a < 3; a++) {
        if (!(loose > 0) && s->wall[a] != 0)
            s->wall[a] = -s->toward[a];
        float lacks = s->toward[a] + s->wall[a];
        size2 += lacks * lacks;
    }
    if (loose > 0 && s->lack > 0) {
        float depth = projection_depth(c, s->lack) * c->h, least = 0.25f * c->spacing;
        sink = m->lighter[fluid] * 2 * sqrtf(size2) / (depth < least ? least : depth);
    }
    s->crowding = crowding;
    s->jump = 0;
    row->diagonal = s->spread + sink;
    row->inverse = row->diagonal * c->h * c->h > 1e-4f ? 1 / row->diagonal : 0;
}

/* The pressure jump at the surface from sums F s p and F s over neighbours; a particle at the surface
 * counts itself. */
static inline void projection_jump(const struct projection_constants *m, float sum, float weight,
                                   const struct normal *n, float own, struct stencil *s)
{
    float self = m->self * n->size;
    s->jump = weight + self > 1e-6f * m->self ? (sum + self * own) / (weight + self) : 0;
}

/* div u from tensor[3 a + b] = sum V_j (u_j - u_i)_a grad_b W. */
static inline float projection_divergence(const struct stencil *s, const float tensor[9],
                                          const float u[3])
{
    const float *b = s->inverse;
    float sum = 0;
    for (int a = 0; a < 3; a++)
        sum -= 2 * u[a] * s->wall[a];
    if (s->fringe > 0)
        return sum + s->along[0] * tensor[0] + s->along[1] * tensor[4] + s->along[2] * tensor[8];
    return sum + b[0] * tensor[0] + b[1] * tensor[4] + b[2] * tensor[8] +
           b[3] * (tensor[1] + tensor[3]) + b[4] * (tensor[2] + tensor[6]) +
           b[5] * (tensor[5] + tensor[7]);
}

/* The row of Poisson's equation for a step `before` that ended with these positions; none: the
 * pressure stays. It starts from the last pressure Q; `around` is sum F_ij Q_j. In torn fluid that expands
 * the pressure stays, too: it is 0 but in the first step after the fluid was torn. */
static inline void projection_row(const struct projection_constants *m, const struct stencil *s,
                                  float before, float divergence, float pressure,
                                  float around, struct unknown *row)
{
    bool fixed = !(before > 0) || (!m->enclosed && s->lack > m->torn && divergence > 0);
    float source = before > 0 ? -2 * m->reference / before * divergence : 0;
    source += (row->diagonal - s->spread) * s->jump;
    row->value = pressure;
    row->residual = source - (row->diagonal * pressure - around);
    if (fixed)
        row->inverse = 0;
}

/* R/rho grad p from difference = sum 2 R/(rho_i + rho_j) V_j (p_j - p_i) grad W; p is counted from the
 * surface's, and `beyond` is what walls continue it by, along each axis: the force per volume that they
 * must balance, Pa/m. */
static inline void projection_gradient(const struct stencil *s, float lighter, float p,
                                       const float difference[3], const float beyond[3],
                                       float gradient[3])
{
    const float *b = s->inverse;
    if (s->fringe > 0) {
        for (int a = 0; a < 3; a++)
            gradient[a] = s->along[a] * (difference[a] + 2 * lighter * p * (s->toward[a] + s->wall[a]));
        return;
    }
    float d[3];
    for (int a = 0; a < 3; a++)
        d[a] = difference[a] + s->missing[a] * beyond[a];
    gradient[0] = b[0] * d[0] + b[3] * d[1] + b[4] * d[2];
    gradient[1] = b[3] * d[0] + b[1] * d[1] + b[5] * d[2];
    gradient[2] = b[4] * d[0] + b[5] * d[1] + b[2] * d[2];
}

#define PROJECTION_ROUNDING 4e-6f /* of a sum over neighbours that is near 1 */

/* The density error that a shift takes back a part of. Where fluid is enclosed the mean cannot
 * change; at a surface only compression counts. Rounding does not: a lattice at rest stays still. */
static inline float projection_crowding(const struct projection_constants *m,
                                        const struct stencil *s, float mean)
{
    float error = -s->lack;
    if (s->fringe > 0)
        error = error > m->slack ? error - m->slack : 0;
    else
        error -= mean;
    if (fabsf(error) < PROJECTION_ROUNDING)
        return 0;
    error = error > m->most ? m->most : error < -m->most ? -m->most : error;
    return m->gain * error;
}

/* With P in `row`, which torn fluid does not have below 0: the mean pressure Q, and the row of the
 * equation sum_j F_ij (f_i - f_j) + s_i f_i = gain (rho/rho0 - 1) of the shift, which begins from the
 * last step's. */
static inline void projection_pressures(const struct projection_constants *m, float h,
                                        const struct stencil *s, float mean, float before,
                                        float old, float shift, struct unknown *row,
                                        struct trial *trial)
{
    bool torn = s->lack > m->torn && !m->enclosed;
    float p = row->value < s->jump && torn ? s->jump : row->value;
    trial->pressure = p;
    trial->mean = torn ? s->jump : before > 0 ? 0.5f * (old + p) : old;
    row->inverse = row->diagonal * h * h > 1e-4f ? 1 / row->diagonal : 0;
    row->residual = projection_crowding(m, s, mean) - (row->diagonal * shift - s->crowding);
    row->value = shift;
}

#define PROJECTION_STIR 0.2f

/* Displacement of a step down the gradient of concentration (Lind et al. 2012), in proportion to the
 * speed differences around, so that nothing shifts at rest; at a surface along it only. A lattice
 * under strain is in balance by symmetry and collapses late and violently unless it is stirred. The
 * velocity is that of the new place: `tensor` is sum V_j (u_j - u_i)_a grad_b W; but not where the particle `meets`
 * a fluid of another density: they slip past each other, and the momentum taken over would not be theirs. */
static inline void projection_fickian(const struct projection_constants *m, uint32_t id, float dt, bool meets,
                                      const float tensor[9], struct stencil *s)
{
    float most = s->speed * dt, part = 1, along = 0, size2 = 0, fick[3];
    const float *b = s->inverse;
    if (s->fringe > 0 && !m->enclosed) {
        float lacks2 = 1e-12f, dot = 0;
        part = s->lack > 1.3f * m->torn ? 0 : m->fringe;
        for (int a = 0; a < 3; a++) {
            float lacks = s->toward[a] + s->wall[a];
            lacks2 += lacks * lacks;
            dot += lacks * s->crowd[a];
        }
        along = s->lack > m->loose ? dot / lacks2 : 0;
    }
    for (uint32_t a = 0; a < 3; a++) {
        float crowd = s->crowd[a] - along * (s->toward[a] + s->wall[a]);
        float stir = s->fringe > 0 ? 0 : PROJECTION_STIR * stir_component(3 * id + a);
        fick[a] = part * most * (stir - m->fickian * crowd);
        size2 += fick[a] * fick[a];
    }
    float limit = size2 > most * most ? most / sqrtf(size2) : 1;
    for (int a = 0; a < 3; a++)
        s->crowd[a] = fick[a] *= limit;
    float d[3] = {b[0] * fick[0] + b[3] * fick[1] + b[4] * fick[2],
                  b[3] * fick[0] + b[1] * fick[1] + b[5] * fick[2],
                  b[4] * fick[0] + b[5] * fick[1] + b[2] * fick[2]};
    for (int a = 0; a < 3; a++)
        s->carried[a] = s->fringe > 0 || meets ? 0 : tensor[3 * a] * d[0] +
                                                            tensor[3 * a + 1] * d[1] +
                                                            tensor[3 * a + 2] * d[2];
}

/* Deep inside, gradients of differences do not stop a single particle that strays through the fluid: it
 * keeps half of the largest speed difference around from the mean of its neighbours, which smooth flow
 * never comes near; but not where it `meets` another fluid. `stray` is sum F (u_i - u_j). */
static inline void projection_stray(bool meets, const float stray[3], struct stencil *s)
{
    float size2 = 0, most = 0.5f * s->speed * s->spread;
    for (int a = 0; a < 3; a++)
        size2 += stray[a] * stray[a];
    if (s->fringe > 0 || meets || !(size2 > most * most))
        return;
    float part = (1 - most / sqrtf(size2)) / s->spread;
    for (int a = 0; a < 3; a++)
        s->carried[a] -= part * stray[a];
}

/* The part of the acceleration by the last step's pressure Q that the next half kick believes: all of
 * it in smooth flow, but an impact is over when it would be repeated. Where P or Q would move fluid by
 * more than a twentieth of a spacing in a step, and for some steps after, flow is `violent`: it gets
 * the gradients of a surface, which gain no energy. */
static inline float projection_trust(const struct explicit_constants *c, float before, float dt,
                                     const float p[3], const float q[3], float density,
                                     float *violent)
{
    float most = 0.05f * c->spacing * density, p2 = 0, q2 = 0;
    for (int a = 0; a < 3; a++) {
        p2 += p[a] * p[a];
        q2 += q[a] * q[a];
    }
    float last = before * before * sqrtf(p2), next = dt * dt * sqrtf(q2);
    *violent = last > most || next > most ? 1 : 0.8f * *violent;
    return next > most ? most / next : 1;
}

/* Adds the displacement down the gradient of the field that evens out the density. */
static inline void projection_lift(const struct explicit_constants *c, const float gradient[3],
                                   float shift[3])
{
    float most = 0.1f * c->spacing;
    for (int a = 0; a < 3; a++) {
        float lift = -gradient[a];
        shift[a] += lift > most ? most : lift < -most ? -most : lift;
    }
}

/* Second half of a step: moves a particle by v(n+1/2) dt + shift, off closed planes; v becomes the
 * velocity predicted there. Returns the square of the distance, m^2 (INFINITY when runaway). */
static inline float projection_move(const struct explicit_constants *c, float dt,
                                    const struct position *x0, const float acceleration[3],
                                    const float shift[3], struct position *x, struct motion *v)
{
    float move2 = 0;
    for (int a = 0; a < 3; a++) {
        float half = explicit_rest(c, v->velocity[a]), move = half * dt + shift[a];
        move2 += move * move;
        if (!(fabsf(move) <= c->spacing))
            return INFINITY;
        x->count[a] = x0->count[a] + (uint32_t)(int32_t)lrintf(move * c->per_metre[a]);
        if (c->closed[a] && ((int32_t)x->count[a] < (int32_t)c->low[a] || x->count[a] > c->high[a]))
            x->count[a] = explicit_bounce(c, a, x->count[a], &half);
        v->velocity[a] = half + 0.5f * dt * acceleration[a];
    }
    x->volume = x0->volume;
    return move2;
}

#endif
