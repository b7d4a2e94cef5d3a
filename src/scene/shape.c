/* Geometry of shapes: volume, bounds, distance, what two have in common. */
#include "scene/shape.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

const char *const shape_words[] = {"box", "sphere", "cylinder"};

double shape_volume(const struct shape *s)
{
    switch (s->kind) {
    case SHAPE_BOX:
        return (s->max[0] - s->min[0]) * (s->max[1] - s->min[1]) * (s->max[2] - s->min[2]);
    case SHAPE_SPHERE:
        return 4 * pi / 3 * s->radius * s->radius * s->radius;
    case SHAPE_CYLINDER:
        return pi * s->radius * s->radius * s->height;
    }
    return 0;
}

void shape_bounds(const struct shape *s, double min[3], double max[3])
{
    for (int a = 0; a < 3; a++) {
        double half = s->kind == SHAPE_CYLINDER && a == s->axis ? s->height / 2 : s->radius;
        min[a] = s->kind == SHAPE_BOX ? s->min[a] : s->center[a] - half;
        max[a] = s->kind == SHAPE_BOX ? s->max[a] : s->center[a] + half;
    }
}

bool shape_is_flat(const struct shape *s, int axis)
{
    return s->kind == SHAPE_BOX || (s->kind == SHAPE_CYLINDER && axis == s->axis);
}

bool shape_contains(const struct shape *s, const double p[3])
{
    double square = 0;
    for (int a = 0; a < 3 && s->kind != SHAPE_BOX; a++)
        if (!shape_is_flat(s, a))
            square += (p[a] - s->center[a]) * (p[a] - s->center[a]);
    return square <= s->radius * s->radius;
}

/* Where p is in a frame in which the shape is a box about 0: of a box each axis, of a sphere the distance
 * from its middle, of a cylinder the distance from its axis and the place along it. Each part comes with its
 * half size and its direction in space. */
struct part {
    double at, half, direction[3];
};

static void flat_part(const struct shape *s, int axis, const double p[3], struct part *part)
{
    double min[3], max[3];
    shape_bounds(s, min, max);
    double off = p[axis] - (min[axis] + max[axis]) / 2;
    *part = (struct part){.at = fabs(off), .half = (max[axis] - min[axis]) / 2};
    part->direction[axis] = off < 0 ? -1 : 1;
}

static void round_part(const struct shape *s, const double p[3], struct part *part)
{
    double square = 0;
    *part = (struct part){.half = s->radius};
    for (int a = 0; a < 3; a++) {
        part->direction[a] = shape_is_flat(s, a) ? 0 : p[a] - s->center[a];
        square += part->direction[a] * part->direction[a];
    }
    part->at = sqrt(square);
    for (int a = 0; a < 3; a++)
        part->direction[a] = part->at > 0 ? part->direction[a] / part->at : 0;
    if (!(part->at > 0)) /* in the very middle any direction is out */
        part->direction[shape_is_flat(s, 0)] = 1;
}

static int parts_make(const struct shape *s, const double p[3], struct part part[3])
{
    int count = 0;
    if (s->kind != SHAPE_BOX)
        round_part(s, p, &part[count++]);
    for (int a = 0; a < 3; a++)
        if (shape_is_flat(s, a))
            flat_part(s, a, p, &part[count++]);
    return count;
}

/* Distance of p from the surface and the unit normal there. */
static double surface_near(const struct shape *s, const double p[3], double normal[3])
{
    struct part part[3];
    int count = parts_make(s, p, part), deepest = 0;
    double square = 0;
    for (int k = 0; k < count; k++) {
        double out = part[k].at - part[k].half;
        square += out > 0 ? out * out : 0;
        if (out > part[deepest].at - part[deepest].half)
            deepest = k;
    }
    double distance = square > 0 ? sqrt(square) : part[deepest].at - part[deepest].half;
    for (int a = 0; a < 3; a++) {
        normal[a] = square > 0 ? 0 : part[deepest].direction[a];
        for (int k = 0; k < count && square > 0; k++)
            normal[a] += fmax(0, part[k].at - part[k].half) / distance * part[k].direction[a];
    }
    return distance;
}

double shape_distance(const struct shape *s, const double p[3])
{
    double normal[3];
    return surface_near(s, p, normal);
}

void shape_push(const struct shape *s, double out, double p[3])
{
    double normal[3], distance = surface_near(s, p, normal);
    for (int a = 0; a < 3 && distance < out; a++)
        p[a] += (out - distance) * normal[a];
}

/* Moves p from outside the disc or ball of radius r about c to its rim; `skip` is an axis left
 * alone, or -1. */
static void project_round(double p[3], const double c[3], double r, int skip)
{
    double square = 0;
    for (int a = 0; a < 3; a++)
        square += a == skip ? 0 : (p[a] - c[a]) * (p[a] - c[a]);
    double part = square > r * r ? r / sqrt(square) : 1;
    for (int a = 0; a < 3; a++)
        if (a != skip)
            p[a] = c[a] + (p[a] - c[a]) * part;
}

/* The point of the shape, made smaller by `slack` all around, that is nearest to p. */
static void shape_project(const struct shape *s, double slack, double p[3])
{
    double min[3], max[3];
    shape_bounds(s, min, max);
    if (s->kind != SHAPE_BOX)
        project_round(p, s->center, fmax(s->radius - slack, 0),
                      s->kind == SHAPE_CYLINDER ? s->axis : -1);
    for (int a = 0; a < 3; a++)
        if (shape_is_flat(s, a))
            p[a] = fmin(fmax(p[a], min[a] + slack), max[a] - slack);
}

/* Alternating projections between convex bodies tend to a nearest pair of points (Cheney and
 * Goldstein 1959). The distance found only shrinks and is never too small, so shapes that touch
 * pass. */
bool shape_overlap(const struct shape *a, const struct shape *b, double slack)
{
    double p[3], q[3], amin[3], amax[3], bmin[3], bmax[3];
    shape_bounds(a, amin, amax);
    shape_bounds(b, bmin, bmax);
    for (int k = 0; k < 3; k++) {
        if (amin[k] + slack >= bmax[k] || bmin[k] + slack >= amax[k])
            return false;
        p[k] = (fmax(amin[k], bmin[k]) + fmin(amax[k], bmax[k])) / 2;
    }
    double before = INFINITY;
    for (int i = 0; i < 1000; i++) {
        double square = 0;
        shape_project(a, slack / 2, p);
        for (int k = 0; k < 3; k++)
            q[k] = p[k];
        shape_project(b, slack / 2, q);
        for (int k = 0; k < 3; k++) {
            square += (p[k] - q[k]) * (p[k] - q[k]);
            p[k] = q[k];
        }
        if (square < slack * slack / 100)
            return true;
        if (square > before * (1 - 1e-6)) /* settled apart */
            return false;
        before = square;
    }
    return false;
}
