/* Makes the boundary particles of obstacles, and room for them between those of bodies. */
#include "particles/fill_obstacles.h"

#include "base/portable_math.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

/* One obstacle on its way to points. */
struct filling {
    const struct scene *scene;
    const struct fill_solids *solids;
    size_t index;
    double depth;
    struct fill *fill;
    struct error *e;
};

void fill_solids_make(struct fill_solids *solids, const struct scene *scene)
{
    solids->scene = scene;
    for (size_t k = 0; k < scene->obstacle_count; k++)
        solids->solid[k] = solid_make(scene, &scene->obstacles[k]);
}

/* Whether the point is inside one of the first `count` obstacles. */
static bool is_inside(const struct fill_solids *solids, size_t count, const double p[3])
{
    for (size_t k = 0; k < count; k++)
        if (solid_distance(&solids->solid[k], p) < 0)
            return true;
    return false;
}

/* Adds the point unless it lies too deep, or in an earlier obstacle. */
static enum status add(const struct filling *f, const double p[3])
{
    double deepest = -f->depth * (1 + 1e-6);
    if (solid_distance(&f->solids->solid[f->index], p) < deepest || is_inside(f->solids, f->index, p))
        return STATUS_OK;
    return fill_add(f->fill, p, -1, f->e);
}

/* Whole pitches in a length, at least one. */
static long pitches(double length, double spacing)
{
    return (long)fmax(1, floor(length / spacing + 0.5));
}

static enum status fill_box(const struct filling *f)
{
    const struct shape *s = &f->scene->obstacles[f->index].shape;
    long n[3];
    for (int a = 0; a < 3; a++)
        n[a] = pitches(s->max[a] - s->min[a], f->scene->particles.spacing);
    for (long z = 0; z < n[2]; z++)
        for (long y = 0; y < n[1]; y++)
            for (long x = 0; x < n[0]; x++) {
                long cell[3] = {x, y, z};
                double p[3];
                for (int a = 0; a < 3; a++)
                    p[a] = s->min[a] + ((double)cell[a] + 0.5) * (s->max[a] - s->min[a]) / (double)n[a];
                if (add(f, p))
                    return f->e->status;
            }
    return STATUS_OK;
}

/* A ring about the cylinder's axis, at `along` metres from its middle. */
static enum status fill_ring(const struct filling *f, double radius, double along)
{
    const struct shape *s = &f->scene->obstacles[f->index].shape;
    long n = pitches(2 * pi * radius, f->scene->particles.spacing);
    int u = (s->axis + 1) % 3, v = (s->axis + 2) % 3;
    double r = n > 1 ? radius : 0;
    for (long i = 0; i < n; i++) {
        double p[3], angle = 2 * pi * ((double)i + 0.5) / (double)n;
        p[s->axis] = s->center[s->axis] + along;
        p[u] = s->center[u] + r * portable_cos(angle);
        p[v] = s->center[v] + r * portable_sin(angle);
        if (add(f, p))
            return f->e->status;
    }
    return STATUS_OK;
}

static enum status fill_cylinder(const struct filling *f)
{
    const struct shape *s = &f->scene->obstacles[f->index].shape;
    double d = f->scene->particles.spacing;
    long layers = pitches(s->height, d);
    for (long k = 0; k < layers; k++)
        for (double r = s->radius - d / 2; r > 0; r -= d)
            if (fill_ring(f, r, (((double)k + 0.5) / (double)layers - 0.5) * s->height))
                return f->e->status;
    return STATUS_OK;
}

/* A sphere's shell, a spiral of points with equal parts of its area (a Fibonacci lattice). */
static enum status fill_shell(const struct filling *f, double radius)
{
    static const double golden = 0.61803398874989485; /* turns from point to point */
    const struct shape *s = &f->scene->obstacles[f->index].shape;
    double d = f->scene->particles.spacing;
    long n = pitches(4 * pi * radius * radius, d * d);
    for (long i = 0; i < n; i++) {
        double turn = (double)i * golden, high = n > 1 ? 1 - (2 * (double)i + 1) / (double)n : 0;
        double angle = 2 * pi * (turn - floor(turn)), wide = sqrt(1 - high * high), r = n > 1 ? radius : 0;
        double p[3] = {s->center[0] + r * wide * portable_cos(angle), s->center[1] + r * high,
                       s->center[2] + r * wide * portable_sin(angle)};
        if (add(f, p))
            return f->e->status;
    }
    return STATUS_OK;
}

static enum status fill_sphere(const struct filling *f)
{
    const struct shape *s = &f->scene->obstacles[f->index].shape;
    double d = f->scene->particles.spacing;
    for (double r = s->radius - d / 2; r > 0 && r > s->radius - f->depth - d; r -= d)
        if (fill_shell(f, r))
            return f->e->status;
    return STATUS_OK;
}

enum status fill_obstacles(const struct scene *scene, double depth, struct fill *fill,
                           struct error *e)
{
    static enum status (*const make[])(const struct filling *) = {
        [SHAPE_BOX] = fill_box, [SHAPE_SPHERE] = fill_sphere, [SHAPE_CYLINDER] = fill_cylinder};
    struct fill_solids solids;
    fill_solids_make(&solids, scene);
    for (size_t i = 0; i < scene->obstacle_count; i++) {
        struct filling f = {scene, &solids, i, depth, fill, e};
        if (make[scene->obstacles[i].shape.kind](&f)) {
            fill_free(fill);
            return e->status;
        }
    }
    return STATUS_OK;
}

/* What is deeper than `depth` below the sides that fluid reaches: the shape made smaller. */
static struct shape core(const struct scene *scene, const struct scene_obstacle *obstacle, double depth)
{
    struct shape s = obstacle->shape;
    const struct solid solid = solid_make(scene, obstacle);
    s.radius = fmax(0, s.radius - depth);
    for (int a = 0; a < 3; a++) {
        double low = solid.open[2 * a] ? depth : 0, high = solid.open[2 * a + 1] ? depth : 0;
        s.min[a] += low;
        s.max[a] = fmax(s.min[a], s.max[a] - high);
        if (s.kind == SHAPE_CYLINDER && a == s.axis)
            s.height = fmax(0, s.height - low - high);
    }
    return s;
}

double fill_obstacles_estimate(const struct scene *scene, double depth)
{
    double volume = 0, d = scene->particles.spacing;
    for (size_t k = 0; k < scene->obstacle_count; k++) {
        const struct shape inner = core(scene, &scene->obstacles[k], depth);
        volume += shape_volume(&scene->obstacles[k].shape) - shape_volume(&inner);
    }
    return volume / (d * d * d);
}

bool fill_is_free(const struct fill_solids *solids, const double p[3])
{
    return !is_inside(solids, solids->scene->obstacle_count, p);
}

/* Through a periodic face to the other side. */
static void come_back(const struct scene *scene, double p[3])
{
    for (int a = 0; a < 3; a++) {
        double low = scene->domain.min[a], length = scene->domain.max[a] - low;
        if (scene->domain.walls[2 * a] == WALL_PERIODIC)
            p[a] -= length * floor((p[a] - low) / length);
    }
}

bool fill_make_room(const struct fill_solids *solids, double p[3])
{
    enum { ROUNDS = 4 }; /* off one obstacle may be towards another */
    const struct scene *scene = solids->scene;
    for (int round = 0; round < ROUNDS; round++) {
        for (size_t k = 0; k < scene->obstacle_count; k++)
            solid_push(&solids->solid[k], scene->particles.spacing / 2, p);
        come_back(scene, p);
        fill_keep_inside(scene, p);
    }
    return fill_is_free(solids, p);
}
