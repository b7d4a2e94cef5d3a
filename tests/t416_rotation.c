/* Tests viscosity along the line of centres: start-up flows against their series, bodies that turn freely,
 * and very thick ones that land. */
#include "start_up.h"

#define SOLVER(method, more) "\"" method "\", \"viscosity_form\": \"weiler\"" more
#define IMPLICIT ", \"viscosity\": \"implicit\""

/* The lattice resists shear along its axes by 0.5 % too much (isph), 5 % too little (dfsph). */
static void start_up_flows(void **state)
{
    (void)state;
    const struct flow f = {1, 0.1, 1.5, false}, c = {1, 0.1, 1.5, true};
    assert_true(start_up(&f, 10, SOLVER("isph", IMPLICIT), 1) < 0.04);
    assert_true(start_up(&c, 10, SOLVER("isph", IMPLICIT), 1) < 0.02);
    assert_true(start_up(&f, 10, SOLVER("dfsph", IMPLICIT), 1) < 0.12);
    assert_true(start_up(&c, 10, SOLVER("dfsph", IMPLICIT), 1) < 0.04);
}

/* From water to 10 m^2/s in long steps, where backward Euler errs more. With Morris's operator isph errs
 * by as much, dfsph up to seven times less. */
static void stiff_flows(void **state)
{
    (void)state;
    const struct flow water = {1e-3, 1e-6, 1.25e-5, false}, thick = {1, 10, 1.5, false};
    const struct flow wall = {1, 10, 1.5, true};
    assert_true(start_up(&water, 10, SOLVER("isph", IMPLICIT), 10) < 0.1);
    assert_true(start_up(&thick, 10, SOLVER("isph", IMPLICIT), 10) < 0.1);
    assert_true(start_up(&wall, 10, SOLVER("isph", IMPLICIT), 10) < 0.03);
    assert_true(start_up(&water, 10, SOLVER("dfsph", IMPLICIT), 10) < 0.12);
    assert_true(start_up(&thick, 10, SOLVER("dfsph", IMPLICIT), 10) < 0.14);
}

/* Sum of m x cross v, z component, kg m^2/s. */
static double angular_momentum(struct world *w)
{
    double sum = 0;
    for (size_t i = 0; i < world_state(w)->count; i++) {
        const float *v = particles_motion(world_state(w))[i].velocity;
        sum += world_mass(w, i) * (world_metres(w, i, 0) * (double)v[1] -
                                   world_metres(w, i, 1) * (double)v[0]);
    }
    return sum;
}

#define TURNING "\"flow\": \"rotation\", \"flow_speed\": 0.3, \"flow_length\": 0.15"

/* Part of its angular momentum that fluid of 100 Pa s, turning at 2 rad/s without forces, gains in
 * `turns`. */
static double turned(const char *solver, const char *fluids, const char *bodies, double turns)
{
    struct world w;
    world_open(&w, "{\"gravity\": [0, 0, 0], \"domain\": {\"min\": [-1, -1, -1], \"max\": [1, 1, 1]},\n"
               "\"particles\": {\"spacing\": 0.025}, \"time\": {\"end\": 9}, \"fluids\": [%s],\n"
               "\"bodies\": [%s], \"solver\": {\"method\": %s}}", fluids, bodies, solver);
    double first = angular_momentum(&w);
    world_advance(&w, turns * PI);
    double gain = angular_momentum(&w) / first - 1;
    const struct solve_stats *solve = &w.simulation.stats.solves[SOLVE_VISCOSITY];
    print_message("# {%s}, %.2g turns: angular momentum %+.2g; %ld steps, %.1f iterations each\n", solver,
                  turns, gain, w.simulation.stats.steps,
                  (double)solve->sweeps / (double)w.simulation.stats.steps);
    assert_int_equal(solve->unsolved, 0);
    world_close(&w);
    return gain;
}

/* Pressure of dfsph acts along the line of centres, too; that of isph by differences, which do not keep
 * angular momentum. */
static void turns_freely(void **state)
{
    (void)state;
    const char *one = "{\"density\": 1000, \"viscosity\": 100}";
    const char *two = "{\"name\": \"a\", \"density\": 1000, \"viscosity\": 100}, "
                      "{\"name\": \"b\", \"density\": 1000, \"viscosity\": 1e4}";
    const char *ball = "{\"shape\": \"sphere\", \"center\": [0, 0, 0], \"radius\": 0.15, " TURNING "}";
    const char *halves = "{\"shape\": \"box\", \"min\": [-0.1, -0.1, -0.1], \"max\": [0, 0.1, 0.1], "
                         "\"fluid\": \"a\", \"flow_center\": [0, 0, 0], " TURNING "}, "
                         "{\"shape\": \"box\", \"min\": [0, -0.1, -0.1], \"max\": [0.1, 0.1, 0.1], "
                         "\"fluid\": \"b\", \"flow_center\": [0, 0, 0], " TURNING "}";
    assert_float_equal(turned("\"dfsph\", \"viscosity\": \"implicit\"", one, ball, 1), 0, 1e-5);
    assert_float_equal(turned("\"dfsph\", \"viscosity\": \"implicit\"", two, halves, 0.2), 0, 1e-5);
    assert_float_equal(turned("\"isph\", \"viscosity\": \"implicit\"", one, ball, 1), 0, 0.02);
    assert_true(turned("\"dfsph\", \"viscosity\": \"implicit\", \"viscosity_form\": \"morris\"", one,
                       ball, 0.16) < -0.99);
}

/* A block of 1e6 Pa s that turns lands, inside of the tank, and comes to rest. */
static void lands(const char *method)
{
    struct world w;
    double speed2 = 0;
    world_open(&w, "{\"gravity\": [0, -9.81, 0], \"particles\": {\"spacing\": 0.025}, "
               "\"time\": {\"end\": 9}, \"domain\": {\"min\": [-0.3, 0, -0.3], \"max\": [0.3, 0.6, 0.3], "
               "\"no_slip\": true}, \"solver\": {\"method\": \"%s\"}, \"fluids\": [{\"density\": 1400, "
               "\"viscosity\": 1e6}], \"bodies\": [{\"shape\": \"box\", \"min\": [-0.1, 0.15, -0.1], "
               "\"max\": [0.1, 0.35, 0.1], \"flow_center\": [0, 0.25, 0], " TURNING "}]}", method);
    assert_true(w.plan.choice.implicit_viscosity && w.plan.choice.flags & PAIR_CENTRAL);
    world_advance(&w, 0.5);
    for (size_t i = 0; i < world_state(&w)->count; i++)
        for (int a = 0; a < 3; a++) {
            double v = (double)particles_motion(world_state(&w))[i].velocity[a];
            double x = world_metres(&w, i, a);
            speed2 = fmax(speed2, v * v);
            assert_true(isfinite(v) && x >= (a == 1 ? -1e-9 : -0.3) && x <= (a == 1 ? 0.6 : 0.3));
        }
    const struct solve_stats *solve = &w.simulation.stats.solves[SOLVE_VISCOSITY];
    print_message("# %s: landed; at most %.2g m/s along an axis after %ld steps of at most %d iterations, "
                  "%ld unsolved\n", method, sqrt(speed2), w.simulation.stats.steps, solve->most,
                  solve->unsolved);
    assert_true(sqrt(speed2) < 0.2 && solve->unsolved == 0);
    world_close(&w);
}

static void stops(void **state)
{
    (void)state;
    lands("isph");
    lands("dfsph");
}

int main(void)
{
    log_set_level(LOG_ERROR);
    const struct CMUnitTest tests[] = {cmocka_unit_test(start_up_flows), cmocka_unit_test(stiff_flows),
                                       cmocka_unit_test(turns_freely), cmocka_unit_test(stops)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
