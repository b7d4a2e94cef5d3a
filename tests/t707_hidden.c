/* Spheres left out as hidden: none that a drawn sample would show, and most of a body of fluid. */
#include "render/hidden.h"
#include "render_fixture.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

enum { WIDTH = 64, HEIGHT = 40, COUNT = 6000 };

struct sphere {
    double view[3], square; /* centre in camera axes, and its squared length */
    bool kept;
};

/* Of the spheres that the ray through one sample meets, the first one must have been kept. */
static bool sample_is_right(const struct camera *camera, const struct sphere *spheres, double x,
                            double y, double radius)
{
    double a = (2 * x / WIDTH - 1) * camera->tan_x, b = (2 * y / HEIGHT - 1) * camera->tan_y;
    double length = sqrt(a * a + b * b + 1), best = INFINITY;
    bool right = true;
    for (int i = 0; i < COUNT; i++) {
        const double *c = spheres[i].view;
        double along = (a * c[0] + b * c[1] + c[2]) / length;
        double half2 = radius * radius - (spheres[i].square - along * along);
        if (half2 < 0 || spheres[i].square <= radius * radius || along - sqrt(half2) >= best ||
            along - sqrt(half2) <= 0)
            continue;
        best = along - sqrt(half2);
        right = spheres[i].kept;
    }
    return right;
}

static size_t check(const struct scene *scene, double radius)
{
    static uint32_t packed[COUNT][4];
    static struct sphere spheres[COUNT];
    static float depth[WIDTH * HEIGHT];
    struct fixture_cloud cloud = fixture_cloud(COUNT, 5);
    struct camera camera;
    size_t kept, wrong = 0;
    camera_make(&camera, scene, radius, 0);
    for (uint32_t i = 0; i < COUNT; i++) {
        const float *p = cloud.position + 3 * i;
        double point[3] = {p[0], p[1], p[2]}, *v = spheres[i].view;
        memcpy(packed[i], p, 3 * sizeof *p);
        packed[i][3] = i;
        camera_view(&camera, point, v);
        spheres[i].square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        spheres[i].kept = false;
    }
    kept = hidden_drop(&camera, packed, COUNT, radius, 2, depth);
    for (size_t i = 0; i < kept; i++) {
        spheres[packed[i][3]].kept = true;
        assert_true(i == 0 || packed[i][3] > packed[i - 1][3]); /* in their order */
    }
    for (int y = 0; y < 2 * HEIGHT; y++)
        for (int x = 0; x < 2 * WIDTH; x++)
            wrong += !sample_is_right(&camera, spheres, x / 2.0 + 0.25, y / 2.0 + 0.25, radius);
    printf("# radius %g: %zu of %d kept, %zu samples wrong\n", radius, kept, COUNT, wrong);
    assert_int_equal(wrong, 0);
    fixture_cloud_free(&cloud);
    return kept;
}

static void nothing_seen_is_dropped(void **state)
{
    static const double inside[3] = {0.5, 0.1, 0.3}, along[3] = {1.6, 0.1, 0.3};
    struct scene scene;
    (void)state;
    fixture_scene(&scene, WIDTH, HEIGHT);
    check(&scene, 0.004);
    check(&scene, 0.015);
    assert_true(check(&scene, 0.05) < COUNT * 2 / 3);
    assert_true(check(&scene, 0.2) < COUNT * 2 / 3);
    memcpy(scene.camera.eye, inside, sizeof inside); /* in the fluid */
    memcpy(scene.camera.target, along, sizeof along);
    scene.camera.fov = 100;
    check(&scene, 0.02);
    check(&scene, 0.06);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(nothing_seen_is_dropped)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
