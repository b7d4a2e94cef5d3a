/* The shadow on the floor: where the light says, the same from any threads and order, none off the grid. */
#include "render_fixture.h"

#include "render/look.h"
#include "render/shadow.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

static const struct shadow_floor floors[] = {{1, false}, {1, true}, {0, false}, {2, true}};

/* A camera whose up is away from the floor. */
static void scene_make(struct scene *scene, struct camera *camera, struct shadow_floor floor)
{
    fixture_scene(scene, 160, 90);
    scene->particles.spacing = 0.01;
    for (int k = 0; k < 3; k++)
        scene->camera.up[k] = k != floor.axis ? 0 : floor.at_max ? -1 : 1;
    camera_make(camera, scene, 0.01, 0);
}

/* The middle of what is shaded, m along the two axes after the floor's; returns how much is. */
static double middle_of(const struct shadow *s, double middle[2])
{
    double sum = 0;
    middle[0] = middle[1] = 0;
    for (int i = 0; i <= s->cells[0]; i++)
        for (int j = 0; j <= s->cells[1]; j++) {
            double taken = (double)shadow_taken(s, i, j);
            assert_true(taken >= 0 && taken <= 1);
            sum += taken;
            middle[0] += taken * i * s->cell[0];
            middle[1] += taken * j * s->cell[1];
        }
    middle[0] /= sum;
    middle[1] /= sum;
    return sum;
}

/* A drop at some height falls where the ray from the key light through it meets the floor. */
static void a_drop_falls_along_the_light(void **state)
{
    (void)state;
    for (size_t f = 0; f < sizeof floors / sizeof *floors; f++) {
        struct scene scene;
        struct camera camera;
        struct shadow shadow;
        float position[3];
        double middle[2], key[3];
        int axis = floors[f].axis;
        scene_make(&scene, &camera, floors[f]);
        struct look look = look_make(0);
        for (int k = 0; k < 3; k++) {
            key[k] = (double)look.key[0] * camera.right[k] + (double)look.key[1] * camera.up[k] -
                     (double)look.key[2] * camera.forward[k];
            position[k] = (float)scene.domain.max[k] / 2;
        }
        const double height = 0.2;
        position[axis] = (float)(floors[f].at_max ? scene.domain.max[axis] - height : height);
        struct render_frame frame = {.count = 1, .position = position};
        shadow_make(&shadow, &scene, &camera, floors[f], &frame, 1);
        assert_true(middle_of(&shadow, middle) > 0);
        for (int k = 0; k < 2; k++) {
            int a = (axis + 1 + k) % 3;
            double at = (double)position[a] - key[a] * height / fabs(key[axis]);
            assert_true(fabs(key[axis]) > 0.7);
            assert_true(fabs(middle[k] - at) < 0.002);
        }
    }
}

static void the_same_from_any_threads_and_order(void **state)
{
    struct scene scene;
    struct camera camera;
    static struct shadow one, next;
    struct fixture_cloud cloud = fixture_cloud(20000, 7);
    (void)state;
    scene_make(&scene, &camera, floors[0]);
    struct render_frame frame = {.count = cloud.count, .position = cloud.position};
    shadow_make(&one, &scene, &camera, floors[0], &frame, 1);
    for (size_t i = 0; i < cloud.count / 2; i++)
        for (int k = 0; k < 3; k++) {
            float *a = cloud.position + 3 * i + k, *b = cloud.position + 3 * (cloud.count - 1 - i) + k, t = *a;
            *a = *b;
            *b = t;
        }
    for (int threads = 1; threads <= 5; threads += 2) {
        shadow_make(&next, &scene, &camera, floors[0], &frame, threads);
        assert_memory_equal(&one, &next, sizeof one);
    }
    fixture_cloud_free(&cloud);
}

static void nothing_falls_from_outside(void **state)
{
    const float position[] = {NAN, 0.5F, 0.3F, 0.5F, INFINITY, 0.3F, -9, 0.1F, 0.3F, 0.5F, 1e30F, 0.3F};
    struct scene scene;
    struct camera camera;
    struct shadow shadow;
    (void)state;
    scene_make(&scene, &camera, floors[0]);
    struct render_frame frame = {.count = 4, .position = position};
    shadow_make(&shadow, &scene, &camera, floors[0], &frame, 2);
    for (int i = 0; i <= shadow.cells[0]; i++)
        for (int j = 0; j <= shadow.cells[1]; j++)
            assert_true(shadow_taken(&shadow, i, j) == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_drop_falls_along_the_light),
        cmocka_unit_test(the_same_from_any_threads_and_order),
        cmocka_unit_test(nothing_falls_from_outside),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
