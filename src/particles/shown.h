/* What pictures show of the state: where each particle is, and a number or a colour of it, in order of ids. Back
 * ends run shown_particle for every particle, on processors or a GPU. In the common subset of C and CUDA. */
#ifndef PARTICLES_SHOWN_H
#define PARTICLES_SHOWN_H

#include "particles/particles.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

enum shown_value {
#define VALUE(name, expression) VALUE_##name,
#include "particles/shown_values.h"
#undef VALUE
    VALUE_COUNT
};

enum { SHOWN_FLUIDS = 16 };

/* Where it goes: of each particle, those of walls behind the others. */
struct shown_to {
    float *position; /* 3 each, m, relative to domain.min; NAN where it is not shown */
    uint32_t *word;  /* bits of the value (float), or RGBA bytes, red in the lowest */
};

struct shown {
    /* the state, in any order; of the fields only what `value` reads */
    const struct position *position;
    const struct motion *motion;
    const float *density, *vorticity;
    const uint32_t *id;
    const uint8_t *fluid; /* NULL: one fluid */
    size_t count;
    const struct position *wall_position;
    const uint32_t *wall_id;
    size_t wall_count;    /* 0 unless `walls` */
    bool walls;           /* particles of walls are shown */
    /* what is shown of it */
    enum shown_value value;
    bool solid;           /* the fluid's colour instead of a value */
    const float *fixed;   /* by id: values that never change, or NULL */
    float rest_density[SHOWN_FLUIDS]; /* kg/m^3 */
    uint32_t color[SHOWN_FLUIDS], wall_color;
    float wall_value;
    double origin[3], unit[3]; /* of struct space: m */
    double min[3];             /* of the domain, m */
    /* which are shown */
    bool visible[SHOWN_FLUIDS];
    double clip_min[3], clip_max[3], range[2]; /* m, and of values; NAN: without end */
    struct shown_to to;
};

#ifndef __cplusplus
/* Where a back end has them. */
static inline void shown_from(struct shown *s, const struct particles *p, const struct particles *walls)
{
    s->position = p->now[FIELD_POSITION];
    s->motion = p->now[FIELD_MOTION];
    s->density = p->now[FIELD_DENSITY];
    s->vorticity = p->now[FIELD_VORTICITY];
    s->id = p->now[FIELD_ID];
    s->fluid = p->now[FIELD_FLUID];
    s->count = p->count;
    s->wall_position = walls->now[FIELD_POSITION];
    s->wall_id = walls->now[FIELD_ID];
    s->wall_count = s->walls ? walls->count : 0;
}
#endif

static inline float shown_speed(const float v[3])
{
    return sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

static inline int shown_fluid(const struct shown *s, size_t i)
{
    return s->fluid ? s->fluid[i] : 0;
}

static inline float shown_value(const struct shown *s, size_t i)
{
    switch (s->value) {
#define VALUE(name, expression)                                                                    \
    case VALUE_##name: return expression;
#include "particles/shown_values.h"
#undef VALUE
    default: return 0;
    }
}

/* Whether a place in the domain, and a value there, are within what the picture is cut to. */
static inline bool shown_within(const struct shown *s, const float at[3], float value)
{
    for (int a = 0; a < 3; a++) {
        double x = s->min[a] + (double)at[a];
        if (x < s->clip_min[a] || x > s->clip_max[a]) /* NAN: neither */
            return false;
    }
    return !((double)value < s->range[0] || (double)value > s->range[1]);
}

/* Hands particle k of the picture on. */
static inline void shown_put(const struct shown *s, size_t k, const struct position *x, uint32_t word,
                             float value, bool visible)
{
    float at[3];
    for (int a = 0; a < 3; a++)
        at[a] = (float)(s->origin[a] + x->count[a] * s->unit[a] - s->min[a]);
    visible = visible && shown_within(s, at, value);
    for (int a = 0; a < 3; a++)
        s->to.position[3 * k + (size_t)a] = visible ? at[a] : NAN;
    s->to.word[k] = word;
}

/* Particle i in memory; from `count` on, those of walls. */
static inline void shown_particle(const struct shown *s, size_t i)
{
    const bool wall = i >= s->count;
    const size_t j = wall ? i - s->count : i;
    const int fluid = wall ? 0 : shown_fluid(s, j);
    const float value = s->solid ? NAN : wall ? s->wall_value : shown_value(s, j);
    uint32_t word = wall ? s->wall_color : s->color[fluid];
    if (!s->solid)
        memcpy(&word, &value, sizeof word);
    if (wall)
        shown_put(s, s->count + s->wall_id[j], &s->wall_position[j], word, NAN, true);
    else
        shown_put(s, s->id[j], &s->position[j], word, value, s->visible[fluid]);
}

#endif
