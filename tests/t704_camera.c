/* The camera: automatic framing, orbit, and scenes that give it nothing sensible. */
#include "render/camera.h"
#include "render_fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

static const double boxes[][3] = {{1.6, 1.0, 0.67}, {1, 1, 1}, {10, 0.1, 0.1}, {0.1, 10, 0.1},
                                  {0.1, 0.1, 10},   {5, 5, 0.01}, {1e-4, 2e-4, 1e-4},
                                  {1e5, 2e4, 3e4}};
static const int sizes[][2] = {{1280, 720}, {720, 1280}, {64, 64}, {3840, 400}};

static void box_set(struct scene *scene, size_t i)
{
    for (int k = 0; k < 3; k++) {
        scene->domain.min[k] = i % 2 ? 1e6 : -3;
        scene->domain.max[k] = scene->domain.min[k] + boxes[i][k];
    }
}

/* All corners are in the picture, in front, and the domain fills at least `fill` of one side. */
static void assert_framed(const struct scene *scene, double time, double fill)
{
    struct camera camera;
    double low[2] = {1, 1}, high[2] = {-1, -1};
    camera_make(&camera, scene, 0, time);
    for (int i = 0; i < 8; i++) {
        double p[3], v[3];
        camera_corner(scene, i, 0, p);
        camera_view(&camera, p, v);
        assert_true(v[2] > 0);
        double at[2] = {v[0] / (v[2] * camera.tan_x), v[1] / (v[2] * camera.tan_y)};
        for (int k = 0; k < 2; k++) {
            assert_true(fabs(at[k]) <= 1);
            low[k] = fmin(low[k], at[k]);
            high[k] = fmax(high[k], at[k]);
        }
    }
    assert_true(fmax(high[0] - low[0], high[1] - low[1]) / 2 >= fill);
}

static void frames_any_box(void **state)
{
    struct scene scene;
    (void)state;
    for (size_t b = 0; b < sizeof boxes / sizeof boxes[0]; b++)
        for (size_t s = 0; s < sizeof sizes / sizeof sizes[0]; s++)
            for (int z_up = 0; z_up < 2; z_up++) {
                fixture_scene(&scene, sizes[s][0], sizes[s][1]);
                box_set(&scene, b);
                scene.camera.up[1] = !z_up;
                scene.camera.up[2] = z_up;
                assert_framed(&scene, 0, 0.85);
                scene.color.legend = true;
                assert_framed(&scene, 0, 0.5);
                scene.camera.orbit_period = 8;
                for (int i = 0; i < 16; i++)
                    assert_framed(&scene, i * 0.531, 0.1);
            }
}

static void orbit_turns_about_the_target(void **state)
{
    static const double eye[3] = {2.8, 1.5, 0.4}, target[3] = {0.8, 0.5, 0.4};
    struct scene scene;
    struct camera camera;
    (void)state;
    fixture_scene(&scene, 64, 48);
    memcpy(scene.camera.eye, eye, sizeof eye);
    memcpy(scene.camera.target, target, sizeof target);
    scene.camera.orbit_period = 4;
    camera_make(&camera, &scene, 0, 1); /* a quarter turn: x towards -z about y */
    assert_true(fabs(camera.eye[0] - 0.8) < 1e-12 && fabs(camera.eye[1] - 1.5) < 1e-12 &&
                fabs(camera.eye[2] + 1.6) < 1e-12);
    camera_make(&camera, &scene, 0, 8);
    for (int k = 0; k < 3; k++)
        assert_true(fabs(camera.eye[k] - eye[k]) < 1e-12);
}

static void assert_orthonormal(const struct scene *scene)
{
    struct camera camera;
    camera_make(&camera, scene, 0.01, 0);
    const double *axes[3] = {camera.right, camera.up, camera.forward};
    for (int a = 0; a < 3; a++)
        for (int b = 0; b < 3; b++) {
            double dot = 0;
            for (int k = 0; k < 3; k++)
                dot += axes[a][k] * axes[b][k];
            assert_true(fabs(dot - (a == b)) < 1e-9);
        }
    assert_true(isfinite(camera.eye[0] + camera.eye[1] + camera.eye[2]));
    assert_true(camera.tan_x > 0 && camera.tan_y > 0);
}

static void nothing_sensible(void **state)
{
    static const double down[3] = {0.8, 5, 0.4};
    struct scene scene;
    (void)state;
    fixture_scene(&scene, 64, 48);
    for (int k = 0; k < 3; k++)
        scene.camera.eye[k] = scene.camera.target[k] = 0.5; /* eye in the target */
    assert_orthonormal(&scene);
    memcpy(scene.camera.eye, down, sizeof down); /* along up */
    scene.camera.target[0] = 0.8;
    scene.camera.target[2] = 0.4;
    assert_orthonormal(&scene);
    scene.camera.up[1] = 0;
    assert_orthonormal(&scene);
    scene.camera.up[0] = NAN;
    scene.camera.fov = NAN;
    scene.camera.orbit_period = NAN;
    assert_orthonormal(&scene);
    scene.camera.eye[1] = NAN;
    scene.camera.fov = 500;
    assert_orthonormal(&scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(frames_any_box),
        cmocka_unit_test(orbit_turns_about_the_target),
        cmocka_unit_test(nothing_sensible),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
