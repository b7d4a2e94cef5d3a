/* Tests a settled tank: pressure rises by rho g with depth, the volume is right, it is calm. */
#include "world.h"

/* Syrup from a jittered lattice without pressure, in a closed tank, depth 0.4 m = 16 spacings: as
 * thick as that, the sound of its first fall (period 4 H/c0 = 0.08 s) dies out in 0.4 s. */
static void settle(struct world *w, const char *walls, const char *solver)
{
    world_open(w, "{\"gravity\": [0, -9.81, 0], \"particles\": {\"spacing\": 0.025},\n"
                  "\"domain\": {\"min\": [0, 0, 0], \"max\": [0.3, 0.6, 0.3], \"walls\": %s},\n"
                  "\"fluids\": [{\"density\": 900, \"viscosity\": 200}],\n"
                  "\"bodies\": [{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.3, 0.4, 0.3], "
                  "\"jitter\": 0.05, \"start\": \"rest\"}],\n"
                  "\"solver\": {%s}, \"time\": {\"end\": 9}}", walls, solver);
    world_advance(w, 0.4);
}

/* Least squares of p = a + b depth over particles at least a support from floor and surface. */
static double slope(struct world *w)
{
    const struct particles *p = world_state(w);
    double n = 0, sx = 0, sp = 0, sxx = 0, sxp = 0, support = w->plan.choice.support;
    for (size_t i = 0; i < p->count; i++) {
        double depth = 0.4 - world_metres(w, i, 1), pressure = (double)particles_motion(p)[i].pressure;
        if (depth < support || depth > 0.4 - support)
            continue;
        n++;
        sx += depth, sp += pressure, sxx += depth * depth, sxp += depth * pressure;
    }
    return (n * sxp - sx * sp) / (n * sxx - sx * sx);
}

/* Height of a column of the same mean: twice the mean height of particles, m. */
static double height(struct world *w)
{
    double sum = 0, n = (double)world_state(w)->count;
    for (size_t i = 0; i < world_state(w)->count; i++)
        sum += world_metres(w, i, 1);
    return 2 * sum / n;
}

static void check(const char *walls, const char *solver, double slope_most, double height_most)
{
    struct world w;
    settle(&w, walls, solver);
    double sum = 0;
    int samples = 8; /* over a period of the sound */
    for (int k = 1; k <= samples; k++) {
        world_advance(&w, 0.4 + 0.01 * k);
        sum += slope(&w) / samples;
    }
    double error = sum / (900 * 9.81) - 1, rise = height(&w) / 0.4 - 1;
    double speed = sqrt(w.simulation.extremes.speed2) / sqrt(9.81 * 0.4);
    print_message("# walls %s, {%s}: slope %+.2f %%, height %+.2f %%, largest speed %.1e sqrt(g H)\n",
                  walls, solver, 100 * error, 100 * rise, speed);
    assert_true(fabs(error) < slope_most);
    assert_true(fabs(rise) < height_most);
    assert_true(speed < 0.01);
    world_close(&w);
}

#define C0 "\"method\": \"wcsph\", \"sound_speed\": 20"

static void continuity(void **state)
{
    (void)state;
    check("\"closed\"", C0, 0.06, 0.02);
}
static void summation(void **state)
{
    (void)state;
    check("\"closed\"", C0 ", \"density\": \"summation\"", 0.06, 0.02);
}
static void wall_particles(void **state)
{
    (void)state;
    check("\"particles\"", C0, 0.06, 0.02);
}
static void muller(void **state)
{
    (void)state;
    check("\"closed\"", "\"method\": \"muller\", \"stiffness\": 400", 0.12, 0.02);
}

int main(void)
{
    log_set_level(LOG_ERROR);
    const struct CMUnitTest tests[] = {cmocka_unit_test(continuity), cmocka_unit_test(summation),
                                       cmocka_unit_test(wall_particles), cmocka_unit_test(muller)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
