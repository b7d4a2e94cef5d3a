/* Text over frames: each part can be switched, and small pictures go without. */
#include "render_fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

enum part { NONE, LEGEND, TIME, TITLE, BOX };

/* Pixels of an empty frame that are not background, in each quarter: columns, then rows. */
static bool count_marks(enum part part, int width, int height, size_t marks[2][2])
{
    struct scene scene;
    struct image image = {0};
    struct renderer *renderer;
    struct error e = {.text = ""};
    struct render_frame frame = {.time = 1.5};
    fixture_scene(&scene, width, height);
    scene.color.legend = part == LEGEND;
    scene.render.time = part == TIME;
    scene.render.title = part == TITLE;
    scene.render.box = part == BOX;
    memset(marks, 0, 4 * sizeof marks[0][0]);
    if (!variant_first(&render_contexts) || render_overlays.rows[0]->missing) {
        printf("# SKIP no context or no cairo in this build\n");
        return false;
    }
    struct render_setup setup = fixture_setup(&scene, "auto");
    if (renderer_open(&renderer, &setup, &e) != STATUS_OK ||
        renderer_draw(renderer, &frame, &image, &e) != STATUS_OK)
        fail_msg("%s", e.text);
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++)
            marks[x >= width / 2][y >= height / 2] += image.rgba[(y * width + x) * 4 + 1] != 0;
    renderer_close(renderer);
    image_free(&image);
    return true;
}

static void each_part_alone(void **state)
{
    size_t m[2][2];
    (void)state;
    if (!count_marks(NONE, 640, 360, m))
        return;
    assert_int_equal(m[0][0] + m[0][1] + m[1][0] + m[1][1], 0);
    count_marks(LEGEND, 640, 360, m);
    assert_true(m[1][0] > 300 && m[1][1] > 300 && m[0][0] + m[0][1] == 0);
    count_marks(TIME, 640, 360, m);
    assert_true(m[0][1] > 50 && m[0][0] + m[1][0] + m[1][1] == 0);
    count_marks(TITLE, 640, 360, m);
    assert_true(m[0][0] > 50 && m[0][1] + m[1][0] + m[1][1] == 0);
    count_marks(BOX, 640, 360, m);
    assert_true(m[0][0] > 100 && m[0][1] > 100 && m[1][0] > 100 && m[1][1] > 100);
}

static void any_size(void **state)
{
    static const int sizes[][2] = {{1, 1}, {2, 3}, {33, 17}, {64, 48}, {101, 99}, {2000, 90},
                                   {90, 2000}, {1921, 1081}};
    size_t m[2][2];
    (void)state;
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++)
        for (int part = NONE; part <= BOX; part++)
            if (!count_marks((enum part)part, sizes[i][0], sizes[i][1], m))
                return;
    count_marks(TITLE, 64, 48, m);
    assert_int_equal(m[0][0] + m[0][1] + m[1][0] + m[1][1], 0);
}

/* Ranges that a scene may pin: tiny, huge, negative, empty, not a number. */
static void any_range(void **state)
{
    static const double ranges[][2] = {{0, 1e-9}, {-1e12, 1e12}, {-3, -2.99}, {5, 5}, {2, 1},
                                       {NAN, NAN}, {0, INFINITY}, {1e9, 1e9 + 1}};
    struct scene scene;
    struct image image = {0};
    struct render_frame frame = {.time = 1e9};
    (void)state;
    fixture_scene(&scene, 320, 180);
    memset(scene.title, 'W', sizeof scene.title - 1);
    scene.color.legend = scene.render.title = scene.render.time = true;
    for (size_t i = 0; i < sizeof ranges / sizeof ranges[0]; i++) {
        struct renderer *renderer;
        struct error e;
        struct render_setup setup = fixture_setup(&scene, "auto");
        if (!variant_first(&render_contexts))
            return;
        memcpy(setup.scale.range, ranges[i], sizeof setup.scale.range);
        setup.unit = i % 2 ? "" : NULL;
        assert_int_equal(renderer_open(&renderer, &setup, &e), STATUS_OK);
        assert_int_equal(renderer_draw(renderer, &frame, &image, &e), STATUS_OK);
        renderer_close(renderer);
    }
    image_free(&image);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_part_alone),
        cmocka_unit_test(any_size),
        cmocka_unit_test(any_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
