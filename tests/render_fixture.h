/* Scenes and particle clouds made by hand for the tests of the renderer. */
#ifndef RENDER_FIXTURE_H
#define RENDER_FIXTURE_H

#include "render/palette.h"
#include "render/render.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A dam break's tank, 1.6 x 1.0 x 0.67 m, everything off that a test does not ask for. */
static inline void fixture_scene(struct scene *scene, int width, int height)
{
    static const double max[3] = {1.6, 1.0, 0.67};
    memset(scene, 0, sizeof *scene);
    strcpy(scene->title, "Dam break");
    scene->gravity[1] = -9.81;
    memcpy(scene->domain.max, max, sizeof max);
    scene->movie.size[0] = width;
    scene->movie.size[1] = height;
    scene->movie.fps = 30;
    scene->movie.speed = 1;
    for (int k = 0; k < 3; k++)
        scene->camera.eye[k] = scene->camera.target[k] = NAN;
    scene->camera.up[1] = 1;
    scene->camera.fov = 35;
    scene->color.percentiles[0] = scene->color.percentiles[1] = NAN;
    strcpy(scene->color.map, "viridis");
    strcpy(scene->render.style, "spheres");
    scene->render.samples = 2;
    for (int k = 0; k < 3; k++)
        scene->render.background_top[k] = NAN;
}

/* Puts obstacles of all shapes in it, two of which go through each other. */
static inline void fixture_obstacles(struct scene *scene)
{
    static struct scene_obstacle obstacles[] = {
        {.shape = {.kind = SHAPE_BOX, .min = {0.5, 0, 0.1}, .max = {0.8, 0.25, 0.4}}, .color = {0.8, 0.4, 0.2},
         .visible = true},
        {.shape = {.kind = SHAPE_SPHERE, .center = {0.8, 0.25, 0.3}, .radius = 0.15}, .color = {0.3, 0.6, 0.3},
         .visible = true},
        {.shape = {.kind = SHAPE_CYLINDER, .center = {1.2, 0.5, 0.4}, .radius = 0.08, .height = 1, .axis = 1},
         .color = {0.6, 0.6, 0.6}, .visible = true},
        {.shape = {.kind = SHAPE_BOX, .min = {0, 0, 0}, .max = {1.6, 1, 0.67}}, .visible = false}};
    scene->obstacles = obstacles;
    scene->obstacle_count = sizeof obstacles / sizeof *obstacles;
}

static inline struct render_setup fixture_setup(const struct scene *scene, const char *context)
{
    struct render_setup setup = {.scene = scene, .renderer = context, .radius = 0.01,
                                 .scale = {.range = {0, 3}}, .label = "speed", .unit = "m/s"};
    struct error ignored;
    palette_make(scene, false, setup.palette, &ignored);
    return setup;
}

/* 0..1, the same on every machine. */
static inline double fixture_random(uint64_t *state)
{
    *state = *state * 6364136223846793005U + 1442695040888963407U;
    return (double)(*state >> 40) / (1 << 24);
}

struct fixture_cloud {
    size_t count;
    float *position, *value;
};

/* Water that ran out of a corner and splashes: about `wanted` particles with speeds 0 to 3. */
static inline struct fixture_cloud fixture_cloud(size_t wanted, uint64_t seed)
{
    struct fixture_cloud cloud = {0, malloc(wanted * 3 * sizeof(float)),
                                  malloc(wanted * sizeof(float))};
    while (cloud.count < wanted) {
        double x = 1.6 * fixture_random(&seed), y = 0.6 * fixture_random(&seed);
        double z = 0.67 * fixture_random(&seed), speed;
        double surface = 0.05 + 0.32 * exp(-x * x * 4) + 0.04 * sin(9 * x + 4 * z) +
                         0.4 * exp(-(x - 1.6) * (x - 1.6) * 60);
        if (y > surface && fixture_random(&seed) > 0.004)
            continue;
        speed = 2.2 * x / 1.6 + 1.5 * y + 0.2 * fixture_random(&seed);
        cloud.position[3 * cloud.count] = (float)x;
        cloud.position[3 * cloud.count + 1] = (float)y;
        cloud.position[3 * cloud.count + 2] = (float)z;
        cloud.value[cloud.count++] = (float)speed;
    }
    return cloud;
}

static inline void fixture_cloud_free(struct fixture_cloud *cloud)
{
    free(cloud->position);
    free(cloud->value);
}

#endif
