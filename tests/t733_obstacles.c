/* Tests pictures of obstacles: they hide what is behind them and each other, spheres in front hide them, they are
 * opaque, and lit from above. */
#include "render_fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

enum { SIZE = 101, MIDDLE = SIZE / 2 };

/* A block seen from the front, along -z, and one sphere before or behind it. */
struct view {
    const char *renderer;
    double sphere; /* z of its middle, m */
    const struct scene_obstacle *obstacles;
    size_t count;
    bool clear;
};

static const struct scene_obstacle block = {
    .shape = {.kind = SHAPE_BOX, .min = {0.6, 0.3, 0.2}, .max = {1.0, 0.7, 0.4}}, .color = {1, 0.5, 0},
    .visible = true};

/* The pixel at a part of the way from the middle to the picture's upper right corner. */
static void pixel_at(const struct view *view, double right, double up, uint8_t rgba[4])
{
    static const double eye[3] = {0.8, 0.5, 3}, target[3] = {0.8, 0.5, 0};
    static const uint8_t green[4] = {0, 255, 0, 0};
    const float position[3] = {0.8F, 0.5F, (float)view->sphere};
    struct render_frame frame = {.count = 1, .position = position, .color = green};
    struct scene scene;
    struct image image = {0};
    struct error e = {.text = ""};
    struct renderer *renderer;
    fixture_scene(&scene, SIZE, SIZE);
    memcpy(scene.camera.eye, eye, sizeof eye);
    memcpy(scene.camera.target, target, sizeof target);
    scene.camera.fov = 20;
    scene.render.floor = FLOOR_NONE;
    scene.render.transparent = view->clear;
    struct scene_obstacle copy[4];
    memcpy(copy, view->obstacles, view->count * sizeof *copy);
    scene.obstacles = copy;
    scene.obstacle_count = view->count;
    struct render_setup setup = fixture_setup(&scene, view->renderer);
    setup.solid = true;
    setup.radius = 0.05;
    setup.threads = 1;
    if (renderer_open(&renderer, &setup, &e) || renderer_draw(renderer, &frame, &image, &e))
        fail_msg("%s", e.text);
    size_t x = (size_t)(MIDDLE + right * MIDDLE), y = (size_t)(MIDDLE - up * MIDDLE);
    memcpy(rgba, image.rgba + 4 * (y * SIZE + x), 4);
    renderer_close(renderer);
    image_free(&image);
}

static bool is_green(const uint8_t rgba[4])
{
    return rgba[1] > 100 && rgba[0] < 60;
}
static bool is_orange(const uint8_t rgba[4])
{
    return rgba[0] > 100 && abs(rgba[0] - 2 * rgba[1]) < 6 && rgba[2] < 3;
}

static const char *const renderers[] = {"cpu", "egl", "osmesa"};
enum { RENDERERS = sizeof renderers / sizeof *renderers };

static bool in_build(const char *renderer)
{
    return !variant_find(&render_table, renderer)->missing;
}

static void depth_decides(void **state)
{
    (void)state;
    for (size_t r = 0; r < RENDERERS; r++) {
        struct view view = {.renderer = renderers[r], .obstacles = &block, .count = 1};
        uint8_t rgba[4];
        if (!in_build(renderers[r]))
            continue;
        view.sphere = 0.6; /* before the block */
        pixel_at(&view, 0, 0, rgba);
        assert_true(is_green(rgba));
        pixel_at(&view, 0.25, 0.25, rgba);
        assert_true(is_orange(rgba));
        view.sphere = 0.1; /* behind */
        pixel_at(&view, 0, 0, rgba);
        assert_true(is_orange(rgba));
        view.sphere = 0.3; /* inside */
        pixel_at(&view, 0, 0, rgba);
        assert_true(is_orange(rgba));
    }
}

/* In whatever order they are said; one that is not visible hides nothing. */
static void obstacles_hide_each_other(void **state)
{
    (void)state;
    const struct scene_obstacle ball = {.shape = {.kind = SHAPE_SPHERE, .center = {0.8, 0.5, 0.5}, .radius = 0.08},
                                        .color = {0, 1, 0}, .visible = true};
    for (size_t r = 0; r < RENDERERS; r++)
        for (int order = 0; order < 2; order++) {
            struct scene_obstacle both[2] = {order ? ball : block, order ? block : ball};
            struct view view = {.renderer = renderers[r], .sphere = 0.1, .obstacles = both, .count = 2};
            uint8_t rgba[4];
            if (!in_build(renderers[r]))
                continue;
            pixel_at(&view, 0, 0, rgba);
            assert_true(is_green(rgba)); /* the ball */
            both[!order].shape.center[2] = 0.05;
            pixel_at(&view, 0, 0, rgba);
            assert_true(is_orange(rgba));
            both[order].visible = false;
            pixel_at(&view, 0, 0, rgba);
            assert_true(is_green(rgba));
        }
}

static void opaque_over_nothing(void **state)
{
    (void)state;
    for (size_t r = 0; r < RENDERERS; r++) {
        struct view view = {.renderer = renderers[r], .sphere = 0.1, .obstacles = &block, .count = 1, .clear = true};
        uint8_t rgba[4];
        if (!in_build(renderers[r]))
            continue;
        pixel_at(&view, 0.1, 0.1, rgba);
        assert_true(rgba[3] == 255 && is_orange(rgba));
        pixel_at(&view, 0.9, 0.9, rgba);
        assert_int_equal(rgba[3], 0);
    }
}

/* A ball and a lying cylinder are brighter above than below. */
static void lit_from_above(void **state)
{
    (void)state;
    const struct scene_obstacle round[2] = {
        {.shape = {.kind = SHAPE_SPHERE, .center = {0.8, 0.5, 0.3}, .radius = 0.2}, .color = {1, 0.5, 0},
         .visible = true},
        {.shape = {.kind = SHAPE_CYLINDER, .center = {0.8, 0.5, 0.3}, .radius = 0.2, .height = 1, .axis = 0},
         .color = {1, 0.5, 0}, .visible = true}};
    for (int k = 0; k < 2; k++) {
        struct view view = {.renderer = "cpu", .sphere = 0.3, .obstacles = &round[k], .count = 1};
        uint8_t above[4], below[4];
        pixel_at(&view, 0, 0.35, above);
        pixel_at(&view, 0, -0.35, below);
        assert_true(is_orange(above) && above[0] > below[0] + 30);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(depth_decides), cmocka_unit_test(obstacles_hide_each_other),
                                       cmocka_unit_test(opaque_over_nothing), cmocka_unit_test(lit_from_above)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
