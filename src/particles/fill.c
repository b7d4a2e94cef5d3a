/* Makes the starting points of bodies and of wall particles. */
#include "particles/fill.h"

#include "base/memory.h"
#include "particles/fill_obstacles.h"

#include <math.h>
#include <string.h>

/* Counter-based random numbers in [0,1): any (seed, index, draw) at once, in any order. */
static double random_unit(uint64_t seed, uint64_t index, uint64_t draw)
{
    uint64_t x = seed * 0x9e3779b97f4a7c15u + index * 0xd1342543de82ef95u + draw * 0xaf251af3b0f025b5u;
    for (int round = 0; round < 2; round++) {
        x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
        x = (x ^ x >> 27) * 0x94d049bb133111ebu;
        x ^= x >> 31;
    }
    return (double)(x >> 11) * 0x1p-53;
}

/* Nearly normal with unit variance: a sum of 12 uniforms, so no libm and no tail beyond 6. */
static double random_normal(uint64_t seed, uint64_t index, uint64_t draw)
{
    double sum = -6;
    for (uint64_t k = 0; k < 12; k++)
        sum += random_unit(seed, index, draw * 12 + k);
    return sum;
}

enum status fill_add(struct fill *fill, const double p[3], int body, struct error *e)
{
    if (fill->count == fill->room) {
        struct fill grown = {.count = fill->count, .room = fill->room ? 2 * fill->room : 4096};
        grown.point = memory_create("start points", grown.room, sizeof *grown.point, e);
        grown.body = grown.point ? memory_create("start points", grown.room, sizeof *grown.body, e) : NULL;
        if (!grown.body) {
            memory_free(grown.point);
            return e->status;
        }
        if (fill->count) {
            memcpy(grown.point, fill->point, fill->count * sizeof *fill->point);
            memcpy(grown.body, fill->body, fill->count * sizeof *fill->body);
        }
        fill_free(fill);
        *fill = grown;
    }
    memcpy(fill->point[fill->count], p, sizeof *fill->point);
    fill->body[fill->count++] = body;
    return STATUS_OK;
}

void fill_keep_inside(const struct scene *scene, double p[3])
{
    for (int a = 0; a < 3; a++) {
        double margin = 1e-3 * scene->particles.spacing;
        p[a] = fmax(scene->domain.min[a] + margin, fmin(scene->domain.max[a] - margin, p[a]));
    }
}

/* Lattice cells along each axis: as many whole spacings as fit, to a hundredth. */
static void lattice_size(double spacing, const double low[3], const double high[3], long n[3])
{
    for (int a = 0; a < 3; a++)
        n[a] = (long)fmax(1, floor((high[a] - low[a]) / spacing + 0.5));
}

double fill_cell_volume(const struct scene *scene, const struct scene_body *body)
{
    double low[3], high[3], d = scene->particles.spacing, volume = d * d * d;
    long n[3];
    shape_bounds(&body->shape, low, high);
    lattice_size(d, low, high, n);
    if (body->shape.kind == SHAPE_BOX || body->fill == FILL_RANDOM)
        for (int a = 0; a < 3; a++)
            volume *= (high[a] - low[a]) / ((double)n[a] * d);
    return volume;
}

/* Room for about `points` from the start, so that growing does not hold twice the memory. */
static enum status fill_reserve(struct fill *fill, double points, struct error *e)
{
    *fill = (struct fill){.room = (size_t)(points * 1.01) + 64};
    fill->point = memory_create("start points", fill->room, sizeof *fill->point, e);
    fill->body = fill->point ? memory_create("start points", fill->room, sizeof *fill->body, e) : NULL;
    if (!fill->body)
        fill_free(fill);
    return fill->body ? STATUS_OK : e->status;
}

double fill_bodies_estimate(const struct scene *scene)
{
    static const double part[] = {
        [SHAPE_BOX] = 1, [SHAPE_SPHERE] = 0.5236, [SHAPE_CYLINDER] = 0.7854}; /* of the bounds */
    double points = 0;
    for (size_t k = 0; k < scene->body_count; k++) {
        double low[3], high[3];
        long n[3];
        shape_bounds(&scene->bodies[k].shape, low, high);
        lattice_size(scene->particles.spacing, low, high, n);
        points += part[scene->bodies[k].shape.kind] * (double)n[0] * (double)n[1] * (double)n[2];
    }
    return points;
}

/* A body whose particles all start in obstacles. */
static enum status fail_empty(const struct scene *scene, size_t body, struct error *e)
{
    return scene_fail_at(scene, scene->bodies[body].place, e, "bodies.%zu lies in obstacles and has no particle; "
                         "move or remove it, or an obstacle", body);
}

static enum status fill_body(const struct fill_solids *solids, int index, struct fill *fill, struct error *e)
{
    const struct scene *scene = solids->scene;
    const struct scene_body *b = &scene->bodies[index];
    double low[3], high[3], d = scene->particles.spacing;
    size_t before = fill->count;
    long n[3];
    shape_bounds(&b->shape, low, high);
    lattice_size(d, low, high, n);
    uint64_t total = (uint64_t)n[0] * (uint64_t)n[1] * (uint64_t)n[2];
    for (uint64_t k = 0; k < total; k++) {
        long cell[3] = {(long)(k % (uint64_t)n[0]), (long)(k / (uint64_t)n[0] % (uint64_t)n[1]),
                        (long)(k / (uint64_t)n[0] / (uint64_t)n[1])};
        double p[3];
        for (int a = 0; a < 3; a++) {
            double pitch = (high[a] - low[a]) / (double)n[a];
            if (b->fill == FILL_RANDOM)
                p[a] = low[a] + (high[a] - low[a]) * random_unit(b->seed, k, (uint64_t)a);
            else
                p[a] = low[a] + ((double)cell[a] + 0.5) * (b->shape.kind == SHAPE_BOX ? pitch : d);
        }
        if (!shape_contains(&b->shape, p) || !fill_is_free(solids, p))
            continue;
        for (int a = 0; a < 3 && b->jitter > 0; a++)
            p[a] += d * b->jitter * random_normal(b->seed, k, (uint64_t)a + 3);
        fill_keep_inside(scene, p);
        if (scene->obstacle_count && !fill_make_room(solids, p))
            continue;
        if (fill_add(fill, p, index, e))
            return e->status;
    }
    return fill->count > before || !scene->obstacle_count ? STATUS_OK : fail_empty(scene, (size_t)index, e);
}

enum status fill_bodies(const struct scene *scene, struct fill *fill, struct error *e)
{
    struct fill_solids solids;
    fill_solids_make(&solids, scene);
    if (fill_reserve(fill, fill_bodies_estimate(scene), e))
        return e->status;
    for (size_t b = 0; b < scene->body_count; b++)
        if (fill_body(&solids, (int)b, fill, e)) {
            fill_free(fill);
            return e->status;
        }
    return STATUS_OK;
}

/* The lattice of the domain, n cells along each axis, and with its walls cells start to stop. */
static void wall_lattice(const struct scene *scene, double depth, long n[3], long start[3],
                         long stop[3])
{
    double d = scene->particles.spacing;
    long layers = (long)ceil(depth / d - 1e-6);
    lattice_size(d, scene->domain.min, scene->domain.max, n);
    for (int a = 0; a < 3; a++) {
        start[a] = scene->domain.walls[2 * a] == WALL_PARTICLES ? -layers : 0;
        stop[a] = n[a] + (scene->domain.walls[2 * a + 1] == WALL_PARTICLES ? layers : 0);
    }
}

double fill_walls_estimate(const struct scene *scene, double depth)
{
    double whole = 1, inside = 1;
    long n[3], start[3], stop[3];
    wall_lattice(scene, depth, n, start, stop);
    for (int a = 0; a < 3; a++) {
        whole *= (double)(stop[a] - start[a]);
        inside *= (double)n[a];
    }
    return whole - inside;
}

enum status fill_walls(const struct scene *scene, double depth, struct fill *fill,
                       struct error *e)
{
    const double *low = scene->domain.min;
    long n[3], start[3], stop[3];
    *fill = (struct fill){0};
    wall_lattice(scene, depth, n, start, stop);
    for (long z = start[2]; z < stop[2]; z++)
        for (long y = start[1]; y < stop[1]; y++)
            for (long x = start[0]; x < stop[0]; x++) {
                long cell[3] = {x, y, z};
                double p[3];
                bool outside = false;
                for (int a = 0; a < 3; a++) {
                    double pitch = (scene->domain.max[a] - low[a]) / (double)n[a];
                    outside = outside || cell[a] < 0 || cell[a] >= n[a];
                    p[a] = low[a] + ((double)cell[a] + 0.5) * pitch;
                }
                if (!outside) { /* skip the interior in one go */
                    x = n[0] - 1;
                    continue;
                }
                if (fill_add(fill, p, -1, e)) {
                    fill_free(fill);
                    return e->status;
                }
            }
    return STATUS_OK;
}

void fill_free(struct fill *fill)
{
    memory_free(fill->point);
    memory_free(fill->body);
    *fill = (struct fill){0};
}
