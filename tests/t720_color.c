/* Colours without a picture: places on scales, steps, ticks, colour maps of files, places of text. */
#include "render/layout.h"
#include "render/palette.h"
#include "render/ticks.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "picture.h"

static void places(void **state)
{
    struct color_scale linear = {.range = {-1, 3}}, decades = {.range = {0.01, 100}, .log = true};
    struct color_scale steps = {.range = {0, 1}, .steps = 5};
    (void)state;
    assert_true(scale_place(&linear, 0) == 0.25F && scale_place(&linear, 3) == 1);
    assert_true(scale_place(&linear, -9) == 0 && scale_place(&linear, NAN) == 0);
    assert_true(scale_place(&linear, INFINITY) == 1);
    for (int n = -2; n <= 2; n++)
        assert_true(fabs(scale_place(&decades, (float)pow(10, n)) - (n + 2) / 4.0) < 1e-6);
    assert_true(scale_place(&decades, 0) == 0 && scale_place(&decades, -1) == 0);
    assert_true(fabs(scale_value(&decades, 0.75) - 10) < 1e-12);
    assert_true(scale_place(&steps, 0.39F) == 0.25F && scale_place(&steps, 0.41F) == 0.5F);
}

/* n steps show exactly n places, the ends among them, on either scale. */
static void steps_count(void **state)
{
    static const int counts[] = {2, 3, 7, 16, 255, 256};
    (void)state;
    for (size_t c = 0; c < sizeof counts / sizeof *counts; c++)
        for (int log = 0; log < 2; log++) {
            struct color_scale s = {.range = {1, 1000}, .steps = counts[c], .log = log};
            float last = -1;
            int found = 0;
            for (int i = 0; i <= 100000; i++) {
                float place = scale_place(&s, (float)scale_value(&s, i / 1e5));
                assert_true(place >= last);
                found += place > last;
                last = place;
            }
            assert_int_equal(found, counts[c]);
            assert_true(last == 1);
        }
}

static void expect_ticks(const struct color_scale *scale, int most, const char *expected)
{
    static struct render_setup setup;
    struct ticks ticks;
    char texts[1000] = "";
    ticks_make(&ticks, &setup, scale, most);
    for (int i = 0; i < ticks.count; i++) {
        assert_true(ticks.items[i].part > -1e-6 && ticks.items[i].part < 1 + 1e-6);
        if (ticks.items[i].text[0])
            sprintf(texts + strlen(texts), "%s ", ticks.items[i].text);
    }
    assert_string_equal(texts, expected);
}

static const char *fluid_name(const struct scene *scene, size_t number)
{
    (void)scene;
    return number ? "Schwer\u00f6l mit einem langen Namen" : "water";
}

static void ticks(void **state)
{
    static const struct {
        struct color_scale scale;
        const char *expected;
    } rows[] = {
        {{.range = {0, 3}}, "0.0 0.5 1.0 1.5 2.0 2.5 3.0 "},
        {{.range = {-1, 1}}, "\u22121.0 \u22120.5 0.0 0.5 1.0 "},
        {{.range = {0, 3e5}}, "0 50 100 150 200 250 300 "},
        {{.range = {0.01, 100}, .log = true}, "0.01 0.1 1 10 100 "},
        {{.range = {1, 20}, .log = true}, "1 2 5 10 20 "},
        {{.range = {1e-9, 1e-3}, .log = true},
         "10\u207b\u2079 10\u207b\u2078 10\u207b\u2077 10\u207b\u2076 10\u207b\u2075 10\u207b\u2074 "
         "10\u207b\u00b3 "},
        {{.range = {1e-20, 1e-2}, .log = true},
         "10\u207b\u00b9\u2078 10\u207b\u00b9\u2075 10\u207b\u00b9\u00b2 10\u207b\u2079 "
         "10\u207b\u2076 10\u207b\u00b3 "},
        {{.range = {1, 10000}, .log = true}, "1 10 100 1000 10000 "},
        {{.range = {5e5, 1e7}, .log = true},
         "5\u00b710\u2075 10\u2076 2\u00b710\u2076 5\u00b710\u2076 10\u2077 "},
        {{.range = {2, 4}, .log = true}, "2.0 2.5 3.0 3.5 4.0 "},
        {{.range = {0, 4}, .steps = 4}, "0 1 2 3 4 "},
        {{.range = {0, 12}, .steps = 12}, "0 2 4 6 8 10 12 "},
        {{.range = {1, 10000}, .steps = 4, .log = true}, "0.001 0.01 0.1 1 10 "},
        {{.range = {-0.5, 2.5}, .steps = 3, .counts = true}, "0 1 2 "},
        {{.range = {1, 1}}, ""},
        {{.range = {0, INFINITY}}, ""},
        {{.range = {0, 1}, .log = true}, ""},
    };
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        expect_ticks(&rows[i].scale, 7, rows[i].expected);
}

static void tick_names(void **state)
{
    struct render_setup setup = {.label = "pressure", .unit = "Pa", .name = fluid_name};
    struct color_scale large = {.range = {0, 3e5}}, two = {.range = {-0.5, 1.5}, .steps = 2, .counts = true};
    struct ticks t;
    char text[100];
    (void)state;
    ticks_make(&t, &setup, &large, 7);
    ticks_name(&t, &setup, text, sizeof text);
    assert_string_equal(text, "pressure (10\u00b3 Pa)");
    ticks_make(&t, &setup, &two, 7);
    assert_string_equal(t.items[0].text, "water");
    assert_string_equal(t.items[1].text, "Schwer\u00f6l mit einem lan\u2026");
    ticks_name(&t, &setup, text, sizeof text);
    assert_string_equal(text, "pressure (Pa)");
    assert_true(ticks_round(4.9) == 2 && ticks_round(5) == 5 && fabs(ticks_round(0.013) - 0.01) < 1e-12);
}

static void map_files(void **state)
{
    static const char *const good[] = {"0 0 0\n1 0.5 0\n", "0 0 0\r\n\r\n// half\r\n255 128 0\r\n",
                                       "#000000\n#ff8000", "0, 0, 0\n255,128,0\n"};
    (void)state;
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        const char *path = in_directory("map.txt");
        uint8_t rgb[MAP_SIZE][3];
        struct error e;
        file_write(path, good[i]);
        if (palette_read(path, rgb, &e))
            fail_msg("%s", e.text);
        assert_int_equal(rgb[0][0], 0);
        assert_int_equal(rgb[51][0], 51);
        assert_int_equal(rgb[255][0], 255);
        assert_int_equal(rgb[255][1], 128);
        assert_int_equal(rgb[128][2], 0);
    }
}

static void map_errors(void **state)
{
    static const struct {
        const char *text, *place, *says;
    } rows[] = {
        {"0 0 0\n1 x 0\n", ":2:3:", "not a number"},
        {"0 0 0\n\n1 1\n", ":3:4:", "fewer than three"},
        {"0 0 0\n1 1 1 1\n", ":2:7:", "more than three"},
        {"0 0 0\n0 300 0\n", ":2:3:", "0 to 255"},
        {"0 0 0\n0 -1 0\n", ":2:3:", "0 to 255"},
        {"0 0 0\nnan 0 0\n", ":2:1:", "0 to 255"},
        {"#12345\n#000000\n", ":1:1:", "six hexadecimal"},
        {"#123456\n #00000g\n", ":2:2:", "six hexadecimal"},
        {"0 0 0\n", ":1:1:", "one colour"},
        {"", ":1:1:", "no colour"},
        {"0.5 0 0\n255 0 0\n", ":1:1:", "not whole"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const char *path = in_directory("map.txt");
        uint8_t rgb[MAP_SIZE][3];
        struct error e = {.text = ""};
        file_write(path, rows[i].text);
        assert_int_equal(palette_read(path, rgb, &e), STATUS_USAGE);
        if (strncmp(e.text, path, strlen(path)) != 0 ||
            strncmp(e.text + strlen(path), rows[i].place, strlen(rows[i].place)) != 0 ||
            !strstr(e.text, rows[i].says))
            fail_msg("%s", e.text);
    }
}

static void too_many_rows(void **state)
{
    const char *path = in_directory("map.txt");
    FILE *file = fopen(path, "w");
    uint8_t rgb[MAP_SIZE][3];
    struct error e;
    (void)state;
    for (int i = 0; i < 257; i++)
        fprintf(file, "%d 0 0\n", i % 256);
    fclose(file);
    assert_int_equal(palette_read(path, rgb, &e), STATUS_USAGE);
    assert_non_null(strstr(e.text, ":257:1: more than 256"));
    assert_int_equal(palette_read(in_directory("none"), rgb, &e), STATUS_USAGE);
    assert_non_null(strstr(e.text, "cannot be read"));
}

static void reversed(void **state)
{
    static struct scene scene;
    uint8_t plain[MAP_SIZE][3], turned[MAP_SIZE][3];
    struct error e;
    (void)state;
    strcpy(scene.color.map, "turbo");
    assert_int_equal(palette_make(&scene, true, plain, &e), STATUS_OK);
    scene.color.reverse = true;
    assert_int_equal(palette_make(&scene, true, turned, &e), STATUS_OK);
    for (int i = 0; i < MAP_SIZE; i++)
        assert_memory_equal(plain[i], turned[MAP_SIZE - 1 - i], 3);
    strcpy(scene.color.map, "auto");
    assert_int_equal(palette_make(&scene, true, turned, &e), STATUS_OK);
    map_coolwarm.fill(plain);
    assert_memory_equal(plain[0], turned[MAP_SIZE - 1], 3);
}

/* Whatever is placed, no two boxes meet and none leaves the picture. */
static void boxes_apart(void **state)
{
    uint64_t seed = 7;
    (void)state;
    for (int trial = 0; trial < 200; trial++) {
        struct layout l = {.width = 320, .height = 180, .side = 10, .end = 8, .gap = 3};
        struct layout_box bar = {260, 40, 60, 90};
        layout_take(&l, &bar);
        for (int i = 0; i < 30; i++) {
            struct layout_box box;
            seed = seed * 6364136223846793005U + 1442695040888963407U;
            layout_place(&l, (enum label_place)(seed >> 33) % 6, 10 + (double)(seed >> 40 & 127),
                         10 + (double)(seed >> 50 & 15), &box);
        }
        for (int i = 0; i < l.count; i++) {
            const struct layout_box *a = &l.taken[i];
            assert_true(a->x >= 0 && a->y >= 0 && a->x + a->width <= 320.001 &&
                        a->y + a->height <= 180.001);
            for (int k = 0; k < i; k++) {
                const struct layout_box *b = &l.taken[k];
                assert_true(a->x >= b->x + b->width || b->x >= a->x + a->width ||
                            a->y >= b->y + b->height || b->y >= a->y + a->height);
            }
        }
        assert_true(l.count > 5);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(places),        cmocka_unit_test(steps_count), cmocka_unit_test(ticks),
        cmocka_unit_test(tick_names),    cmocka_unit_test(map_files),   cmocka_unit_test(map_errors),
        cmocka_unit_test(too_many_rows), cmocka_unit_test(reversed),    cmocka_unit_test(boxes_apart),
    };
    return cmocka_run_group_tests(tests, directory_make, directory_remove);
}
