/* The camera: automatic framing, orbit, keyframes, and scenes that give it nothing sensible. */
#include "render/camera.h"
#include "render/camera_path.h"
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
        double at[2] = {v[0] / (camera.orthographic ? camera.half_x : v[2] * camera.tan_x),
                        v[1] / (camera.orthographic ? camera.half_y : v[2] * camera.tan_y)};
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
            for (int kind = 0; kind < 4; kind++) {
                int z_up = kind & 1;
                fixture_scene(&scene, sizes[s][0], sizes[s][1]);
                box_set(&scene, b);
                scene.camera.up[1] = !z_up;
                scene.camera.up[2] = z_up;
                scene.camera.projection = (enum camera_projection)(kind >> 1);
                assert_framed(&scene, 0, 0.85);
                scene.color.legend = true;
                assert_framed(&scene, 0, 0.5);
                scene.camera.orbit_period = 8;
                for (int i = 0; i < 16; i++)
                    assert_framed(&scene, i * 0.531, 0.1);
            }
}

/* A channel is seen from its side, whichever way it runs. */
static void channels_lie_across(void **state)
{
    struct scene scene;
    struct camera camera;
    (void)state;
    for (int axis = 0; axis < 3; axis += 2) {
        double low = 1, high = -1;
        fixture_scene(&scene, 1280, 720);
        for (int k = 0; k < 3; k++)
            scene.domain.max[k] = k == axis ? 10 : 0.5;
        camera_make(&camera, &scene, 0, 0);
        for (int i = 0; i < 8; i++) {
            double p[3], v[3];
            camera_corner(&scene, i, 0, p);
            camera_view(&camera, p, v);
            low = fmin(low, v[0] / (v[2] * camera.tan_x));
            high = fmax(high, v[0] / (v[2] * camera.tan_x));
            assert_true(v[2] > 5); /* m: not along it */
        }
        assert_true(high - low > 1.8);
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

/* An orthographic picture has the height that is said, or that fov shows at the target. */
static void orthographic_heights(void **state)
{
    static const double eye[3] = {0.8, 0.5, 3.4}, target[3] = {0.8, 0.5, 0.4};
    struct scene scene;
    struct camera camera;
    (void)state;
    fixture_scene(&scene, 64, 48);
    scene.camera.projection = PROJECTION_ORTHOGRAPHIC;
    scene.camera.height = NAN;
    memcpy(scene.camera.eye, eye, sizeof eye);
    memcpy(scene.camera.target, target, sizeof target);
    camera_make(&camera, &scene, 0, 0);
    assert_true(fabs(camera.half_y - 3 * tan(35 * 3.141592653589793 / 360)) < 1e-12);
    assert_true(fabs(camera.half_x - camera.half_y * 4 / 3) < 1e-12);
    assert_true(camera.eye[2] == 3.4);
    scene.camera.height = 1.5;
    scene.camera.eye[2] = 0.5; /* inside the domain: goes back, the picture stays */
    camera_make(&camera, &scene, 0, 0);
    assert_true(camera.half_y == 0.75 && camera.eye[2] > 0.67);
    assert_true(fabs(camera.eye[0] - 0.8) < 1e-12 && fabs(camera.eye[1] - 0.5) < 1e-12);
    scene.camera.eye[0] = NAN;
    camera_make(&camera, &scene, 0, 0);
    assert_true(camera.half_y == 0.75);
}

/* Keys at uneven times, targets and angles left to the scene but in the second. */
static void keyframes_make(struct scene *scene, struct scene_keyframe keys[5])
{
    static const double times[5] = {0.5, 1, 2.5, 3, 7};
    fixture_scene(scene, 64, 48);
    scene->keyframes = keys;
    scene->keyframe_count = 5;
    for (int i = 0; i < 5; i++) {
        keys[i] = (struct scene_keyframe){times[i], {3 + i * i, 1 - 0.3 * i, 4 + sin(i)},
                                          {NAN, NAN, NAN}, {NAN, NAN, NAN}, NAN};
    }
    for (int k = 0; k < 3; k++) {
        keys[1].target[k] = 0.1 * k;
        keys[1].up[k] = k == 1 ? 2 : 0.5;
    }
    keys[1].fov = 50;
}

static void keyframes_are_met(void **state)
{
    static const double middle[3] = {0.8, 0.5, 0.335};
    struct scene scene;
    struct scene_keyframe keys[5], at;
    (void)state;
    keyframes_make(&scene, keys);
    for (int i = 0; i < 5; i++) {
        camera_path(&scene, keys[i].time, &at);
        assert_memory_equal(at.eye, keys[i].eye, sizeof at.eye);
        assert_memory_equal(at.target, i == 1 ? keys[1].target : middle, sizeof at.target);
        assert_true(at.fov == (i == 1 ? 50 : 35) && at.up[1] == (i == 1 ? 2 : 1));
        struct camera camera;
        camera_make(&camera, &scene, 0, keys[i].time);
        for (int k = 0; k < 3; k++)
            assert_true(fabs(camera.eye[k] - keys[i].eye[k]) < 1e-12);
    }
    camera_path(&scene, 0, &at); /* still before the first and after the last */
    assert_memory_equal(at.eye, keys[0].eye, sizeof at.eye);
    camera_path(&scene, 100, &at);
    assert_memory_equal(at.eye, keys[4].eye, sizeof at.eye);
    scene.keyframe_count = 1;
    camera_path(&scene, 3, &at);
    assert_memory_equal(at.eye, keys[0].eye, sizeof at.eye);
}

/* Position and speed have no jump where segments meet. */
static void keyframes_are_smooth(void **state)
{
    struct scene scene;
    struct scene_keyframe keys[5], before, at, after;
    const double dt = 1e-6;
    (void)state;
    keyframes_make(&scene, keys);
    for (int i = 1; i < 4; i++) {
        camera_path(&scene, keys[i].time - dt, &before);
        camera_path(&scene, keys[i].time, &at);
        camera_path(&scene, keys[i].time + dt, &after);
        for (int k = 0; k < 3; k++) {
            double in = (at.eye[k] - before.eye[k]) / dt, out = (after.eye[k] - at.eye[k]) / dt;
            assert_true(fabs(in) < 100 && fabs(in - out) < 1e-3);
        }
    }
}

static void even_motion_stays_even(void **state)
{
    static const double from[3] = {3, 1, -2}, speed[3] = {0.5, -2, 0.25};
    struct scene scene;
    struct scene_keyframe keys[5], at;
    (void)state;
    keyframes_make(&scene, keys);
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++) {
            keys[i].eye[k] = from[k] + speed[k] * keys[i].time;
            keys[i].target[k] = -keys[i].eye[k];
        }
    for (size_t count = 2; count <= 5; count++) {
        scene.keyframe_count = count;
        for (double t = 0.5; t <= keys[count - 1].time; t += 1.0 / 64) {
            camera_path(&scene, t, &at);
            for (int k = 0; k < 3; k++) {
                assert_true(fabs(at.eye[k] - (from[k] + speed[k] * t)) < 1e-14 * 64);
                assert_true(fabs(at.target[k] + at.eye[k]) < 1e-14 * 64);
            }
        }
    }
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
        cmocka_unit_test(channels_lie_across),
        cmocka_unit_test(orbit_turns_about_the_target),
        cmocka_unit_test(orthographic_heights),
        cmocka_unit_test(keyframes_are_met),
        cmocka_unit_test(keyframes_are_smooth),
        cmocka_unit_test(even_motion_stays_even),
        cmocka_unit_test(nothing_sensible),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
