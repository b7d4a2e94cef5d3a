/* The cuda renderer, its kernels run by the host: the cpu renderer's bits, and what it refuses. */
#include "render/cuda/canvas_device.h"
#include "render/cuda/draw_kernels.h"
#include "render_fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

static enum status host_open(void **canvas, const struct canvas_row *row, const struct render_setup *setup,
                             struct error *e)
{
    (void)row;
    return canvas_device_open(canvas, &device_host, draw_kernels_host, setup, e);
}

static const struct canvas_row on_host = {.variant = {.name = "cuda"}, .open = host_open,
                                          .draw = canvas_device_draw, .name = canvas_device_name,
                                          .close = canvas_device_close};

/* A picture, and what is in it. */
struct shot {
    int width, height;
    double radius;
    struct render_frame frame;
    void (*change)(struct scene *, struct render_setup *);
};

static void shot_setup(const struct shot *shot, struct scene *scene, struct render_setup *setup)
{
    fixture_scene(scene, shot->width, shot->height);
    scene->render.box = BOX_LINES;
    scene->particles.spacing = 0.016;
    for (int k = 0; k < 3; k++)
        scene->render.background[k] = 0.9;
    *setup = fixture_setup(scene, "cpu");
    setup->threads = 2;
    setup->radius = shot->radius;
    if (shot->change)
        shot->change(scene, setup);
}

/* The same canvas draws twice: the second frame finds what the first left behind. */
static void shot_draw(const struct canvas_row *row, const struct shot *shot, struct image *image)
{
    struct scene scene;
    struct render_setup setup;
    struct error e = {.text = ""};
    struct camera camera;
    void *canvas;
    struct render_frame before = shot->frame;
    shot_setup(shot, &scene, &setup);
    before.count /= 2;
    camera_make(&camera, &scene, setup.radius, 0);
    if (row->open(&canvas, row, &setup, &e) || image_create(image, shot->width, shot->height, &e) ||
        (setup.raw && image_create_raw(image, &e)) || row->draw(canvas, &camera, &before, image, &e) ||
        row->draw(canvas, &camera, &shot->frame, image, &e))
        fail_msg("%s", e.text);
    row->close(canvas);
}

/* Fails unless both renderers draw the same; returns how many pixels are not the background's. */
static size_t shot_compare(const char *what, const struct shot *shot)
{
    struct image cpu = {0}, cuda = {0};
    size_t count = (size_t)shot->width * (size_t)shot->height, drawn = 0, differing = 0;
    shot_draw(&canvas_cpu, shot, &cpu);
    shot_draw(&on_host, shot, &cuda);
    for (size_t i = 0; i < count; i++) {
        drawn += memcmp(cpu.rgba + 4 * i, cpu.rgba, 4) != 0;
        differing += memcmp(cpu.rgba + 4 * i, cuda.rgba + 4 * i, 4) != 0;
        differing += cpu.raw && memcmp(cpu.raw + RAW_PLANES * i, cuda.raw + RAW_PLANES * i,
                                       RAW_PLANES * sizeof(float)) != 0;
    }
    printf("# %s, %d x %d, %zu spheres of %g m: %zu pixels drawn, %zu differ\n", what, shot->width, shot->height,
           shot->frame.count, shot->radius, drawn, differing);
    assert_int_equal(differing, 0);
    image_free(&cpu);
    image_free(&cuda);
    return drawn;
}

static void one_sample(struct scene *scene, struct render_setup *setup)
{
    (void)setup;
    scene->render.samples = 1;
}
static void rim_and_fade(struct scene *scene, struct render_setup *setup)
{
    (void)setup;
    scene->render.outline = 0.15;
    scene->render.samples = 3;
    for (int k = 0; k < 3; k++)
        scene->render.background_top[k] = 0.2 * k;
}
static void clear(struct scene *scene, struct render_setup *setup)
{
    (void)setup;
    scene->render.transparent = true;
    scene->render.samples = 4;
}
static void faces_and_grid(struct scene *scene, struct render_setup *setup)
{
    (void)setup;
    scene->render.box = BOX_FACES;
    scene->render.floor = FLOOR_GRID;
}
static void orthographic(struct scene *scene, struct render_setup *setup)
{
    faces_and_grid(scene, setup);
    scene->camera.projection = PROJECTION_ORTHOGRAPHIC;
    scene->camera.height = NAN;
    scene->render.floor = FLOOR_CHECKER;
}
static void obstacles(struct scene *scene, struct render_setup *setup)
{
    (void)setup;
    fixture_obstacles(scene);
}
static void clear_obstacles(struct scene *scene, struct render_setup *setup)
{
    clear(scene, setup);
    orthographic(scene, setup);
    fixture_obstacles(scene);
}
static void shadow_and_occlusion(struct scene *scene, struct render_setup *setup)
{
    (void)setup;
    scene->render.shadow = 0.6;
    scene->render.occlusion = 0.7;
    scene->render.floor = FLOOR_PLAIN;
}
static void bare_log_scale(struct scene *scene, struct render_setup *setup)
{
    scene->render.box = BOX_NONE;
    setup->scale = (struct color_scale){.range = {0.05, 3}, .log = true};
}
static void steps_and_raw(struct scene *scene, struct render_setup *setup)
{
    (void)scene;
    setup->scale.steps = 5;
    setup->raw = true;
}
static void own_colors(struct scene *scene, struct render_setup *setup)
{
    (void)scene;
    setup->solid = true;
}
/* The eye is in the cloud: spheres are around it, behind it, and across the picture's sides. */
static void inside(struct scene *scene, struct render_setup *setup)
{
    static const double eye[3] = {0.3, 0.15, 0.3}, target[3] = {1.5, 0.3, 0.35};
    (void)setup;
    memcpy(scene->camera.eye, eye, sizeof eye);
    memcpy(scene->camera.target, target, sizeof target);
    scene->camera.fov = 70;
}
static void mirrored(struct scene *scene, struct render_setup *setup)
{
    static const double eye[3] = {0.5, 0.5, 3}, target[3] = {0.5, 0.5, 0};
    memcpy(scene->camera.eye, eye, sizeof eye);
    memcpy(scene->camera.target, target, sizeof target);
    scene->camera.projection = PROJECTION_ORTHOGRAPHIC;
    scene->camera.height = 0.7;
    setup->raw = true;
}

static const struct {
    const char *what;
    void (*change)(struct scene *, struct render_setup *);
} looks[] = {
    {"plain", NULL}, {"one sample", one_sample}, {"rim, faded background", rim_and_fade},
    {"transparent", clear}, {"faces and a grid", faces_and_grid}, {"orthographic", orthographic},
    {"shadow and occlusion", shadow_and_occlusion}, {"no domain, log", bare_log_scale},
    {"steps, raw", steps_and_raw}, {"own colours", own_colors}, {"from inside", inside},
    {"mirrored", mirrored}, {"obstacles", obstacles}, {"obstacles over nothing", clear_obstacles},
};

static void the_bits_of_cpu(void **state)
{
    static const struct { int width, height; double radius; } sizes[] = {
        {500, 290, 0.008}, {333, 77, 0.03}, {64, 128, 0.002}};
    struct fixture_cloud cloud = fixture_cloud(20000, 7);
    uint8_t *color = malloc(4 * cloud.count);
    (void)state;
    for (size_t i = 0; i < 4 * cloud.count; i++)
        color[i] = (uint8_t)(60 * (i % 4) + i / 400);
    for (size_t n = 0; n < sizeof looks / sizeof *looks; n++)
        for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++) {
            const struct shot shot = {
                sizes[k].width, sizes[k].height, sizes[k].radius,
                {.count = cloud.count, .position = cloud.position, .value = cloud.value, .color = color},
                looks[n].change};
            assert_true(shot_compare(looks[n].what, &shot) > 200);
        }
    free(color);
    fixture_cloud_free(&cloud);
}

/* Few spheres, and such that lie oddly: of coincident ones the first is seen. */
static void few_spheres(void **state)
{
    enum { FEW = 12 };
    static const float position[3 * FEW] = {
        0.75F, 0.5F, 0.25F, 0.25F, 0.5F, 0.25F,               /* as far from `mirrored`'s eye */
        0.312F, 0.15F, 0.444F,                                /* beside the eye of `inside` */
        0.8F, 0.5F, 0.3F, 0.8F, 0.5F, 0.3F, 0.8F, 0.5F, 0.3F, /* coincident */
        0.6F, 0.5F, 0.3F, 0.7F, 0.5F, 0.3F,                   /* one in another */
        9.0F, 0.5F, 0.3F, 0.8F, 0.5F, 90.0F,                  /* beside the picture, behind the eye */
        NAN, 0.5F, 0.3F, 0.8F, INFINITY, 0.3F};
    static const float value[FEW] = {1, 2, 0, 2.9F, 0.1F, 1.5F, NAN, 9, -9, 1, 1, 1};
    static const int counts[] = {FEW, 6, 2, 1, 0};
    static const int sizes[][2] = {{1, 1}, {2, 1}, {1, 97}, {160, 90}};
    (void)state;
    for (size_t n = 0; n < sizeof looks / sizeof *looks; n++)
        for (size_t k = 0; k < sizeof sizes / sizeof *sizes; k++)
            for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
                static const uint8_t color[4 * FEW] = {250, 9, 9, 0, 9, 250, 9, 0, 9, 9, 250, 0};
                const struct shot shot = {
                    sizes[k][0], sizes[k][1], i % 2 ? 0.5 : 0.12,
                    {.count = (size_t)counts[i], .position = position, .value = value, .color = color},
                    looks[n].change};
                shot_compare(looks[n].what, &shot);
            }
}

static void change_surface(struct scene *scene, struct render_setup *setup)
{
    (void)setup;
    strcpy(scene->render.style, "surface");
}

static int count_none(const char **why)
{
    *why = "no CUDA-capable device is detected";
    return 0;
}

static void refusals(void **state)
{
    struct shot shot = {64, 64, 0.01, {0}, change_surface};
    struct scene scene;
    struct render_setup setup;
    struct device_row none = device_host;
    struct error e = {.text = ""};
    void *canvas = &e;
    (void)state;
    shot_setup(&shot, &scene, &setup);
    assert_int_equal(canvas_device_open(&canvas, &device_host, draw_kernels_host, &setup, &e), STATUS_BACKEND);
    assert_non_null(strstr(e.text, "surface"));
    assert_null(canvas);
    shot.change = NULL;
    shot_setup(&shot, &scene, &setup);
    none.count = count_none;
    assert_int_equal(canvas_device_open(&canvas, &none, draw_kernels_host, &setup, &e), STATUS_BACKEND);
    assert_non_null(strstr(e.text, "no GPU") ? strstr(e.text, "no CUDA-capable device") : NULL);
    scene.movie.size[0] = 40000;
    assert_int_equal(canvas_device_open(&canvas, &device_host, draw_kernels_host, &setup, &e), STATUS_BACKEND);
    assert_non_null(strstr(e.text, "--size"));
    assert_null(canvas);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_bits_of_cpu), cmocka_unit_test(few_spheres), cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
