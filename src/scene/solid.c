/* Finds which sides of an obstacle fluid reaches, and how far they are. */
#include "scene/solid.h"

#include <math.h>

/* A flat face nearer to the domain's than this part of a spacing lies on it. */
static const double touching = 1e-6;

/* Which sides lie on a face of the domain. A periodic face is a side like others, unless the obstacle goes on
 * behind it. */
static void find_open(const struct scene *scene, const double min[3], const double max[3], struct solid *solid)
{
    double slack = touching * scene->particles.spacing;
    for (int a = 0; a < 3; a++) {
        bool flat = shape_is_flat(&solid->shape, a);
        bool low = flat && fabs(min[a] - scene->domain.min[a]) <= slack;
        bool high = flat && fabs(max[a] - scene->domain.max[a]) <= slack;
        bool joined = scene->domain.walls[2 * a] == WALL_PERIODIC, both = low && high;
        solid->open[2 * a] = joined ? !both : !low;
        solid->open[2 * a + 1] = joined ? !both : !high;
        solid->period[a] = joined && !both ? scene->domain.max[a] - scene->domain.min[a] : 0;
    }
}

/* Moves the sides of the axis that fluid does not reach out by `far`. */
static void extend(struct solid *solid, int a, double far)
{
    double low = solid->open[2 * a] ? 0 : far, high = solid->open[2 * a + 1] ? 0 : far;
    struct shape *s = &solid->shape;
    if (s->kind == SHAPE_BOX) {
        s->min[a] -= low;
        s->max[a] += high;
    } else if (shape_is_flat(s, a)) {
        s->center[a] += (high - low) / 2;
        s->height += low + high;
    }
}

struct solid solid_make(const struct scene *scene, const struct scene_obstacle *obstacle)
{
    struct solid solid = {.shape = obstacle->shape};
    double min[3], max[3];
    shape_bounds(&obstacle->shape, min, max);
    find_open(scene, min, max, &solid);
    for (int a = 0; a < 3; a++) {
        solid.middle[a] = (min[a] + max[a]) / 2;
        extend(&solid, a, scene->domain.max[a] - scene->domain.min[a]);
    }
    return solid;
}

/* The image of p that is nearest to the obstacle. */
static void image(const struct solid *s, const double p[3], double at[3])
{
    for (int a = 0; a < 3; a++) {
        double period = s->period[a];
        at[a] = period > 0 ? p[a] - period * floor((p[a] - s->middle[a]) / period + 0.5) : p[a];
    }
}

double solid_distance(const struct solid *s, const double p[3])
{
    double at[3];
    image(s, p, at);
    return shape_distance(&s->shape, at);
}

void solid_push(const struct solid *s, double out, double p[3])
{
    double at[3], to[3];
    image(s, p, at);
    for (int a = 0; a < 3; a++)
        to[a] = at[a];
    shape_push(&s->shape, out, to);
    for (int a = 0; a < 3; a++)
        p[a] += to[a] - at[a];
}
