/* Tests that a uniform velocity changes nothing, and that a value that is not finite ends the run. */
#include "world.h"

#define BOX "{\"particles\": {\"spacing\": 0.05}, \"time\": {\"end\": 1, \"step\": 2e-4}, " \
            "\"gravity\": [0, 0, 0], \"fluids\": [{\"density\": 1000, \"viscosity\": 1}],\n" \
            "\"domain\": {\"min\": [0, 0, 0], \"max\": [0.8, 0.8, 0.8], \"walls\": \"periodic\"},\n" \
            "\"solver\": {%s}, \"bodies\": [\n" \
            "{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.4, 0.8, 0.8], \"jitter\": 0.1, " \
            "\"velocity\": [%g, %g, %g]},\n" \
            "{\"shape\": \"box\", \"min\": [0.4, 0, 0], \"max\": [0.8, 0.8, 0.8], \"jitter\": 0.1, " \
            "\"velocity\": [%g, %g, %g]}]}"

/* Opens two halves of a periodic box that shear along y, the whole moving with (u, v, w). */
static void open_moving(struct world *world, const char *solver, double u, double v, double w)
{
    world_open(world, BOX, solver, u, v + 0.5, w, u, v - 0.5, w);
}

/* Speed differences, m/s, between the state seen by a moving observer and one at rest: the largest,
 * and the largest of the motion itself. */
static double difference(struct world *rest, struct world *moving, const double boost[3],
                         double *motion)
{
    size_t count = world_state(rest)->count;
    float (*velocity)[3] = calloc(count, sizeof *velocity);
    double worst = 0;
    *motion = 0;
    for (size_t i = 0; i < count; i++)
        memcpy(velocity[particles_id(world_state(rest))[i]],
               particles_motion(world_state(rest))[i].velocity, sizeof *velocity);
    for (size_t i = 0; i < count; i++)
        for (int a = 0; a < 3; a++) {
            double at_rest = velocity[particles_id(world_state(moving))[i]][a];
            double seen = (double)particles_motion(world_state(moving))[i].velocity[a] - boost[a];
            worst = fmax(worst, fabs(seen - at_rest));
            *motion = fmax(*motion, fabs(at_rest));
        }
    free(velocity);
    return worst;
}

static void moves_alike(const char *solver)
{
    static const double boost[3] = {2, -1, 0.5}; /* m/s; exact in a float, as are their sums */
    struct world rest, moving;
    double motion;
    open_moving(&rest, solver, 0, 0, 0);
    open_moving(&moving, solver, boost[0], boost[1], boost[2]);
    world_advance(&rest, 0.05);
    world_advance(&moving, 0.05);
    double worst = difference(&rest, &moving, boost, &motion);
    print_message("# {%s}: a moving observer sees speeds that differ by %.1e of %.2f m/s after "
                  "%ld steps\n", solver, worst, motion, rest.simulation.stats.steps);
    assert_int_equal(rest.simulation.stats.steps, moving.simulation.stats.steps);
    assert_true(motion > 0.3 && worst < 1e-4 * motion);
    world_close(&rest);
    world_close(&moving);
}

static void uniform_velocity_changes_nothing(void **state)
{
    (void)state;
    moves_alike("\"method\": \"wcsph\", \"sound_speed\": 40");
    moves_alike("\"method\": \"wcsph\", \"sound_speed\": 40, \"density\": \"summation\"");
    moves_alike("\"method\": \"muller\", \"stiffness\": 100");
    moves_alike("\"method\": \"isph\"");
}

/* Puts `value` in one particle's state; the next step must stop and leave no later time. */
static void stops_on(const char *solver, float value, bool density)
{
    struct world w;
    open_moving(&w, solver, 0, 0, 0);
    world_advance(&w, 0.002);
    const struct particles *p = world_state(&w);
    uint32_t id = particles_id(p)[17];
    char name[40];
    if (density)
        particles_density(p)[17] = value;
    else
        particles_motion(p)[17].velocity[1] = value;
    assert_int_equal(simulation_advance(&w.simulation, 0.01, &w.error), STATUS_RUN);
    assert_true(w.simulation.time == 0.002);
    snprintf(name, sizeof name, "particle %u at (", id);
    assert_non_null(strstr(w.error.text, "stopped at t = 0.002 s"));
    if (!density) { /* else its neighbours, whose forces it spoils, are named */
        assert_non_null(strstr(w.error.text, "not finite"));
        assert_non_null(strstr(w.error.text, name));
    }
    world_close(&w);
}

static void not_finite_ends_the_run(void **state)
{
    (void)state;
    stops_on("\"method\": \"wcsph\", \"sound_speed\": 40", NAN, false);
    stops_on("\"method\": \"wcsph\", \"sound_speed\": 40", INFINITY, false);
    stops_on("\"method\": \"muller\", \"stiffness\": 100", NAN, false);
    stops_on("\"method\": \"isph\"", NAN, false);
    stops_on("\"method\": \"isph\"", INFINITY, false);
    stops_on("\"method\": \"wcsph\", \"sound_speed\": 40, \"density\": \"summation\"", NAN, false);
    stops_on("\"method\": \"wcsph\", \"sound_speed\": 40", NAN, true);
}

int main(void)
{
    log_set_level(LOG_ERROR);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(uniform_velocity_changes_nothing),
        cmocka_unit_test(not_finite_ends_the_run),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
