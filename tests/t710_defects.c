/* Deliberate defects of a rendered frame do not pass the gate, and the noise of drivers does. */
#include "compare/verdict.h"
#include "render_fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

#ifndef WIDTH
enum { WIDTH = 320, HEIGHT = 180 };
#endif
enum { COUNT = 20000 };

/* How a frame may be drawn wrongly. */
struct drawing {
    const char *renderer;
    double radius, scale; /* of particles, and of their values */
    size_t left_out;      /* every such one, from the first; 0: none */
    double nudge;         /* of the camera, m */
    bool mirrored;        /* the scene and the picture: only the light changes sides */
};

static const struct drawing right = {"auto", 0.012, 1, 0, 0, false};
static struct image accepted;
static struct fixture_cloud cloud;

static void flip(struct image *image)
{
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH / 2; x++) {
            uint8_t *a = image->rgba + 4 * (y * WIDTH + x);
            uint8_t *b = image->rgba + 4 * (y * WIDTH + WIDTH - 1 - x), kept[4];
            memcpy(kept, a, 4);
            memcpy(a, b, 4);
            memcpy(b, kept, 4);
        }
}

/* What is drawn of the cloud. */
static struct fixture_cloud altered(const struct drawing *how)
{
    struct fixture_cloud made = {0, malloc(cloud.count * 3 * sizeof(float)),
                                 malloc(cloud.count * sizeof(float))};
    for (size_t i = 0; i < cloud.count; i++) {
        float *p = made.position + 3 * made.count;
        if (how->left_out && i % how->left_out == 0)
            continue;
        memcpy(p, cloud.position + 3 * i, 3 * sizeof *p);
        p[0] = how->mirrored ? 1.6f - p[0] : p[0];
        made.value[made.count++] = cloud.value[i] * (float)how->scale;
    }
    return made;
}

/* 0 when the context is not in this build or cannot be had here. */
static int draw(const struct drawing *how, struct image *image, char name[200])
{
    static const double eye[3] = {2.15, 1.15, 2.3}, target[3] = {0.83, 0.35, 0.33};
    struct scene scene;
    struct renderer *renderer;
    struct error e;
    fixture_scene(&scene, WIDTH, HEIGHT);
    memcpy(scene.camera.eye, eye, sizeof eye);
    memcpy(scene.camera.target, target, sizeof target);
    scene.camera.eye[0] += how->nudge;
    if (how->mirrored) {
        scene.camera.eye[0] = 1.6 - eye[0];
        scene.camera.target[0] = 1.6 - target[0];
    }
    struct render_setup setup = fixture_setup(&scene, how->renderer);
    setup.radius = how->radius;
    if (renderer_open(&renderer, &setup, &e))
        return 0;
    snprintf(name, 200, "%s", renderer_name(renderer));
    struct fixture_cloud drawn = altered(how);
    struct render_frame frame = {.count = drawn.count, .position = drawn.position,
                                 .value = drawn.value};
    assert_int_equal(renderer_draw(renderer, &frame, image, &e), STATUS_OK);
    renderer_close(renderer);
    fixture_cloud_free(&drawn);
    if (how->mirrored)
        flip(image);
    return 1;
}

static struct image drawn(const struct drawing *how)
{
    struct image image = {0};
    char name[200];
    assert_int_equal(draw(how, &image, name), 1);
    return image;
}

static bool passes(const struct image *image, const char *gate, const char *what)
{
    const struct image *const versions[] = {&accepted};
    struct limits limits;
    struct verdict verdict;
    struct error e;
    assert_int_equal(gate_limits(&limits, gate, &e), STATUS_OK);
    assert_int_equal(verdict_make(&verdict, what, &limits, image, versions, 1, &e), STATUS_OK);
    printf("# %-32s %-12s %-9s", what, gate, verdict_word(verdict.state));
    for (size_t i = 0; i < metric_score_count(); i++)
        printf(" %s %.4g", metric_score(i)->name, verdict.values[i]);
    putchar('\n');
    return verdict_passes(verdict.state);
}

/* No gate lets it through. */
static void caught(struct image *image, const char *what)
{
    assert_false(passes(image, "cross-driver", what));
    assert_false(passes(image, "same-stack", what));
    assert_false(passes(image, "exact", what));
    image_free(image);
}

static void light_moved(void **state)
{
    struct drawing how = right;
    (void)state;
    how.mirrored = true;
    struct image image = drawn(&how), part = drawn(&right);
    for (size_t i = 0; i < 4 * metric_pixels(&part); i++) /* a fifth of the way: shading is nearly linear */
        part.rgba[i] = (uint8_t)((4 * part.rgba[i] + image.rgba[i] + 2) / 5);
    caught(&part, "light moved a fifth across");
    caught(&image, "light moved across");
}

static void colour_map(void **state)
{
    struct drawing how = right;
    (void)state;
    how.scale = 1.02;
    struct image image = drawn(&how);
    caught(&image, "colour map +2 %");
}

static void radius(void **state)
{
    struct drawing how = right;
    (void)state;
    how.radius *= 1.05;
    struct image image = drawn(&how);
    caught(&image, "radius +5 %");
}

static void missing_particles(void **state)
{
    struct drawing how = right;
    (void)state;
    how.left_out = 100;
    struct image image = drawn(&how);
    caught(&image, "1 % of particles missing");
}

static void red_and_blue(void **state)
{
    struct image image = drawn(&right);
    (void)state;
    for (size_t i = 0; i < metric_pixels(&image); i++) {
        uint8_t *p = image.rgba + 4 * i, red = p[0];
        p[0] = p[2];
        p[2] = red;
    }
    caught(&image, "red and blue swapped");
}

static void shifted(void **state)
{
    struct image image = drawn(&right);
    (void)state;
    memmove(image.rgba + 4, image.rgba, 4 * metric_pixels(&image) - 4);
    caught(&image, "shifted by a pixel");
}

/* One level up or down in every 2000th pixel, and everywhere. */
static void noise(void **state)
{
    (void)state;
    for (unsigned every = 2000; every; every = every == 1 ? 0 : 1) {
        struct image image = drawn(&right);
        uint64_t seed = 1;
        for (size_t i = 0; i < metric_pixels(&image); i++)
            if (i % every == 0) {
                uint8_t *p = image.rgba + 4 * i + (size_t)(3 * fixture_random(&seed));
                *p = (uint8_t)(*p == 255 || fixture_random(&seed) < 0.5 ? *p - (*p > 0) : *p + 1);
            }
        const char *what = every == 1 ? "one level, everywhere" : "one level, each 2000th pixel";
        assert_true(passes(&image, "same-stack", what));
        assert_false(passes(&image, "exact", what));
        assert_true(every == 1 || passes(&image, "cross-driver", what));
        image_free(&image);
    }
}

/* Spheres whose edges fall on other samples, as another rasteriser's do: the camera by 0.1 mm. */
static void rounding(void **state)
{
    struct drawing how = right;
    (void)state;
    how.nudge = 1e-4;
    struct image image = drawn(&how);
    assert_true(passes(&image, "cross-driver", "camera moved by 0.1 mm"));
    assert_false(passes(&image, "exact", "camera moved by 0.1 mm"));
    image_free(&image);
}

/* Each renderer that works here against the default one. */
static void renderers(void **state)
{
    (void)state;
    for (size_t i = 0; i < render_table.count; i++) {
        struct drawing how = right;
        struct image image = {0};
        char name[200];
        how.renderer = render_table.rows[i]->name;
        if (!render_table.rows[i]->missing && draw(&how, &image, name))
            assert_true(passes(&image, "cross-driver", name));
        image_free(&image);
    }
}

static void same(void **state)
{
    struct image image = drawn(&right);
    (void)state;
    assert_true(passes(&image, "exact", "drawn again"));
    image_free(&image);
}

static int begin(void **state)
{
    char name[200];
    (void)state;
    cloud = fixture_cloud(COUNT, 3);
    return draw(&right, &accepted, name) ? 0 : -1;
}

static int end(void **state)
{
    (void)state;
    fixture_cloud_free(&cloud);
    image_free(&accepted);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(same),         cmocka_unit_test(light_moved),
        cmocka_unit_test(colour_map),   cmocka_unit_test(radius),
        cmocka_unit_test(missing_particles), cmocka_unit_test(red_and_blue),
        cmocka_unit_test(shifted),      cmocka_unit_test(noise),
        cmocka_unit_test(rounding),     cmocka_unit_test(renderers),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
