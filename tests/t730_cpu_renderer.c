/* The cpu renderer: the same bits for any threads and instruction set, OpenGL's picture, alpha. */
#include "render_fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

enum { WIDTH = 500, HEIGHT = 290 }; /* no multiple of a tile */

struct how {
    const char *renderer, *isa;
    int threads;
    double radius;
};

static void change_nothing(struct scene *scene)
{
    (void)scene;
}
static void change_look(struct scene *scene)
{
    scene->render.outline = 0.15;
    scene->render.samples = 3;
    for (int k = 0; k < 3; k++)
        scene->render.background_top[k] = 0.2 * k;
}
static void change_occlusion(struct scene *scene)
{
    scene->render.occlusion = 0.7;
    scene->particles.spacing = 0.016;
}
static void change_shadow(struct scene *scene)
{
    scene->render.shadow = 0.6;
    scene->particles.spacing = 0.016;
}
static void change_projection(struct scene *scene)
{
    scene->camera.projection = PROJECTION_ORTHOGRAPHIC;
    scene->camera.height = NAN;
    scene->render.box = BOX_FACES;
    scene->render.floor = FLOOR_GRID;
}
static void change_clear(struct scene *scene)
{
    scene->render.transparent = true;
}

static void change_surface(struct scene *scene)
{
    strcpy(scene->render.style, "surface");
    scene->particles.spacing = 0.016;
}

static void change_obstacles(struct scene *scene)
{
    fixture_obstacles(scene);
}
static void change_surface_obstacles(struct scene *scene)
{
    fixture_obstacles(scene);
    change_surface(scene);
}

static void draw(const struct how *how, void (*change)(struct scene *), struct image *image)
{
    struct scene scene;
    struct error e = {.text = ""};
    struct renderer *renderer;
    struct fixture_cloud cloud = fixture_cloud(20000, 7);
    struct render_frame frame = {.count = cloud.count, .position = cloud.position,
                                 .value = cloud.value};
    fixture_scene(&scene, WIDTH, HEIGHT);
    scene.render.box = BOX_LINES;
    for (int k = 0; k < 3; k++)
        scene.render.background[k] = 0.9;
    change(&scene);
    struct render_setup setup = fixture_setup(&scene, how->renderer);
    setup.isa = how->isa;
    setup.threads = how->threads;
    setup.radius = how->radius;
    uint8_t *color = calloc(cloud.count, 4);
    for (size_t i = 0; i < 4 * cloud.count; i++)
        color[i] = (uint8_t)(60 * (i % 4) + 40);
    setup.solid = strcmp(scene.render.style, "surface") == 0;
    frame.color = color;
    memset(image, 0, sizeof *image);
    if (renderer_open(&renderer, &setup, &e) || renderer_draw(renderer, &frame, image, &e))
        fail_msg("%s", e.text);
    renderer_close(renderer);
    fixture_cloud_free(&cloud);
    free(color);
}

static bool has(const char *isa)
{
    if (strcmp(isa, "avx512") == 0)
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw");
    return strcmp(isa, "avx2") != 0 || __builtin_cpu_supports("avx2");
}

static void the_same_bits(void **state)
{
    static void (*const changes[])(struct scene *) = {change_nothing, change_look, change_clear,
                                                       change_surface, change_occlusion, change_projection,
                                                       change_shadow, change_obstacles,
                                                       change_surface_obstacles};
    static const char *const isas[] = {"scalar", "avx2", "avx512"};
    (void)state;
    for (size_t c = 0; c < sizeof changes / sizeof *changes; c++) {
        struct image first, next;
        draw(&(struct how){"cpu", "scalar", 1, 0.008}, changes[c], &first);
        for (size_t i = 0; i < 3; i++)
            for (int threads = 1; has(isas[i]) && threads <= 7; threads += 2) {
                draw(&(struct how){"cpu", isas[i], threads, 0.008}, changes[c], &next);
                assert_memory_equal(first.rgba, next.rgba, (size_t)WIDTH * HEIGHT * 4);
                image_free(&next);
            }
        image_free(&first);
    }
}

/* Few pixels differ from OpenGL's by more than 2 levels: rays that graze a sphere. */
static void the_picture_of_opengl(void **state)
{
    static void (*const changes[])(struct scene *) = {change_nothing, change_look, change_clear,
                                                       change_projection, change_shadow, change_obstacles};
    enum { DRAWN = 3 * sizeof changes / sizeof *changes };
    static const double radii[] = {0.002, 0.01, 0.08};
    const char *names[] = {"egl", "osmesa"};
    (void)state;
    for (size_t n = 0; n < 2; n++)
        for (size_t c = 0; c < DRAWN && !variant_find(&render_table, names[n])->missing; c++) {
            struct image cpu, gl;
            size_t differing = 0;
            double radius = radii[c % 3];
            draw(&(struct how){"cpu", "auto", 2, radius}, changes[c / 3], &cpu);
            draw(&(struct how){names[n], "auto", 2, radius}, changes[c / 3], &gl);
            for (size_t i = 0; i < (size_t)WIDTH * HEIGHT; i++) {
                int most = 0;
                for (int k = 0; k < 4; k++) {
                    int d = abs(cpu.rgba[4 * i + k] - gl.rgba[4 * i + k]);
                    d = k < 3 && cpu.rgba[4 * i + 3] < 16 ? 0 : d; /* colour of next to nothing */
                    most = d > most ? d : most;
                }
                differing += most > 2;
            }
            printf("# %s, look %zu, radius %g m: %zu of %d pixels differ\n", names[n], c / 3, radius,
                   differing, WIDTH * HEIGHT);
            assert_true(differing * 1000 <= (size_t)WIDTH * HEIGHT);
            image_free(&cpu);
            image_free(&gl);
        }
}

/* Darker somewhere, nowhere lighter. */
static void occlusion_darkens(void **state)
{
    struct image plain, dark;
    size_t darker = 0;
    (void)state;
    draw(&(struct how){"cpu", "auto", 2, 0.008}, change_nothing, &plain);
    draw(&(struct how){"cpu", "auto", 2, 0.008}, change_occlusion, &dark);
    for (size_t i = 0; i < (size_t)WIDTH * HEIGHT * 4; i++) {
        assert_true(dark.rgba[i] <= plain.rgba[i] + 1);
        darker += dark.rgba[i] + 10 < plain.rgba[i];
    }
    assert_true(darker > 1000);
    image_free(&plain);
    image_free(&dark);
}

/* A pool of still spheres with a surface: its middle is as flat and even as the sphere picture is not. */
static void surface_is_smooth(void **state)
{
    struct image rough, smooth;
    double change[2] = {0, 0};
    (void)state;
    draw(&(struct how){"cpu", "auto", 2, 0.008}, change_nothing, &rough);
    draw(&(struct how){"cpu", "auto", 2, 0.008}, change_surface, &smooth);
    for (int y = 190; y < 230; y++)
        for (int x = 150; x < 250; x++)
            for (int p = 0; p < 2; p++) {
                const uint8_t *at = (p ? smooth : rough).rgba + 4 * (y * WIDTH + x);
                change[p] += abs(at[1] - at[5]);
            }
    printf("# change from pixel to pixel: spheres %.2f, surface %.2f\n", change[0] / 4000, change[1] / 4000);
    assert_true(change[1] > 0 && change[1] < change[0] / 3);
    image_free(&rough);
    image_free(&smooth);
}

static void surface_by_cpu_only(void **state)
{
    struct scene scene;
    struct error e = {.text = ""};
    struct renderer *renderer;
    (void)state;
    fixture_scene(&scene, WIDTH, HEIGHT);
    change_surface(&scene);
    struct render_setup setup = fixture_setup(&scene, "egl");
    assert_int_equal(renderer_open(&renderer, &setup, &e), STATUS_BACKEND);
    setup.renderer = "auto";
    assert_int_equal(renderer_open(&renderer, &setup, &e), STATUS_OK);
    assert_memory_equal(renderer_name(renderer), "cpu", 3);
    renderer_close(renderer);
}

/* Where nothing is, nothing is covered; where spheres are, all is. */
static void alpha(void **state)
{
    struct image clear, solid;
    size_t empty = 0, full = 0;
    (void)state;
    draw(&(struct how){"cpu", "auto", 2, 0.01}, change_clear, &clear);
    draw(&(struct how){"cpu", "auto", 2, 0.01}, change_nothing, &solid);
    for (size_t i = 0; i < (size_t)WIDTH * HEIGHT; i++) {
        const uint8_t *p = clear.rgba + 4 * i, *q = solid.rgba + 4 * i;
        empty += p[3] == 0;
        full += p[3] == 255;
        assert_int_equal(q[3], 255);
        for (int k = 0; k < 3; k++) { /* over the background it is the other picture */
            double over = p[k] * p[3] / 255.0 + 0.9 * (255 - p[3]);
            assert_true(fabs(over - q[k]) < 2.5);
        }
    }
    assert_true(empty > 10000 && full > 10000);
    image_free(&clear);
    image_free(&solid);
}

/* Raw numbers in the middle of a sphere on the axis: distance less radius, value, number. */
static void raw_numbers(void **state)
{
    static const double eye[3] = {0.8, 0.5, 3}, target[3] = {0.8, 0.5, 0};
    static const float position[6] = {0.1F, 0.1F, 0.1F, 0.8F, 0.5F, 0.5F}, value[2] = {1, 2.5F};
    struct scene scene;
    struct error e = {.text = ""};
    struct renderer *renderer;
    struct image image = {0};
    struct render_frame frame = {.count = 2, .position = position, .value = value};
    (void)state;
    fixture_scene(&scene, 101, 61);
    memcpy(scene.camera.eye, eye, sizeof eye);
    memcpy(scene.camera.target, target, sizeof target);
    scene.render.samples = 1;
    struct render_setup setup = fixture_setup(&scene, "cpu");
    setup.radius = 0.25;
    assert_int_equal(renderer_open(&renderer, &setup, &e), STATUS_OK);
    assert_int_equal(image_create(&image, 101, 61, &e), STATUS_OK);
    assert_int_equal(image_create_raw(&image, &e), STATUS_OK);
    assert_int_equal(renderer_draw(renderer, &frame, &image, &e), STATUS_OK);
    const float *middle = image.raw + RAW_PLANES * (30 * 101 + 50), *corner = image.raw;
    assert_true(fabsf(middle[RAW_DEPTH] - 2.25F) < 1e-6F);
    assert_true(middle[RAW_VALUE] == 2.5F && middle[RAW_ID] == 1);
    assert_true(isinf(corner[RAW_DEPTH]) && isnan(corner[RAW_VALUE]) && corner[RAW_ID] == -1);
    renderer_close(renderer);
    image_free(&image);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_same_bits), cmocka_unit_test(the_picture_of_opengl),
        cmocka_unit_test(surface_is_smooth), cmocka_unit_test(occlusion_darkens),
        cmocka_unit_test(surface_by_cpu_only),
        cmocka_unit_test(raw_numbers), cmocka_unit_test(alpha),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
