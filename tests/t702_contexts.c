/* Renderers: every one of the build draws the same picture, and failures say what to do. */
#include "render/context.h"
#include "render/egl_devices.h"
#include "render_fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

static void draw_cloud(const char *context, struct image *image)
{
    struct scene scene;
    struct error e = {.text = ""};
    struct renderer *renderer;
    struct fixture_cloud cloud = fixture_cloud(20000, 7);
    struct render_frame frame = {.time = 0.5, .count = cloud.count, .position = cloud.position,
                                 .value = cloud.value};
    fixture_scene(&scene, 640, 360);
    scene.color.legend = scene.render.time = scene.render.title = true;
    scene.render.box = BOX_LINES;
    struct render_setup setup = fixture_setup(&scene, context);
    memset(image, 0, sizeof *image);
    if (renderer_open(&renderer, &setup, &e) != STATUS_OK)
        fail_msg("%s", e.text);
    assert_non_null(strstr(renderer_name(renderer), context));
    for (int i = 0; i < 2; i++) /* the second frame goes through used buffers */
        assert_int_equal(renderer_draw(renderer, &frame, image, &e), STATUS_OK);
    renderer_close(renderer);
    fixture_cloud_free(&cloud);
}

static bool in_build(const char *context)
{
    const struct variant *row = variant_find(&render_table, context);
    assert_non_null(row);
    if (row->missing)
        printf("# SKIP %s: %s\n", context, row->missing);
    return !row->missing;
}

/* Same stack: at most 2 levels on at most one pixel in a thousand. */
static void contexts_agree(void **state)
{
    struct image a, b;
    size_t differing = 0;
    int most = 0;
    (void)state;
    if (!in_build("egl") || !in_build("osmesa"))
        return;
    draw_cloud("egl", &a);
    draw_cloud("osmesa", &b);
    for (size_t i = 0; i < (size_t)a.width * (size_t)a.height; i++) {
        int difference = 0;
        for (int k = 0; k < 4; k++) {
            int d = abs(a.rgba[4 * i + k] - b.rgba[4 * i + k]);
            difference = d > difference ? d : difference;
        }
        differing += difference > 0;
        most = difference > most ? difference : most;
    }
    printf("# egl against osmesa: %zu pixels differ, by up to %d\n", differing, most);
    assert_true(most <= 2);
    assert_true(differing * 1000 <= (size_t)a.width * (size_t)a.height);
    image_free(&a);
    image_free(&b);
}

/* Two contexts of different libraries on one thread, taking turns. */
static void contexts_take_turns(void **state)
{
    struct scene scene;
    struct error e = {.text = ""};
    struct renderer *r[2];
    struct image first[2] = {{0}}, second = {0};
    float position[3] = {0.8F, 0.5F, 0.3F}, value = 1;
    struct render_frame frame = {.count = 1, .position = position, .value = &value};
    static const char *const names[2] = {"egl", "osmesa"};
    (void)state;
    if (!in_build("egl") || !in_build("osmesa"))
        return;
    fixture_scene(&scene, 64, 48);
    for (int i = 0; i < 2; i++) {
        struct render_setup setup = fixture_setup(&scene, names[i]);
        setup.radius = 0.2;
        assert_int_equal(renderer_open(&r[i], &setup, &e), STATUS_OK);
        assert_int_equal(renderer_draw(r[i], &frame, &first[i], &e), STATUS_OK);
    }
    for (int i = 0; i < 2; i++) {
        assert_int_equal(renderer_draw(r[i], &frame, &second, &e), STATUS_OK);
        assert_memory_equal(first[i].rgba, second.rgba, 64 * 48 * 4);
        image_free(&first[i]);
    }
    renderer_close(r[0]);
    renderer_close(r[1]);
    image_free(&second);
}

/* A GPU that is not there may be asked for: any other will do. */
static void any_device_will_do(void **state)
{
    static const struct gl_context_row *const rows[] = {&context_egl, &context_osmesa};
    (void)state;
    assert_int_equal(egl_device_of_cuda(-1), -1);
    assert_int_equal(egl_device_of_cuda(1000), -1);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct error e = {.text = ""};
        void *context;
        if (!in_build(rows[i]->name))
            continue;
        if (rows[i]->open(&context, 1000, &e))
            fail_msg("%s", e.text);
        int cuda = rows[i]->cuda(context);
        assert_true(cuda >= -1 && cuda < 1000);
        assert_true(cuda < 0 || egl_device_of_cuda(cuda) >= 0);
        rows[i]->close(context);
    }
}

static void bad_requests(void **state)
{
    struct scene scene;
    struct error e = {.text = ""};
    struct renderer *renderer = (void *)&scene;
    (void)state;
    fixture_scene(&scene, 64, 48);
    struct render_setup setup = fixture_setup(&scene, "vulkan");
    assert_int_equal(renderer_open(&renderer, &setup, &e), STATUS_BACKEND);
    assert_non_null(strstr(e.text, "vulkan"));
    assert_null(renderer);
    setup.renderer = "auto";
    scene.movie.size[0] = 1000000;
    assert_int_equal(renderer_open(&renderer, &setup, &e), STATUS_BACKEND);
    if (variant_first(&render_table))
        assert_non_null(strstr(e.text, "1000000 x 48"));
    renderer_close(NULL);
}

/* A row that is not in the build says how to build it. */
static void missing_rows(void **state)
{
    struct scene scene;
    struct error e;
    struct renderer *renderer;
    (void)state;
    fixture_scene(&scene, 64, 48);
    for (size_t i = 0; i < render_table.count; i++) {
        const struct variant *row = render_table.rows[i];
        struct render_setup setup = fixture_setup(&scene, row->name);
        if (!row->missing)
            continue;
        assert_int_equal(renderer_open(&renderer, &setup, &e), STATUS_BACKEND);
        assert_non_null(strstr(e.text, "make "));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(contexts_agree), cmocka_unit_test(contexts_take_turns),
        cmocka_unit_test(bad_requests),   cmocka_unit_test(missing_rows),
        cmocka_unit_test(any_device_will_do),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
