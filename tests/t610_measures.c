/* Measured quantities against values by hand: a lattice at rest, a moving block, quantiles. */
#include "run/measure.h"
#include "world.h"

#include <stdlib.h>

#define SCENE(gravity, velocity, jitter, measure)                                                  \
    SCENE_ABOVE("0", gravity, velocity, jitter, measure)
#define SCENE_ABOVE(floor, gravity, velocity, jitter, measure)                                     \
    "{\"gravity\": " gravity ", \"domain\": {\"min\": [0, " floor ", 0], \"max\": [1, 1, 1]},"   \
    " \"particles\": {\"spacing\": 0.1}, \"fluids\": [{\"density\": 1000}],"                       \
    " \"bodies\": [{\"shape\": \"box\", \"min\": [0.2, 0, 0.2], \"max\": [0.6, 0.4, 0.6],"         \
    " \"velocity\": " velocity ", \"jitter\": " jitter "}], \"measure\": [" measure "],"           \
    " \"time\": {\"end\": 1}}"
#define DOWN "[0, -9.81, 0]"
#define MOVING "[1, 2, 3]"

static struct world w;
static struct measures measures;

static void take(double time)
{
    struct simulation *s = &w.simulation;
    if (!measures.count &&
        measures_create(&measures, w.scene, w.plan.bodies.count, &w.error))
        fail_msg("%s", w.error.text);
    measures_take(&measures, w.scene, &w.plan.space, &w.plan.choice, world_state(&w),
                  time);
}

/* The number under that heading. */
static double column(const char *name)
{
    for (size_t i = 0; i < measures.column_count; i++)
        if (strcmp(measures.columns[i], name) == 0)
            return measures.numbers[i];
    fail_msg("no column %s", name);
    return 0;
}

static void near(const char *name, double wanted, double slack)
{
    double got = column(name);
    if (!(fabs(got - wanted) <= slack))
        fail_msg("%s is %.17g, not %.17g", name, got, wanted);
}

static void done(void)
{
    measures_free(&measures);
    world_close(&w);
}

/* The state, to be changed by the test. */
static struct motion *motions(void)
{
    return (struct motion *)world_state(&w)->now[FIELD_MOTION];
}

static void sums_of_a_moving_block(void **state)
{
    (void)state;
    world_open(&w, SCENE(DOWN, MOVING, "0", "{\"quantity\": \"energy\"}, {\"quantity\": "
        "\"momentum\"}, {\"quantity\": \"mass-centre\"}, {\"quantity\": \"speed\"}, {\"quantity\": "
        "\"density-error\"}, {\"quantity\": \"angular-momentum\", \"at\": [0.1, 0, 2]}"));
    take(0);
    double mass = 64 * world_mass(&w, 0);
    near("time (s)", 0, 0);
    near("energy.kinetic (J)", mass / 2 * 14, 1e-9);
    near("energy.potential (J)", mass * 9.81 * 0.2, 1e-6);
    near("energy.total (J)", mass / 2 * 14 + mass * 9.81 * 0.2, 1e-6);
    near("momentum.x (kg m/s)", mass, 1e-9);
    near("momentum.y (kg m/s)", 2 * mass, 1e-9);
    near("momentum.z (kg m/s)", 3 * mass, 1e-9);
    near("mass-centre.x (m)", 0.4, 1e-9);
    near("mass-centre.y (m)", 0.2, 1e-9);
    near("mass-centre.z (m)", 0.4, 1e-9);
    near("speed (m/s)", sqrt(14), 1e-12);
    near("density-error.mean (1)", 0, 0);
    near("density-error.max (1)", 0, 0);
    near("density-error.compression (1)", 0, 0);
    /* r = (0.3, 0.2, -1.6) from the point to the middle; r x (1, 2, 3) */
    near("angular-momentum.x (kg m^2/s)", mass * (0.2 * 3 + 1.6 * 2), 1e-6);
    near("angular-momentum.y (kg m^2/s)", mass * (-1.6 * 1 - 0.3 * 3), 1e-6);
    near("angular-momentum.z (kg m^2/s)", mass * (0.3 * 2 - 0.2 * 1), 1e-6);
    done();
}

static void density_error_has_three_parts(void **state)
{
    (void)state;
    world_open(&w, SCENE(DOWN, MOVING, "0", "{\"quantity\": \"density-error\"}"));
    float *density = world_state(&w)->now[FIELD_DENSITY];
    for (size_t i = 0; i < 64; i++)
        density[i] = i < 16 ? 1020 : 990; /* +0.02 of a quarter, -0.01 of the rest */
    take(0);
    near("density-error.mean (1)", 0.02 / 4 - 0.01 * 3 / 4, 1e-12);
    near("density-error.max (1)", 0.02, 1e-12);
    near("density-error.compression (1)", 0.02 / 4, 1e-12);
    done();
}

static void shape_of_a_lattice(void **state)
{
    (void)state;
    world_open(&w, SCENE(DOWN, MOVING, "0", "{\"quantity\": \"volume\"},"
        "{\"quantity\": \"extent\"},"
        "{\"quantity\": \"front\"}, {\"quantity\": \"front\", \"name\": \"back\", \"axis\": \"z\","
        " \"side\": \"min\"}, {\"quantity\": \"height\", \"at\": [0.4, 0, 0.4]},"
        "{\"quantity\": \"height\", \"name\": \"H2\", \"at\": [0.33, 0.1, 0.42]},"
        "{\"quantity\": \"height\", \"name\": \"dry\", \"at\": [0.9, 0, 0.9]}"));
    take(0);
    near("volume.particles (m^3)", 64 * world_mass(&w, 0) / 1000, 1e-12);
    near("volume.surface (m^3)", 0.064, 1e-9);
    near("extent.x.min (m)", 0.25, 1e-9);
    near("extent.x.max (m)", 0.55, 1e-9);
    near("extent.y.low (m)", 0.05, 1e-9);
    near("extent.z.high (m)", 0.55, 1e-9);
    near("front.position (m)", 0.6, 1e-9);
    near("front.extreme (m)", 0.6, 1e-9);
    near("back.extreme (m)", 0.2, 1e-9);
    near("height (m)", 0.4, 1e-9);
    near("H2 (m)", 0.3, 1e-9);
    near("dry (m)", 0, 0);
    done();
}

/* Up is against gravity, whichever way that is; without gravity it is y. */
static void up_follows_gravity(void **state)
{
    static const char *const gravities[] = {"[9.81, 0, 0]", "[0, 0, 0]"};
    static const double heights[] = {0.8, 0.4}, volumes[] = {0.128, 0.064};
    (void)state;
    for (int k = 0; k < 2; k++) {
        world_open(&w, SCENE("%s", "[0, 0, 0]", "0", "{\"quantity\": \"volume\"}, {\"quantity\": "
            "\"height\", \"at\": %s}"), gravities[k], k ? "[0.4, 0, 0.4]" : "[1, 0.2, 0.4]");
        take(0);
        near("height (m)", heights[k], 1e-9);
        near("volume.surface (m^3)", volumes[k], 1e-9);
        done();
    }
}

/* A pressure that is linear in x: Shepard means are exact where the lattice is symmetric. */
static void probes_of_a_linear_pressure(void **state)
{
    (void)state;
    world_open(&w, SCENE(DOWN, MOVING, "0", "{\"quantity\": \"pressure\", \"at\": [0.4, 0.2, 0.4]},"
        "{\"quantity\": \"pressure\", \"name\": \"one\", \"at\": [0.45, 0.15, 0.25], \"radius\": "
        "0.09}, {\"quantity\": \"pressure\", \"name\": \"far\", \"at\": [0.9, 0.9, 0.9]},"
        "{\"quantity\": \"wall-pressure\", \"face\": \"-y\"}, {\"quantity\": \"wall-pressure\","
        "\"name\": \"patch\", \"face\": \"-y\", \"min\": [0.2, 0, 0], \"max\": [0.4, 0, 1]},"
        "{\"quantity\": \"wall-pressure\", \"name\": \"dry\", \"face\": \"+z\"},"
        "{\"quantity\": \"profile\", \"from\": [0.4, 0.2, 0.4], \"to\": [0.4, 1, 0.4],"
        "\"points\": 3}"));
    for (size_t i = 0; i < 64; i++)
        motions()[i].pressure = (float)(1000 + 2000 * world_metres(&w, i, 0));
    take(0);
    near("pressure (Pa)", 1800, 1e-3);
    near("one (Pa)", 1900, 1e-3);
    near("far (Pa)", 0, 0);
    near("wall-pressure (Pa)", 1800 + 1000 * 9.81 * 0.05, 1e-3);
    near("patch (Pa)", 1600 + 1000 * 9.81 * 0.05, 1e-3);
    near("dry (Pa)", 0, 0);
    near("profile.0.velocity.x (m/s)", 1, 1e-12);
    near("profile.0.velocity.y (m/s)", 2, 1e-12);
    near("profile.0.velocity.z (m/s)", 3, 1e-12);
    near("profile.0.pressure (Pa)", 1800, 1e-3);
    near("profile.1.velocity.y (m/s)", 2, 1e-12); /* at y = 0.6, within reach of the top */
    near("profile.2.velocity.y (m/s)", 0, 0);     /* at y = 1, out of it */
    near("profile.2.pressure (Pa)", 0, 0);
    done();
}

/* A lattice of 4 points an edge, 0.1 m apart: sqrt(5/4) spacings about its middle (0.4, 0.2, 0.4). */
static void spread_and_wave_of_a_lattice(void **state)
{
    (void)state;
    world_open(&w, SCENE(DOWN, MOVING, "0", "{\"quantity\": \"spread\"}, {\"quantity\": \"wave\","
        "\"wavelength\": 1, \"at\": [0.4, 0, 0]}, {\"quantity\": \"wave\", \"name\": \"up\","
        "\"axis\": \"y\", \"wavelength\": 0.8}"));
    take(0);
    near("spread.x (m)", 0.1 * sqrt(1.25), 1e-9);
    near("spread.y (m)", 0.1 * sqrt(1.25), 1e-9);
    near("spread.z (m)", 0.1 * sqrt(1.25), 1e-9);
    near("wave.cosine (1)", (cos(0.1 * M_PI) + cos(0.3 * M_PI)) / 2, 1e-9);
    near("wave.sine (1)", 0, 1e-9);
    near("up.cosine (1)", 0, 1e-9); /* half a wave: y/0.8 from 1/16 to 7/16 */
    near("up.sine (1)", (sin(M_PI / 8) + sin(3 * M_PI / 8)) / 2, 1e-9);
    done();
}

/* Five slabs of 0.2 m: the body fills the second and third along x, two rows of particles in each. */
static void layers_of_a_linear_pressure(void **state)
{
    (void)state;
    world_open(&w, SCENE(DOWN, MOVING, "0", "{\"quantity\": \"layers\", \"axis\": \"x\","
        "\"points\": 5}, {\"quantity\": \"layers\", \"name\": \"upright\"}"));
    for (size_t i = 0; i < 64; i++)
        motions()[i].pressure = (float)(1000 + 2000 * world_metres(&w, i, 0));
    take(0);
    near("layers.1.coordinate (m)", 0.3, 1e-9);
    near("layers.1.velocity.x (m/s)", 1, 1e-12);
    near("layers.1.velocity.y (m/s)", 2, 1e-12);
    near("layers.1.velocity.z (m/s)", 3, 1e-12);
    near("layers.1.pressure (Pa)", 1600, 1e-3);
    near("layers.2.coordinate (m)", 0.5, 1e-9);
    near("layers.2.pressure (Pa)", 2000, 1e-3);
    near("layers.4.coordinate (m)", 0.9, 1e-9);
    near("layers.4.velocity.x (m/s)", 0, 0);
    near("layers.4.pressure (Pa)", 0, 0);
    near("upright.0.coordinate (m)", 0.05, 1e-9);
    near("upright.3.pressure (Pa)", 1800, 1e-3);
    near("upright.9.coordinate (m)", 0.95, 1e-9);
    done();
}

/* A shear that starts as asked has no error; later than its decay, or faster, it has. */
static void flow_error_of_a_shear(void **state)
{
    (void)state;
    world_open(&w, SCENE(DOWN, "[0, 0, 0], \"flow\": \"shear\", \"flow_length\": 0.5", "0",
        "{\"quantity\": \"flow-error\", \"flow\": \"shear\", \"flow_length\": 0.5, \"decay\": 2},"
        "{\"quantity\": \"flow-error\", \"name\": \"double\", \"flow\": \"shear\"},"
        "{\"quantity\": \"flow-error\", \"name\": \"none\", \"flow\": \"none\"}"));
    take(0);
    near("flow-error.speed (1)", 0, 1e-6);
    near("flow-error.velocity (1)", 0, 1e-6);
    near("flow-error.part (1)", 1, 1e-6);
    near("double.speed (1)", 1, 1e-6); /* 2 y against y */
    near("double.velocity (1)", 1, 1e-6);
    near("double.part (1)", 2, 1e-6);
    near("none.part (1)", 0, 0);
    take(0.5);
    near("flow-error.part (1)", exp(1), 1e-5);
    near("flow-error.speed (1)", exp(1) - 1, 1e-5);
    done();
}

static int by_value(const void *a, const void *b)
{
    double l = *(const double *)a, r = *(const double *)b;
    return l < r ? -1 : l > r;
}

/* 99.5 % of 64 is 63.68: the 64th; the quantiles of 99.9 and 50 % are asked directly. */
static void quantiles_are_ranks(void **state)
{
    double x[64];
    (void)state;
    world_open(&w, SCENE(DOWN, MOVING, "0.3", "{\"quantity\": \"speed\"}"));
    take(0);
    struct measured m = {.space = &w.plan.space, .particles = world_state(&w), .count = 64};
    for (int a = 0; a < 3; a++) {
        for (size_t i = 0; i < 64; i++)
            x[i] = world_metres(&w, i, a);
        qsort(x, 64, sizeof *x, by_value);
        assert_true(measure_quantile(&m, a, 1, 1) == x[63]);
        assert_true(measure_quantile(&m, a, -1, 1) == x[0]);
        assert_true(measure_quantile(&m, a, 1, 0.999) == x[63]);
        assert_true(measure_quantile(&m, a, 1, 0.95) == x[60]); /* ceil(60.8) = 61st */
        assert_true(measure_quantile(&m, a, -1, 0.95) == x[3]);
        assert_true(measure_quantile(&m, a, 1, 0.5) == x[31]);
        assert_true(measure_quantile(&m, a, 1, 0) == x[0]);
    }
    m.count = 0;
    assert_true(isnan(measure_quantile(&m, 0, 1, 1)));
    done();
}

static void exchange(void *array, size_t size, size_t a, size_t b)
{
    char spare[256], *items = array;
    memcpy(spare, items + a * size, size);
    memcpy(items + a * size, items + b * size, size);
    memcpy(items + b * size, spare, size);
}

static void order_in_memory_does_not_matter(void **state)
{
    double first[256];
    (void)state;
    world_open(&w, SCENE(DOWN, MOVING, "0.3", "{\"quantity\": \"energy\"}, {\"quantity\": "
        "\"momentum\"}, {\"quantity\": \"mass-centre\"}, {\"quantity\": \"density-error\"},"
        "{\"quantity\": \"volume\"}, {\"quantity\": \"extent\"}, {\"quantity\": \"spread\"},"
        "{\"quantity\": \"wave\", \"wavelength\": 1}, {\"quantity\": \"layers\"},"
        "{\"quantity\": \"flow-error\", \"flow\": \"shear\"}, {\"quantity\": \"pressure\","
        "\"at\": [0.4, 0.2, 0.4]}, {\"quantity\": \"angular-momentum\"}, {\"quantity\": "
        "\"wall-pressure\", \"face\": \"-y\"}, {\"quantity\": \"profile\", \"from\": [0.3, 0, 0.3],"
        "\"to\": [0.3, 0.3, 0.3]}"));
    world_advance(&w, 0.05);
    take(0.05);
    assert_true(measures.column_count < 256);
    memcpy(first, measures.numbers, measures.column_count * sizeof *first);
    const struct particles *p = world_state(&w);
    for (size_t i = 0; i < 64; i++)
        for (int f = 0; f < FIELD_COUNT; f++)
            if (p->now[f])
                exchange(p->now[f], field_table[f].size, i, i * 37 % 64);
    take(0.05);
    assert_memory_equal(first, measures.numbers, measures.column_count * sizeof *first);
    done();
}

/* Without gravity and walls near, a block at rest density moves as one. */
static void a_block_moves_uniformly(void **state)
{
    (void)state;
    world_open(&w, SCENE_ABOVE("-1", "[0, 0, 0]", "[0.5, 0.25, -0.5]", "0", "{\"quantity\": "
        "\"mass-centre\"}, {\"quantity\": \"momentum\"}, {\"quantity\": \"energy\"}"));
    take(0);
    double momentum = column("momentum.x (kg m/s)"), energy = column("energy.total (J)");
    world_advance(&w, 0.1);
    take(0.1);
    near("time (s)", 0.1, 0);
    near("mass-centre.x (m)", 0.45, 1e-7);
    near("mass-centre.y (m)", 0.225, 1e-7);
    near("mass-centre.z (m)", 0.35, 1e-7);
    near("momentum.x (kg m/s)", momentum, 1e-6 * momentum);
    near("energy.total (J)", energy, 1e-5 * energy);
    done();
}

static void without_a_list_the_usual(void **state)
{
    (void)state;
    world_open(&w, SCENE(DOWN, MOVING, "0", ""));
    take(0);
    assert_int_equal(measures.count, 5);
    assert_int_equal(measures.column_count, 1 + 3 + 3 + 3 + 1 + 3);
    assert_string_equal(measures.columns[0], "time (s)");
    assert_string_equal(measures.columns[13], "density-error.compression (1)");
    done();
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sums_of_a_moving_block),
        cmocka_unit_test(density_error_has_three_parts),
        cmocka_unit_test(shape_of_a_lattice),
        cmocka_unit_test(up_follows_gravity),
        cmocka_unit_test(probes_of_a_linear_pressure),
        cmocka_unit_test(spread_and_wave_of_a_lattice),
        cmocka_unit_test(layers_of_a_linear_pressure),
        cmocka_unit_test(flow_error_of_a_shear),
        cmocka_unit_test(quantiles_are_ranks),
        cmocka_unit_test(order_in_memory_does_not_matter),
        cmocka_unit_test(a_block_moves_uniformly),
        cmocka_unit_test(without_a_list_the_usual),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
