/* Spheres against analytic perspective: radius, depth, who hides whom, colour, and order; by every
 * renderer of the build. */
#include "device/device.h"
#include "render/camera.h"
#include "render/maps.h"
#include "render_fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

enum { WIDTH = 320, HEIGHT = 200 };

static const char *renderer_name_now; /* each of the build in turn */

static const uint8_t red_green[8] = {255, 0, 0, 255, 0, 255, 0, 255};

static bool draw(const struct scene *scene, const struct render_setup *setup,
                 const struct render_frame *frame, struct image *image)
{
    struct renderer *renderer;
    struct error e = {.text = ""};
    memset(image, 0, sizeof *image);
    (void)scene;
    if (renderer_open(&renderer, setup, &e) != STATUS_OK ||
        renderer_draw(renderer, frame, image, &e) != STATUS_OK)
        fail_msg("%s", e.text);
    renderer_close(renderer);
    return true;
}

/* Looking along -z from (0.8, 0.5, 3) with tan(fov / 2) = 1/2. */
static void front_camera(struct scene *scene)
{
    static const double eye[3] = {0.8, 0.5, 3}, target[3] = {0.8, 0.5, 0};
    fixture_scene(scene, WIDTH, HEIGHT);
    memcpy(scene->camera.eye, eye, sizeof eye);
    memcpy(scene->camera.target, target, sizeof target);
    scene->camera.fov = 2 * atan(0.5) * 180 / 3.141592653589793;
}

/* Which sphere the ray through a drawn sample meets first: its number, or -1. */
static int nearest(const struct camera *camera, double x, double y, const float (*center)[3],
                   int count, double radius)
{
    double a = (2 * x / WIDTH - 1) * camera->tan_x, b = (1 - 2 * y / HEIGHT) * camera->tan_y;
    double ray[3], best = INFINITY, length = 0;
    int winner = -1;
    for (int k = 0; k < 3; k++) {
        ray[k] = camera->forward[k] + a * camera->right[k] + b * camera->up[k];
        length += ray[k] * ray[k];
    }
    for (int i = 0; i < count; i++) {
        double along = 0, square = 0, root;
        for (int k = 0; k < 3; k++) {
            double to = center[i][k] - camera->eye[k];
            along += to * ray[k] / sqrt(length);
            square += to * to;
        }
        root = radius * radius - (square - along * along);
        if (root >= 0 && along - sqrt(root) > 0 && along - sqrt(root) < best) {
            best = along - sqrt(root);
            winner = i;
        }
    }
    return winner;
}

/* Compares each pixel whose four samples agree; returns how many showed a sphere. */
static int check_pixels(const struct scene *scene, const struct image *image,
                        const float (*center)[3], int count, double radius)
{
    struct camera camera;
    int wrong = 0, shown = 0;
    camera_make(&camera, scene, radius, 0);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const uint8_t *p = image->rgba + (y * WIDTH + x) * 4;
            int expected = nearest(&camera, x + 0.25, y + 0.25, center, count, radius), found;
            bool agree = true;
            for (int s = 1; s < 4; s++)
                agree = agree && nearest(&camera, x + 0.25 + s % 2 * 0.5, y + 0.25 + s / 2 * 0.5,
                                         center, count, radius) == expected;
            if (!agree)
                continue;
            found = p[0] > p[1] ? 0 : p[1] > p[0] ? 1 : -1;
            wrong += found != expected;
            shown += expected >= 0;
        }
    printf("# %d pixels show spheres, %d are wrong\n", shown, wrong);
    assert_true(wrong <= 2); /* a sample may lie on the very edge */
    return shown;
}

static void run_pair(const float (*center)[3], double radius, int at_least)
{
    struct scene scene;
    struct image image;
    front_camera(&scene);
    struct render_setup setup = fixture_setup(&scene, renderer_name_now);
    struct render_frame frame = {.count = 2, .position = center[0], .color = red_green};
    setup.solid = true;
    setup.radius = radius;
    if (!draw(&scene, &setup, &frame, &image))
        return;
    assert_true(check_pixels(&scene, &image, center, 2, radius) >= at_least);
    image_free(&image);
}

static void radius_and_place(void **state)
{
    static const float apart[2][3] = {{0.4F, 0.3F, 0.2F}, {1.3F, 0.8F, 0.6F}};
    static const float corner[2][3] = {{-0.9F, -0.4F, 1}, {2.2F, 1.4F, 0.7F}};
    (void)state;
    run_pair(apart, 0.12, 400);
    run_pair(corner, 0.3, 300); /* stretched by perspective, centres out of the picture */
}

static void depth_where_spheres_meet(void **state)
{
    static const float through[2][3] = {{0.7F, 0.5F, 0.3F}, {0.85F, 0.55F, 0.38F}};
    static const float behind[2][3] = {{0.8F, 0.5F, 0}, {0.85F, 0.5F, 1.5F}};
    static const float close[2][3] = {{0.8F, 0.5F, 2.4F}, {0.5F, 0.4F, 2.5F}};
    (void)state;
    run_pair(through, 0.25, 1000);
    run_pair(behind, 0.25, 2000);
    run_pair(close, 0.45, 10000);
}

/* The outline of a sphere on the axis is a circle of tan(asin(r / d)). */
static void outline(void **state)
{
    static const float center[3] = {0.8F, 0.5F, 1};
    struct scene scene;
    struct image image;
    double r = 0.3, expected = tan(asin(r / 2)) / 0.5 * HEIGHT / 2, area = 0;
    (void)state;
    front_camera(&scene);
    struct render_setup setup = fixture_setup(&scene, renderer_name_now);
    struct render_frame frame = {.count = 1, .position = center, .color = red_green};
    setup.solid = true;
    setup.radius = r;
    scene.render.background[2] = 1; /* what is not blue is covered */
    if (!draw(&scene, &setup, &frame, &image))
        return;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        area += image.rgba[4 * i + 2] < 128;
    printf("# radius %.3f pixels, expected %.3f\n", sqrt(area / 3.141592653589793), expected);
    assert_true(fabs(sqrt(area / 3.141592653589793) - expected) < 0.15);
    image_free(&image);
}

static void colour_of_map(void **state)
{
    static const float center[3] = {0.8F, 0.5F, 1};
    static const float values[] = {-5, 0, 0.75F, 1.5F, 3, 9, NAN};
    static const int entry[] = {0, 0, 64, 128, 255, 255, 0};
    (void)state;
    for (size_t m = 0; m < render_maps.count; m++)
        for (size_t v = 0; v < sizeof values / sizeof values[0]; v++) {
            struct scene scene;
            struct image image;
            uint8_t rgb[MAP_SIZE][3];
            front_camera(&scene);
            strcpy(scene.color.map, render_maps.rows[m]->name);
            ((const struct render_map *)render_maps.rows[m])->fill(rgb);
            struct render_setup setup = fixture_setup(&scene, renderer_name_now);
            struct render_frame frame = {.count = 1, .position = center, .value = values + v};
            setup.radius = 0.5;
            if (v > 2 && m > 1)
                break; /* the ends and one within are enough for the others */
            if (!draw(&scene, &setup, &frame, &image))
                return;
            /* In the middle one light factor near 1 applies to all channels. */
            const uint8_t *p = image.rgba + (HEIGHT / 2 * WIDTH + WIDTH / 2) * 4;
            for (int k = 0; k < 3; k++)
                assert_true(p[k] >= 0.85 * rgb[entry[v]][k] - 3 &&
                            p[k] <= 1.02 * rgb[entry[v]][k] + 3);
            image_free(&image);
        }
}

static void first_wins_ties(void **state)
{
    static const float same[2][3] = {{0.8F, 0.5F, 1}, {0.8F, 0.5F, 1}};
    static const uint8_t green_red[8] = {0, 255, 0, 255, 255, 0, 0, 255};
    struct scene scene;
    struct image image;
    (void)state;
    for (int turn = 0; turn < 2; turn++) {
        size_t reds = 0, greens = 0;
        front_camera(&scene);
        struct render_setup setup = fixture_setup(&scene, renderer_name_now);
        struct render_frame frame = {.count = 2, .position = same[0],
                                     .color = turn ? green_red : red_green};
        setup.solid = true;
        setup.radius = 0.3;
        if (!draw(&scene, &setup, &frame, &image))
            return;
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            reds += image.rgba[4 * i] > image.rgba[4 * i + 1];
            greens += image.rgba[4 * i + 1] > image.rgba[4 * i];
        }
        assert_int_equal(turn ? reds : greens, 0);
        assert_true((turn ? greens : reds) > 1000);
        image_free(&image);
    }
}

/* Particles in any order give the same frame, as long as no depths are equal. */
static void order_does_not_matter(void **state)
{
    struct scene scene;
    struct image a, b;
    struct fixture_cloud cloud = fixture_cloud(5000, 3), mixed = fixture_cloud(5000, 3);
    uint64_t seed = 99;
    (void)state;
    fixture_scene(&scene, WIDTH, HEIGHT);
    for (size_t i = cloud.count - 1; i > 0; i--) {
        size_t j = (size_t)(fixture_random(&seed) * (double)(i + 1));
        for (int k = 0; k < 4; k++) {
            float *x = k < 3 ? mixed.position + 3 * i + k : mixed.value + i;
            float *y = k < 3 ? mixed.position + 3 * j + k : mixed.value + j;
            float t = *x;
            *x = *y;
            *y = t;
        }
    }
    struct render_setup setup = fixture_setup(&scene, renderer_name_now);
    struct render_frame frame = {.count = 5000, .position = cloud.position, .value = cloud.value};
    if (draw(&scene, &setup, &frame, &a)) {
        frame.position = mixed.position;
        frame.value = mixed.value;
        draw(&scene, &setup, &frame, &b);
        assert_memory_equal(a.rgba, b.rgba, WIDTH * HEIGHT * 4);
        image_free(&a);
        image_free(&b);
    }
    fixture_cloud_free(&cloud);
    fixture_cloud_free(&mixed);
}

/* Nothing to draw, and nothing drawable: the background remains. */
static void odd_input(void **state)
{
    static const float odd[5][3] = {{NAN, 0, 0}, {INFINITY, 0, 0}, {0.8F, 0.5F, 3},
                                    {0.8F, 0.5F, 9}, {0.8F, 1e30F, 1}};
    static const float values[5] = {0};
    struct scene scene;
    struct image image;
    (void)state;
    front_camera(&scene);
    scene.render.background[0] = 1;
    struct render_setup setup = fixture_setup(&scene, renderer_name_now);
    for (size_t count = 0; count <= 5; count += 5) {
        struct render_frame frame = {.count = count, .position = odd[0], .value = values};
        if (!draw(&scene, &setup, &frame, &image))
            return;
        for (int i = 0; i < WIDTH * HEIGHT; i++)
            assert_memory_equal(image.rgba + 4 * i, ((const uint8_t[]){255, 0, 0, 255}), 4);
        image_free(&image);
    }
}

/* The cuda renderer needs a GPU; t732 tests it with the host as the device. */
static bool has_device(const struct variant *row)
{
#if HAVE_CUDA
    const char *why;
    return strcmp(row->name, "cuda") != 0 || device_cuda.count(&why) > 0;
#else
    (void)row;
    return true;
#endif
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(radius_and_place), cmocka_unit_test(depth_where_spheres_meet),
        cmocka_unit_test(outline),          cmocka_unit_test(colour_of_map),
        cmocka_unit_test(first_wins_ties),  cmocka_unit_test(order_does_not_matter),
        cmocka_unit_test(odd_input),
    };
    int failed = 0;
    for (size_t i = 0; i < render_table.count; i++) {
        const struct variant *row = render_table.rows[i];
        renderer_name_now = row->name;
        bool here = !row->missing && has_device(row);
        printf("# %s%s\n", row->name, row->missing ? " SKIP: not in this build"
                                     : here         ? ""
                                                    : " SKIP: no GPU that CUDA can use");
        failed += here ? cmocka_run_group_tests_name(row->name, tests, NULL, NULL) : 0;
    }
    return failed;
}
