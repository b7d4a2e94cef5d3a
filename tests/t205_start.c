/* Tests the pressure that bodies start with: which are settled tanks, layers, walls, densities. */
#include "world.h"

#include "particles/hydrostatic.h"

#define SCENE(walls, more, bodies) \
    "{\"gravity\": [0, -10, 0], \"particles\": {\"spacing\": 0.05}, \"time\": {\"end\": 1},\n" \
    "\"domain\": {\"min\": [0, 0, 0], \"max\": [1, 1, 0.4], \"walls\": " walls "},\n" \
    "\"fluids\": [{\"name\": \"water\"}, {\"name\": \"oil\", \"density\": 800}],\n" \
    more "\"bodies\": [" bodies "]}"
#define BOX(fluid, x, y, X, Y, more) \
    "{\"fluid\": \"" fluid "\", \"shape\": \"box\", \"min\": [" #x ", " #y ", 0], " \
    "\"max\": [" #X ", " #Y ", 0.4]" more "}"
#define CLOSED "\"closed\""
#define SIDES "{\"-x\": \"periodic\", \"+x\": \"periodic\"}"
#define FLOOR "{\"-y\": \"periodic\", \"+y\": \"periodic\"}"
#define POOL BOX("water", 0, 0, 1, 0.4, "")

/* Which bodies start hydrostatic: "yn" is the first and not the second. */
static const struct { const char *bodies, *text; } cases[] = {
    {"y", SCENE(CLOSED, "", POOL)},
    {"y", SCENE("\"particles\"", "", POOL)},
    {"y", SCENE(SIDES, "", POOL)},
    {"n", SCENE(FLOOR, "", POOL)},
    {"n", SCENE(CLOSED, "", BOX("water", 0, 0, 0.5, 0.4, ""))},            /* dam break */
    {"n", SCENE(SIDES, "", BOX("water", 0, 0, 0.5, 0.4, ""))},             /* open behind the join */
    {"n", SCENE(CLOSED, "", BOX("water", 0, 0.2, 1, 0.4, ""))},            /* falls */
    {"y", SCENE(CLOSED, "", BOX("water", 0, 0.02, 0.98, 0.4, ""))},        /* gaps below d/2 */
    {"n", SCENE(CLOSED, "", BOX("water", 0, 0, 1, 0.4, ", \"velocity\": [0.1, 0, 0]"))},
    {"n", SCENE(CLOSED, "", BOX("water", 0, 0, 1, 0.4, ", \"flow\": \"shear\""))},
    {"y", SCENE(CLOSED, "", BOX("water", 0, 0, 1, 0.4, ", \"flow\": \"shear\", \"flow_speed\": 0"))},
    {"n", SCENE(CLOSED, "", BOX("water", 0, 0, 1, 0.4, ", \"start\": \"rest\""))},
    {"y", SCENE(CLOSED, "", BOX("water", 0, 0, 0.5, 0.4, ", \"start\": \"hydrostatic\""))},
    {"yy", SCENE(CLOSED, "", POOL ", " BOX("oil", 0, 0.4, 1, 0.6, ""))},
    {"yn", SCENE(CLOSED, "", POOL ", " BOX("oil", 0, 0.4, 0.5, 0.6, ""))},  /* a block on the pool */
    {"yy", SCENE(CLOSED, "", BOX("water", 0, 0, 0.5, 0.4, "") ", " BOX("oil", 0.5, 0, 1, 0.4, ""))},
    {"nn", SCENE(CLOSED, "", BOX("water", 0, 0, 0.5, 0.4, "") ", " BOX("oil", 0.5, 0, 1, 0.5, ""))},
    {"yyy", SCENE(CLOSED, "", BOX("water", 0, 0, 0.5, 0.4, "") ", " BOX("water", 0.5, 0, 1, 0.4, "")
                  ", " BOX("oil", 0, 0.4, 1, 0.6, ""))},
    {"nn", SCENE(CLOSED, "", BOX("water", 0, 0, 0.5, 0.4, "") ", " BOX("oil", 0, 0.4, 1, 0.6, ""))},
    {"yn", SCENE(CLOSED, "", POOL ", {\"shape\": \"sphere\", \"center\": [0.5, 0.7, 0.2], "
                                  "\"radius\": 0.1}")},
};

static struct scene *load(const char *text, const char *gravity)
{
    const char *items[] = {gravity};
    struct scene_overrides set = {items, NULL, gravity ? 1 : 0};
    struct scene *scene;
    struct error e;
    if (scene_from_text(&scene, text, strlen(text), &set, &run_vocabulary, &e))
        fail_msg("%s", e.text);
    return scene;
}

static void assert_bodies(const char *expected, const char *text, const char *gravity)
{
    struct hydrostatic h;
    struct error e = {0};
    struct scene *scene = load(text, gravity);
    assert_int_equal(hydrostatic_create(&h, scene, &e), STATUS_OK);
    for (size_t b = 0; b < scene->body_count; b++)
        if (h.body[b] != (expected[b] == 'y'))
            fail_msg("body %zu is %d, not as in \"%s\": %s", b, h.body[b], expected, text);
    hydrostatic_free(&h);
    scene_free(scene);
}

static void finds_settled_tanks(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        assert_bodies(cases[i].bodies, cases[i].text, NULL);
}

#define FULL SCENE(CLOSED, "", BOX("water", 0, 0, 1, 1, ""))

/* Gravity along other axes or none; tilted, a tank is settled only when it is full. */
static void follows_gravity(void **state)
{
    (void)state;
    assert_bodies("n", SCENE(CLOSED, "", POOL), "gravity=[0, 0, 0]");
    assert_bodies("n", SCENE(CLOSED, "", POOL), "gravity=[5, -8.66, 0]");
    assert_bodies("n", SCENE(CLOSED, "", POOL), "gravity=[9, 0, 0]");
    assert_bodies("n", SCENE(CLOSED, "", POOL), "gravity=[0, 9, 0]");
    assert_bodies("y", SCENE(CLOSED, "", BOX("water", 0, 0.6, 1, 1, "")), "gravity=[0, 9, 0]");
    assert_bodies("y", SCENE(CLOSED, "", BOX("water", 0.6, 0, 1, 1, "")), "gravity=[9, 0, 0]");
    assert_bodies("y", FULL, "gravity=[5, -8.66, 0]");
}

static double pressure(const char *text, const char *gravity, size_t body, double x, double y)
{
    struct hydrostatic h;
    struct error e = {0};
    double at[3] = {x, y, 0.2};
    struct scene *scene = load(text, gravity);
    assert_int_equal(hydrostatic_create(&h, scene, &e), STATUS_OK);
    double p = hydrostatic_pressure(&h, body, at);
    hydrostatic_free(&h);
    scene_free(scene);
    return p;
}

static void assert_near(double value, double expected)
{
    if (fabs(value - expected) > 1e-9 * (1 + fabs(expected)))
        fail_msg("%.12g, not %.12g", value, expected);
}

#define LAYERS SCENE(CLOSED, "", POOL ", " BOX("oil", 0, 0.4, 1, 0.6, "") ", " \
                     BOX("water", 0, 0.6, 1, 0.7, ""))

static void layers_add_up(void **state)
{
    (void)state;
    assert_near(pressure(LAYERS, NULL, 2, 0.5, 0.65), 500);
    assert_near(pressure(LAYERS, NULL, 1, 0.5, 0.5), 1000 + 800);
    assert_near(pressure(LAYERS, NULL, 0, 0.5, 0.1), 1000 + 1600 + 3000);
    assert_near(pressure(LAYERS, NULL, 0, -0.01, 0.41), 1000 + 1600); /* jitter */
    assert_near(pressure(SCENE(CLOSED, "", POOL), NULL, 0, 0.5, 0.5), 0);
    /* A full tank under tilted gravity: depth below the corner (0, 1). */
    assert_near(pressure(FULL, "gravity=[6, -8, 0]", 0, 0.5, 0.25), 1000 * (6 * 0.5 + 8 * 0.75));
}

/* The pressure goes into the state, and its density gives it back. */
static void reaches_the_state(void **state)
{
    (void)state;
    static const char *const solvers[] = {"\"method\": \"wcsph\", \"eos\": \"tait\"",
                                         "\"method\": \"wcsph\", \"eos\": \"linear\""};
    for (size_t s = 0; s < 2; s++) {
        struct world w;
        world_open(&w, SCENE(CLOSED, "\"solver\": {%s},", POOL ", " BOX("oil", 0, 0.4, 1, 0.6, "")),
                   solvers[s]);
        double worst = 0, mass = 0, c2 = pow(w.plan.choice.sound_speed, 2);
        for (size_t i = 0; i < world_state(&w)->count; i++) {
            double y = world_metres(&w, i, 1);
            double exact = y > 0.4 ? 8000 * (0.6 - y) : 1600 + 10000 * (0.4 - y);
            worst = fmax(worst, fabs((double)particles_motion(world_state(&w))[i].pressure - exact));
            mass += world_mass(&w, i);
        }
        double lattice = kernel_lattice_sum(w.plan.choice.kernel, 2.6);
        print_message("# {%s}: pressure off by %.1e of %.0f Pa\n", solvers[s], worst, 5600.0);
        assert_true(worst < 2e-7 * 1000 * c2); /* the last bit of density */
        assert_true(fabs(mass * lattice / (160 + 64) - 1) < 1e-5);
        world_close(&w);
    }
}

/* explicit_state undoes explicit_density. */
static void inverts_the_equation_of_state(void **state)
{
    (void)state;
    for (int tait = 0; tait < 2; tait++) {
        struct explicit_constants c = {.tait = tait != 0, .rest_density = {1000}, .bulk = {1e5f},
                                       .mass = {1000}};
        assert_true(explicit_density(&c, 0, 0) == 1000);
        for (float p = tait ? -9e4f : -4e4f; p < 1e7f; p = p < 0 ? p / 2 + 50 : p * 1.7f + 1) {
            float back, volume, density = explicit_density(&c, 0, p);
            explicit_state(&c, 0, density, &back, &volume);
            assert_true(fabs((double)(back - p)) < 3e-6 * (fabs((double)p) + 1e5));
        }
        assert_true(explicit_density(&c, 0, -1e6f) == 500);
    }
}

/* An error in place of nonsense: no floor, and a fluid too soft for its own weight. */
static void refuses(void **state)
{
    (void)state;
    struct scene *scene;
    struct error e;
    struct world w = {0};
    const char *text = SCENE(FLOOR, "", BOX("water", 0, 0, 1, 0.4, ", \"start\": \"hydrostatic\""));
    assert_int_equal(scene_from_text(&scene, text, strlen(text), NULL, &run_vocabulary, &e),
                     STATUS_USAGE);
    assert_non_null(strstr(e.text, "bodies.0.start is hydrostatic, but gravity acts along y"));
    text = SCENE(CLOSED, "\"solver\": {\"method\": \"wcsph\", \"sound_speed\": 0.1},", POOL);
    w.scene = load(text, NULL);
    e = (struct error){0};
    w.options = (struct run_options){.threads = 1};
    assert_int_equal(plan_make(&w.plan, w.scene, &w.options, &e), STATUS_OK);
    assert_int_equal(simulation_open(&w.simulation, &w.plan, &w.options, &e), STATUS_USAGE);
    assert_non_null(strstr(e.text, "raise solver.sound_speed"));
    world_close(&w);
}

int main(void)
{
    log_set_level(LOG_ERROR);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(finds_settled_tanks), cmocka_unit_test(follows_gravity),
        cmocka_unit_test(layers_add_up),       cmocka_unit_test(reaches_the_state),
        cmocka_unit_test(inverts_the_equation_of_state), cmocka_unit_test(refuses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
