/* Tests obstacles before the first step: their boundary particles, the room they take from bodies, and what is
 * refused. */
#include "particles/fill_obstacles.h"
#include "particles/start.h"
#include "run/plan.h"
#include "scene_file.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define SPACING 0.025
#define DEPTH (2.6 * SPACING)

/* A cube of 0.8 m with the obstacles, half full of water. */
static struct scene *scene_make(const char *walls, const char *obstacles, const char *body)
{
    char text[4096];
    struct scene *scene;
    struct error e = {0};
    int n = snprintf(text, sizeof text,
                     "{\"particles\": {\"spacing\": 0.025}, \"fluids\": [{}], \"time\": {\"end\": 1},\n"
                     "\"domain\": {\"min\": [0, 0, 0], \"max\": [0.8, 0.8, 0.8], \"walls\": %s},\n"
                     "\"obstacles\": [%s],\n\"bodies\": [%s]}", walls, obstacles, body);
    if (scene_from_text(&scene, text, (size_t)n, NULL, &run_vocabulary, &e))
        fail_msg("%s", e.text);
    return scene;
}

#define CLOSED "\"closed\""
#define HALF "{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.8, 0.4, 0.8]}"
#define BLOCK "{\"shape\": \"box\", \"min\": [0.2, 0.2, 0.2], \"max\": [0.5, 0.4, 0.45]}"
#define FOOT "{\"shape\": \"box\", \"min\": [0.2, 0, 0.2], \"max\": [0.5, 0.3, 0.5]}"
#define BALL "{\"shape\": \"sphere\", \"center\": [0.4, 0.4, 0.4], \"radius\": 0.16}"
#define ROD "{\"shape\": \"cylinder\", \"center\": [0.4, 0.4, 0.4], \"radius\": 0.12, \"height\": 0.3, \"axis\": \"z\"}"
#define POST "{\"shape\": \"cylinder\", \"center\": [0.4, 0.4, 0.4], \"radius\": 0.12, \"height\": 0.8}"

static struct fill fill_make(const struct scene *scene)
{
    struct fill fill = {0};
    struct error e = {0};
    if (fill_obstacles(scene, DEPTH, &fill, &e))
        fail_msg("%s", e.text);
    return fill;
}

static double nearest(const struct fill *fill, size_t i)
{
    double least = INFINITY;
    for (size_t j = 0; j < fill->count; j++) {
        double r2 = 0;
        for (int a = 0; a < 3; a++)
            r2 += (fill->point[i][a] - fill->point[j][a]) * (fill->point[i][a] - fill->point[j][a]);
        least = j != i && r2 < least ? r2 : least;
    }
    return sqrt(least);
}

static void hollow_shells(void **state)
{
    static const char *const shapes[] = {BLOCK, FOOT, BALL, ROD, POST};
    (void)state;
    for (size_t k = 0; k < sizeof shapes / sizeof *shapes; k++) {
        struct scene *scene = scene_make(CLOSED, shapes[k], HALF);
        struct fill fill = fill_make(scene);
        const struct solid solid = solid_make(scene, scene->obstacles);
        double closest = INFINITY, deepest = 0, highest = -INFINITY;
        double estimate = fill_obstacles_estimate(scene, DEPTH);
        for (size_t i = 0; i < fill.count; i++) {
            double distance = solid_distance(&solid, fill.point[i]);
            closest = fmin(closest, nearest(&fill, i));
            deepest = fmin(deepest, distance);
            highest = fmax(highest, distance);
            assert_true(shape_distance(&scene->obstacles->shape, fill.point[i]) < 0);
        }
        print_message("# %s: %zu of %.0f points, %.2f d apart, from %.2f d to %.2f d\n",
                      shape_words[scene->obstacles->shape.kind], fill.count, estimate, closest / SPACING,
                      highest / SPACING, deepest / SPACING);
        assert_true(fabs((double)fill.count / estimate - 1) < 0.2); /* whole layers only */
        assert_true(closest > 0.55 * SPACING); /* two points about an axis */
        assert_true(fabs(highest / SPACING + 0.5) < 0.05);
        assert_true(deepest > -DEPTH * 1.01 && deepest < -2 * SPACING);
        fill_free(&fill);
        scene_free(scene);
    }
}

/* All of a shape that is thin enough to be full. */
static void full_volume(void **state)
{
    static const char *const shapes[] = {
        "{\"shape\": \"box\", \"min\": [0.2, 0.2, 0.2], \"max\": [0.31, 0.6, 0.42]}",
        "{\"shape\": \"sphere\", \"center\": [0.4, 0.4, 0.4], \"radius\": 0.085}",
        "{\"shape\": \"cylinder\", \"center\": [0.4, 0.4, 0.4], \"radius\": 0.08, \"height\": 0.41, \"axis\": \"x\"}"};
    (void)state;
    for (size_t k = 0; k < sizeof shapes / sizeof *shapes; k++) {
        struct scene *scene = scene_make(CLOSED, shapes[k], HALF);
        struct fill fill = {0};
        struct error e = {0};
        assert_int_equal(fill_obstacles(scene, 1, &fill, &e), STATUS_OK);
        double exact = shape_volume(&scene->obstacles->shape) / (SPACING * SPACING * SPACING);
        print_message("# %s: %zu points instead of %.1f\n", shape_words[scene->obstacles->shape.kind], fill.count,
                      exact);
        assert_true(fabs((double)fill.count / exact - 1) < 0.1);
        fill_free(&fill);
        scene_free(scene);
    }
}

/* What two obstacles share is filled once. */
static void unions(void **state)
{
    (void)state;
    struct scene *scene = scene_make(CLOSED, BLOCK ", " BALL, HALF);
    struct fill fill = fill_make(scene);
    size_t shared = 0, later = 0;
    for (size_t i = 0; i < fill.count; i++) {
        bool first = shape_distance(&scene->obstacles[0].shape, fill.point[i]) < 0;
        later += !first;
        shared += first && shape_distance(&scene->obstacles[1].shape, fill.point[i]) < 0;
        assert_true(first || shape_distance(&scene->obstacles[1].shape, fill.point[i]) < 0);
        assert_true(nearest(&fill, i) > 0.4 * SPACING);
    }
    assert_true(shared > 20 && later > 20);
    fill_free(&fill);
    scene_free(scene);
}

/* Bodies leave obstacles free, and half a spacing round them; their volume is right, their mass is that of a
 * lattice. */
static void room(void **state)
{
    static const char *const shapes[] = {
        FOOT, "{\"shape\": \"sphere\", \"center\": [0.41, 0.2, 0.4], \"radius\": 0.15}", POST,
        "{\"shape\": \"box\", \"min\": [0.21, 0.013, 0.2], \"max\": [0.507, 0.3, 0.511]}"};
    static const double taken[] = {0.027, 0.014137, 0.018096, 0.297 * 0.287 * 0.311};
    (void)state;
    for (size_t k = 0; k < sizeof shapes / sizeof *shapes; k++) {
        struct scene *scene = scene_make(CLOSED, shapes[k],
                                         "{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.8, 0.4, 0.8], "
                                         "\"jitter\": 0.1}");
        struct fill fill;
        struct error e = {0};
        const struct solid solid = solid_make(scene, scene->obstacles);
        double least = INFINITY, volume;
        size_t particles;
        assert_int_equal(fill_bodies(scene, &fill, &e), STATUS_OK);
        for (size_t i = 0; i < fill.count; i++) {
            least = fmin(least, solid_distance(&solid, fill.point[i]));
            for (int a = 0; a < 3; a++)
                assert_true(fill.point[i][a] > 0 && fill.point[i][a] < 0.8);
        }
        start_count(scene, &fill, &volume, &particles);
        double expected = 0.8 * 0.8 * 0.4 - taken[k];
        print_message("# obstacle %zu: volume %+.2f %%, nearest %.3f d\n", k, 100 * (volume / expected - 1),
                      least / SPACING);
        assert_true(fabs(volume / expected - 1) < 0.015);
        assert_true(fabs(volume / (double)particles / (SPACING * SPACING * SPACING) - 1) < 1e-9);
        assert_true(least > 0.49 * SPACING || k == 3); /* there is no room under it */
        assert_true(least > 0);
        fill_free(&fill);
        scene_free(scene);
    }
}

/* The nearest image counts; an obstacle that touches one periodic face has fluid behind it, one that touches both
 * has not. */
static void periodic(void **state)
{
    (void)state;
    const char *walls = "{\"-x\": \"periodic\", \"+x\": \"periodic\", \"-z\": \"periodic\", \"+z\": \"periodic\"}";
    struct scene *scene = scene_make(walls, "{\"shape\": \"box\", \"min\": [0.6, 0, 0], \"max\": [0.8, 0.3, 0.8]}",
                                     HALF);
    const struct solid solid = solid_make(scene, scene->obstacles);
    assert_true(solid.open[0] && solid.open[1] && !solid.open[2] && solid.open[3] && !solid.open[4]);
    double beside[3] = {0.01, 0.1, 0.79}, inside[3] = {0.7, 0.001, 0.4};
    assert_true(fabs(solid_distance(&solid, beside) - 0.01) < 1e-12);
    assert_true(fabs(solid_distance(&solid, inside) + 0.1) < 1e-12);
    solid_push(&solid, 0.0125, beside);
    assert_true(fabs(beside[0] - 0.0125) < 1e-12 && beside[2] == 0.79);
    scene_free(scene);
}

/* Loads and plans the scene; the message. */
static void refused(const char *obstacles, const char *body, const char *message)
{
    struct scene *scene = scene_make(CLOSED, obstacles, body);
    struct run_options options = {0};
    struct plan plan;
    struct error e = {0};
    assert_int_equal(plan_make(&plan, scene, &options, &e), STATUS_USAGE);
    if (!strstr(e.text, message))
        fail_msg("%s", e.text);
    scene_free(scene);
}

static void refusals(void **state)
{
    (void)state;
    refused("{\"shape\": \"box\", \"min\": [0.2, 0.2, 0.2], \"max\": [0.25, 0.5, 0.5]}", HALF,
            ":3:15: obstacles.0: this box is 0.05 m thick along x, less than the support radius of 0.065 m");
    refused(FOOT ", {\"shape\": \"sphere\", \"center\": [0.4, 0.4, 0.4], \"radius\": 0.03}", HALF,
            "obstacles.1: this sphere is 0.06 m thick along x");
    refused(FOOT, "{\"shape\": \"sphere\", \"center\": [0.35, 0.15, 0.35], \"radius\": 0.1}",
            ":4:12: bodies.0 lies in obstacles and has no particle");
    /* A slab on the floor is as thick as the floor. */
    struct scene *scene =
        scene_make(CLOSED, "{\"shape\": \"box\", \"min\": [0.2, 0, 0.2], \"max\": [0.5, 0.03, 0.5]}", HALF);
    struct run_options options = {0};
    struct plan plan;
    struct error e = {0};
    assert_int_equal(plan_make(&plan, scene, &options, &e), STATUS_OK);
    plan_free(&plan);
    scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hollow_shells), cmocka_unit_test(full_volume), cmocka_unit_test(unions),
        cmocka_unit_test(room),          cmocka_unit_test(periodic),    cmocka_unit_test(refusals)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
