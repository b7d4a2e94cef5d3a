/* Particle shifting: particles drift towards where there are fewer, and the flow is as if they did
 * not (Sun et al. 2017, 2019).
 * In the common subset of C and CUDA. */
#ifndef SOLVER_SHIFT_H
#define SOLVER_SHIFT_H

#include "solver/explicit.h"
#include <stdlib.h>
#include <stdio.h>

struct shift {
    float velocity[3]; /* m/s, besides the fluid's own */
    float place;       /* 1 inside, less near a surface */
};

struct shift_sums {
    float crowd[3], place, number, fast, along[3], pressure;
};
static inline float envf(const char*n,float d){const char*s=getenv(n);return s?(float)atof(s):d;}
struct tune { float K,cap,lo,hi,mom,rho,c0,glob,tic,noise,tlo,thi,relax,rlo,rhi,wall;};
static inline const struct tune *tune(void)
{
    static struct tune t; static int done;
    if(!done){t=(struct tune){envf("SK",1),envf("SCAP",0.5f),envf("SLO",0.25f),envf("SHI",0.1f),envf("SMOM",1),envf("SRHO",1),envf("SC0",10),envf("SGLOB",0),envf("STIC",0),envf("SNOISE",0),envf("STLO",.25),envf("STHI",.1),envf("SRELAX",0),envf("SRLO",.1),envf("SRHI",.05),envf("SWALL",1)};done=1;}
    return &t;
}

/* gradient: what sums are multiplied by, 1/m */
static inline void shift_rate(const struct explicit_constants *c, int fluid, float gradient, float dt,
                              const struct position *x, float density, const struct shift_sums *s,
                              uint32_t id, struct rate *rate, struct shift *shift)
{
    const struct tune *t=tune();
    float crowd[3], place = s->place*gradient*c->h, open[3];
    for (int a = 0; a < 3; a++)
        crowd[a] = gradient * s->crowd[a];
    if (explicit_open(c, x, open))
        for (int face = 0; face < 6; face++) {
            int n = face / 2;
            uint32_t count = plane_counts(c, face, x);
            if (count >= c->near[n])
                continue;
            float q = (float)count * c->q_per_count[n];
            float part = open[(n + 1) % 3] * open[(n + 2) % 3];
            float area = c->normal * part * plane_value(c->planes.area, q) / c->h;
            crowd[n] -= (face & 1 ? -1.0f : 1.0f) * area;
            place += part * 3 * plane_value(c->planes.volume, q) + area * q * c->h;
        }
    float lack = 3 - place, lackp = t->wall>0?lack:3-s->place*gradient*c->h;
    float part = (t->lo - lack) / (t->lo - t->hi);
    part = part > 1 ? 1 : part < 0 ? 0 : part;
    float U = t->glob>0? t->glob : sqrtf(s->fast), u2 = 0;
    for (int a = 0; a < 3; a++) {
        shift->velocity[a] = -t->K * U * 2 * c->h * crowd[a] * part;
        id = id * 0x9e3779b1u + 0x7f4a7c15u; id ^= id >> 15; id *= 0x2c1b3c6du; id ^= id >> 13;
        shift->velocity[a] += t->noise * U * part * (float)(int32_t)id * 0x1p-31f;
        u2 += shift->velocity[a] * shift->velocity[a];
    }
    float most = t->cap * U, limit = u2 > most * most ? most / sqrtf(u2) : 1;
    for (int a = 0; a < 3; a++) {
        shift->velocity[a] *= limit;
        rate->acceleration[a] += t->mom * gradient * s->along[a];
    }
    rate->density += t->rho * gradient * s->pressure / (t->c0*t->c0);
    float in = (t->tlo - lackp) / (t->tlo - t->thi);
    float in2 = (t->rlo - lack) / (t->rlo - t->rhi);
    in2 = in2 > 1 ? 1 : in2 < 0 ? 0 : in2;
    float summed = c->mass[fluid] * (c->number_density * (1 + s->number) + 1 - open[0] * open[1] * open[2]);
    rate->density += t->relax * t->c0 / c->h * in2 * (summed - density);
    shift->place = 2 * (in > 1 ? 1 : in < 0 ? 0 : in);
    (void)fluid; (void)dt;
}

#endif
