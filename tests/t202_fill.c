/* Tests the filling of bodies and walls: counts, volume, seeds, containment, wall layers. */
#include "world.h"

#include "particles/start.h"
#include "scene/shape.h"

#define HEAD "{\"domain\": {\"min\": [0, 0, 0], \"max\": [1, 1, 1]%s},\n" \
             " \"particles\": {\"spacing\": 0.05}, \"time\": {\"end\": 1},\n" \
             " \"fluids\": [{\"name\": \"a\", \"density\": 1000}," \
             "            {\"name\": \"b\", \"density\": 800}],\n"

static struct scene *load(const char *walls, const char *bodies)
{
    static char text[4000];
    struct scene *scene;
    struct error e;
    int n = snprintf(text, sizeof text, HEAD " \"bodies\": [%s]}", walls, bodies);
    if (scene_from_text(&scene, text, (size_t)n, NULL, &run_vocabulary, &e))
        fail_msg("%s", e.text);
    return scene;
}

static struct fill fill(const struct scene *scene)
{
    struct fill f;
    struct error e = {0};
    assert_int_equal(fill_bodies(scene, &f, &e), STATUS_OK);
    return f;
}

static void assert_inside(const struct scene *scene, const struct fill *f)
{
    for (size_t i = 0; i < f->count; i++)
        for (int a = 0; a < 3; a++)
            if (!(f->point[i][a] > scene->domain.min[a] && f->point[i][a] < scene->domain.max[a]))
                fail_msg("point %zu lies at %g along axis %d", i, f->point[i][a], a);
}

#define BOX_A "{\"fluid\": \"a\", \"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.5, 0.4, 1]"
#define BOX_B "{\"fluid\": \"b\", \"shape\": \"box\", \"min\": [0.6, 0, 0], \"max\": [0.9, 0.33, 1]"
#define BALL "{\"fluid\": \"b\", \"shape\": \"sphere\", \"center\": [0.5, 0.7, 0.5], \"radius\": 0.25"

static void fills_boxes(void **state)
{
    (void)state;
    struct scene *scene = load("", BOX_A "}");
    struct fill f = fill(scene);
    assert_int_equal(f.count, 10 * 8 * 20);
    assert_true(fabs(f.point[0][0] - 0.025) < 1e-12 && fabs(f.point[1][0] - 0.075) < 1e-12);
    assert_inside(scene, &f);
    fill_free(&f);
    scene_free(scene);
}

/* Particle volumes add up to the bodies', also where no whole number of spacings fits. */
static void keeps_volume(void **state)
{
    (void)state;
    struct scene *scene = load("", BOX_A "}, " BOX_B "}");
    struct fill f = fill(scene);
    double volume[2];
    size_t count[2];
    start_count(scene, &f, volume, count);
    assert_true(fabs(volume[0] - 0.2) < 1e-9);
    assert_true(fabs(volume[1] - 0.3 * 0.33) < 1e-9);
    assert_int_equal(count[0] + count[1], f.count);
    fill_free(&f);
    scene_free(scene);
}

/* Summed mass over summed density: m = rho V / (N S) with the lattice sum S of the kernel. */
static void keeps_mass(void **state)
{
    struct world w;
    (void)state;
    world_open(&w, HEAD " \"bodies\": [" BOX_A "}, " BOX_B "}]}", "");
    double mass[2] = {0}, s = kernel_lattice_sum(w.plan.choice.kernel, 2.6);
    for (size_t i = 0; i < world_state(&w)->count; i++)
        mass[particles_fluid(world_state(&w), i)] += world_mass(&w, i);
    print_message("# mass of the fluids %.6f and %.6f kg, lattice sum %.6f\n", mass[0], mass[1], s);
    assert_true(fabs(mass[0] * s / (1000 * 0.2) - 1) < 1e-5);
    assert_true(fabs(mass[1] * s / (800 * 0.3 * 0.33) - 1) < 1e-5);
    world_close(&w);
}

static void fills_balls(void **state)
{
    (void)state;
    struct scene *scene = load("", BALL "}");
    struct fill f = fill(scene);
    double exact = shape_volume(&scene->bodies[0].shape);
    assert_true(fabs((double)f.count * 1.25e-4 / exact - 1) < 0.06);
    for (size_t i = 0; i < f.count; i++)
        assert_true(hypot(hypot(f.point[i][0] - 0.5, f.point[i][1] - 0.7), f.point[i][2] - 0.5) <
                    0.25 + 1e-9);
    fill_free(&f);
    scene_free(scene);
}

static bool same(const struct fill *a, const struct fill *b)
{
    return a->count == b->count &&
           memcmp(a->point, b->point, a->count * sizeof *a->point) == 0;
}

static void seeds(const char *one, const char *other)
{
    struct scene *s1 = load("", one), *s2 = load("", other);
    struct fill a = fill(s1), b = fill(s1), c = fill(s2);
    assert_true(same(&a, &b));
    assert_false(same(&a, &c));
    assert_int_equal(a.count, c.count);
    assert_inside(s1, &a);
    assert_inside(s2, &c);
    fill_free(&a);
    fill_free(&b);
    fill_free(&c);
    scene_free(s1);
    scene_free(s2);
}

static void repeats_with_its_seed(void **state)
{
    (void)state;
    seeds(BOX_A ", \"fill\": \"random\", \"seed\": 1}", BOX_A ", \"fill\": \"random\", \"seed\": 2}");
    seeds(BOX_A ", \"jitter\": 0.3, \"seed\": 1}", BOX_A ", \"jitter\": 0.3, \"seed\": 2}");
}

static void jitters_as_asked(void **state)
{
    (void)state;
    struct scene *scene = load("", BALL "}"), *shaken = load("", BALL ", \"jitter\": 0.2}");
    struct fill a = fill(scene), b = fill(shaken);
    double sum = 0, squares = 0;
    assert_int_equal(a.count, b.count);
    for (size_t i = 0; i < a.count; i++)
        for (int k = 0; k < 3; k++) {
            double off = (b.point[i][k] - a.point[i][k]) / 0.05;
            sum += off;
            squares += off * off;
        }
    double n = 3.0 * (double)a.count;
    assert_true(fabs(sum / n) < 0.02);
    assert_true(fabs(sqrt(squares / n) / 0.2 - 1) < 0.06);
    fill_free(&a);
    fill_free(&b);
    scene_free(scene);
    scene_free(shaken);
}

/* How many layers of d = 0.05 m lie below the floor for a support of `depth` metres. */
static void lays_wall_layers(void **state)
{
    (void)state;
    struct scene *scene = load(", \"walls\": {\"-y\": \"particles\"}", "");
    struct error e = {0};
    struct fill f;
    assert_int_equal(fill_walls(scene, 0.13, &f, &e), STATUS_OK);
    assert_int_equal(f.count, 3 * 20 * 20);
    for (size_t i = 0; i < f.count; i++)
        assert_true(f.point[i][1] < 0 && f.point[i][1] > -0.13 - 0.05);
    fill_free(&f);
    scene_free(scene);
    scene = load(", \"walls\": \"particles\"", "");
    assert_int_equal(fill_walls(scene, 0.1, &f, &e), STATUS_OK);
    assert_int_equal(f.count, 24 * 24 * 24 - 20 * 20 * 20); /* edges and corners are closed */
    fill_free(&f);
    scene_free(scene);
    scene = load("", "");
    assert_int_equal(fill_walls(scene, 0.1, &f, &e), STATUS_OK);
    assert_int_equal(f.count, 0);
    fill_free(&f);
    scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fills_boxes),      cmocka_unit_test(keeps_volume),
        cmocka_unit_test(keeps_mass),       cmocka_unit_test(fills_balls),
        cmocka_unit_test(jitters_as_asked), cmocka_unit_test(repeats_with_its_seed),
        cmocka_unit_test(lays_wall_layers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
