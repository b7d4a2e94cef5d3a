/* Stops particles at obstacles, as closed planes do (solver/explicit.h): boundary particles push, but a fast
 * one may come through.
 *
 * Places count from the obstacle's middle in units of position, so that the nearest periodic image and
 * differences are exact. In the common subset of C and CUDA: + - * / and square roots only. */
#ifndef SOLVER_OBSTACLE_H
#define SOLVER_OBSTACLE_H

#include "particles/particles.h"
#include "scene/scene.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

struct obstacle {
    uint32_t middle[3]; /* counts */
    int64_t low[3], high[3]; /* flat faces, counts from the middle; OBSTACLE_FAR where fluid does not reach one */
    bool flat[3];       /* axes that flat faces bound; the others are round */
    double radius;      /* of the round axes, m */
};
#define OBSTACLE_FAR ((int64_t)1 << 40)

struct obstacles {
    int count;
    double unit[3];     /* m per count */
    float restitution;
    struct obstacle obstacle[OBSTACLES_MAX];
};

/* The way out that is shortest: through a flat face of `axis`, up or down, or along `direction`. */
struct obstacle_exit {
    double depth;        /* m */
    int axis;            /* -1: round */
    bool up;
    double direction[3]; /* unit vector */
};

/* Whether a place is inside; then the round way out from it. */
static inline bool obstacle_round(const struct obstacles *c, const struct obstacle *o, const int32_t at[3],
                                  struct obstacle_exit *out)
{
    double square = 0;
    for (int a = 0; a < 3; a++) {
        out->direction[a] = o->flat[a] ? 0 : (double)at[a] * c->unit[a];
        square += out->direction[a] * out->direction[a];
    }
    if (!(square < o->radius * o->radius))
        return false;
    double distance = sqrt(square);
    for (int a = 0; a < 3; a++)
        out->direction[a] = distance > 0 ? out->direction[a] / distance : 0;
    if (!(distance > 0)) /* in the very middle any direction is out */
        out->direction[o->flat[0] ? 1 : 0] = 1;
    out->depth = o->radius - distance;
    out->axis = -1;
    return true;
}

static inline bool obstacle_find(const struct obstacles *c, const struct obstacle *o, const int32_t at[3],
                                 struct obstacle_exit *out)
{
    for (int a = 0; a < 3; a++)
        if (o->flat[a] && !(at[a] > o->low[a] && at[a] < o->high[a]))
            return false;
    out->depth = (double)OBSTACLE_FAR;
    if (!(o->flat[0] && o->flat[1] && o->flat[2]) && !obstacle_round(c, o, at, out))
        return false;
    for (int a = 0; a < 3; a++) {
        double below = (double)(at[a] - o->low[a]) * c->unit[a], above = (double)(o->high[a] - at[a]) * c->unit[a];
        double depth = below < above ? below : above;
        if (!o->flat[a] || !(depth < out->depth))
            continue;
        out->depth = depth;
        out->axis = a;
        out->up = !(below < above);
        for (int b = 0; b < 3; b++)
            out->direction[b] = b != a ? 0 : out->up ? 1 : -1;
    }
    return true;
}

/* Just outside, at least a count. */
static inline void obstacle_leave(const struct obstacles *c, const struct obstacle *o,
                                  const struct obstacle_exit *out, uint32_t count[3])
{
    for (int a = 0; a < 3; a++) {
        if (out->axis == a) {
            count[a] = o->middle[a] + (uint32_t)(out->up ? o->high[a] : o->low[a]);
        } else if (out->axis < 0 && out->direction[a] != 0) {
            double to = out->direction[a] * o->radius / c->unit[a];
            count[a] = o->middle[a] + (uint32_t)(int32_t)(to + (to > 0 ? 1 : -1));
        }
    }
}

/* Turns the velocity outwards, with what a bounce leaves of it. */
static inline void obstacle_bounce(const struct obstacles *c, const struct obstacle_exit *out, float velocity[3])
{
    double into = 0;
    for (int a = 0; a < 3; a++)
        into -= out->direction[a] * (double)velocity[a];
    for (int a = 0; a < 3 && into > 0; a++)
        velocity[a] += (float)(out->direction[a] * into * (1 + (double)c->restitution));
}

/* Moves a particle that got into an obstacle to its surface, and reflects its velocity; returns whether it did. Where
 * that is inside another one, where they join, the particle stays at `before` the step, without speed. */
static inline bool obstacles_stop(const struct obstacles *c, const uint32_t before[3], uint32_t count[3],
                                  float velocity[3])
{
    bool inside = true, stopped = false;
    for (int round = 0; round < 3 && inside; round++) {
        inside = false;
        for (int k = 0; k < c->count; k++) {
            const struct obstacle *o = &c->obstacle[k];
            struct obstacle_exit out = {0};
            int32_t at[3];
            for (int a = 0; a < 3; a++)
                at[a] = (int32_t)(count[a] - o->middle[a]);
            if (!obstacle_find(c, o, at, &out))
                continue;
            inside = stopped = true;
            obstacle_leave(c, o, &out, count);
            obstacle_bounce(c, &out, velocity);
        }
    }
    for (int a = 0; a < 3 && inside; a++) {
        count[a] = before[a];
        velocity[a] = 0;
    }
    return stopped;
}

#endif
