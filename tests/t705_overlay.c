/* Text over frames: each part can be switched, and small pictures go without. */
#include "render_fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

enum part { NONE, LEGEND, TIME, TITLE, BOX, AXES, SCALE_BAR, LABEL, PART_COUNT };

static struct scene_label labels[] = {{"Re = 100", LABEL_TOP_RIGHT, 1},
                                      {"under the title", LABEL_TOP_LEFT, 1.2},
                                      {"in the middle below", LABEL_BOTTOM, 1},
                                      {"a label", LABEL_BOTTOM_RIGHT, 1}};

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
    scene.render.axes = part == AXES;
    scene.render.scale_bar = part == SCALE_BAR;
    scene.labels = labels;
    scene.label_count = part == LABEL;
    memset(marks, 0, 4 * sizeof marks[0][0]);
    if (!variant_first(&render_table) || render_overlays.rows[0]->missing) {
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
    count_marks(AXES, 640, 360, m);
    assert_true(m[0][1] > 50 && m[0][0] + m[1][0] + m[1][1] == 0);
    count_marks(SCALE_BAR, 640, 360, m);
    assert_true(m[1][1] > 50 && m[0][0] + m[0][1] + m[1][0] == 0);
    count_marks(LABEL, 640, 360, m);
    assert_true(m[1][0] > 50 && m[0][0] + m[0][1] + m[1][1] == 0);
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
        for (int part = NONE; part < PART_COUNT; part++)
            if (!count_marks((enum part)part, sizes[i][0], sizes[i][1], m))
                return;
    count_marks(TITLE, 64, 48, m);
    assert_int_equal(m[0][0] + m[0][1] + m[1][0] + m[1][1], 0);
}

/* An empty frame with the first `parts` of those that are placed, in order. */
static bool draw_parts(int parts, const int size[2], struct image *image)
{
    struct scene scene;
    struct renderer *renderer;
    struct error e = {.text = ""};
    struct render_frame frame = {.time = 1.5};
    fixture_scene(&scene, size[0], size[1]);
    scene.time.end = 3;
    scene.color.legend = parts > 0;
    scene.render.title = parts > 1;
    scene.render.time = parts > 2;
    scene.render.axes = parts > 3;
    scene.render.scale_bar = parts > 4;
    scene.labels = labels;
    scene.label_count = parts > 5 ? (size_t)parts - 5 : 0;
    if (!variant_first(&render_table) || render_overlays.rows[0]->missing)
        return false;
    struct render_setup setup = fixture_setup(&scene, "auto");
    memset(image, 0, sizeof *image);
    if (renderer_open(&renderer, &setup, &e) != STATUS_OK ||
        renderer_draw(renderer, &frame, image, &e) != STATUS_OK)
        fail_msg("%s", e.text);
    renderer_close(renderer);
    return true;
}

/* What another part adds leaves the marks of those before as they are, at every size. The camera's
 * framing depends on the colour bar, which is the first. */
static void nothing_meets(void **state)
{
    static const int sizes[][2] = {{320, 180}, {480, 360}, {640, 360}, {400, 900}, {1000, 240},
                                   {1280, 720}, {1921, 1081}, {3840, 2160}};
    (void)state;
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        struct image before, after;
        size_t pixels = (size_t)sizes[s][0] * (size_t)sizes[s][1];
        if (!draw_parts(1, sizes[s], &before))
            return;
        for (int parts = 2; parts <= 9; parts++) {
            size_t changed = 0, added = 0;
            draw_parts(parts, sizes[s], &after);
            for (size_t i = 0; i < 4 * pixels; i += 4) {
                bool was = before.rgba[i] || before.rgba[i + 1] || before.rgba[i + 2];
                bool is = memcmp(before.rgba + i, after.rgba + i, 3) != 0;
                changed += was && is;
                added += !was && is;
            }
            assert_int_equal(changed, 0);
            assert_true(added > 20);
            image_free(&before);
            before = after;
        }
        image_free(&before);
    }
}

/* A bar of n steps has exactly n colours, from one end of the map to the other. */
static void bar_steps(void **state)
{
    static const int counts[] = {2, 5, 7, 12};
    struct scene scene;
    struct image image = {0};
    struct renderer *renderer;
    struct error e;
    struct render_frame frame = {.time = 0};
    (void)state;
    fixture_scene(&scene, 640, 360);
    scene.color.legend = true;
    if (!variant_first(&render_table) || render_overlays.rows[0]->missing)
        return;
    for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
        struct render_setup setup = fixture_setup(&scene, "auto");
        int found = 0, column = 0;
        setup.scale.steps = counts[c];
        assert_int_equal(renderer_open(&renderer, &setup, &e), STATUS_OK);
        assert_int_equal(renderer_draw(renderer, &frame, &image, &e), STATUS_OK);
        while (image.rgba[(180 * 640 + column) * 4 + 2] == 0) /* the bar is the first from the left */
            column++;
        for (int y = 90, run = 0; y < 270; y++) {
            const uint8_t *p = image.rgba + (y * 640 + column + 4) * 4;
            run = memcmp(p, p - 640 * 4, 3) == 0 && (p[0] || p[1] || p[2]) ? run + 1 : 0;
            found += run == 5;
        }
        assert_int_equal(found, counts[c]);
        renderer_close(renderer);
    }
    image_free(&image);
}

/* At the distance of the target, 1.5 m before the eye, a bar is as long as it says. */
static void scale_bar_length(void **state)
{
    static const double eye[3] = {0.8, 0.5, 1.5}, target[3] = {0.8, 0.5, 0};
    struct scene scene;
    struct image image = {0};
    struct renderer *renderer;
    struct error e;
    struct render_frame frame = {.time = 0};
    int longest = 0;
    (void)state;
    fixture_scene(&scene, 640, 360);
    memcpy(scene.camera.eye, eye, sizeof eye);
    memcpy(scene.camera.target, target, sizeof target);
    scene.camera.fov = 2 * atan(0.5) * 180 / 3.141592653589793;
    scene.render.scale_bar = true;
    if (!variant_first(&render_table) || render_overlays.rows[0]->missing)
        return;
    struct render_setup setup = fixture_setup(&scene, "auto");
    assert_int_equal(renderer_open(&renderer, &setup, &e), STATUS_OK);
    assert_int_equal(renderer_draw(renderer, &frame, &image, &e), STATUS_OK);
    for (int y = 0; y < 360; y++)
        for (int x = 0, run = 0; x < 640; x++) {
            run = image.rgba[(y * 640 + x) * 4] > 100 ? run + 1 : 0;
            longest = run > longest ? run : longest;
        }
    printf("# 0.5 m are %d pixels\n", longest);
    assert_in_range(longest, 119, 123); /* 0.5 m of the 1.5 m that 360 pixels show, and the line's width */
    renderer_close(renderer);
    image_free(&image);
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
        if (!variant_first(&render_table))
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
        cmocka_unit_test(nothing_meets),
        cmocka_unit_test(scale_bar_length),
        cmocka_unit_test(bar_steps),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
