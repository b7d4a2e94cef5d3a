/* Tests fluid at obstacles: nothing gets in, however hard it strikes, and a tank at rest stays at rest. */
#include "scene/solid.h"
#include "world.h"

#include "random.h"

/* How far the deepest particle is inside an obstacle, m. */
static double deepest(struct world *w)
{
    double least = 0;
    for (size_t k = 0; k < w->scene->obstacle_count; k++) {
        const struct solid solid = solid_make(w->scene, &w->scene->obstacles[k]);
        for (size_t i = 0; i < world_state(w)->count; i++) {
            double p[3];
            for (int a = 0; a < 3; a++)
                p[a] = world_metres(w, i, a);
            least = fmin(least, solid_distance(&solid, p));
        }
    }
    return -least;
}

/* Two blocks that make an L, a ball and a post, under a drop that falls at 12 m/s along a diagonal. */
static const char crowd[] =
    "{\"particles\": {\"spacing\": 0.03}, \"fluids\": [{}], \"time\": {\"end\": 1},\n"
    "\"domain\": {\"min\": [-0.2, 0, 0], \"max\": [0.7, 0.8, 0.6], \"restitution\": %g, \"walls\": %s},\n"
    "\"obstacles\": [{\"shape\": \"box\", \"min\": [0.1, 0, 0.1], \"max\": [0.5, 0.12, 0.3]},\n"
    "{\"shape\": \"box\", \"min\": [0.1, 0.12, 0.1], \"max\": [0.22, 0.3, 0.3]},\n"
    "{\"shape\": \"sphere\", \"center\": [0.42, 0.2, 0.2], \"radius\": 0.1},\n"
    "{\"shape\": \"cylinder\", \"center\": [0.4, 0.1, 0.45], \"radius\": 0.06, \"height\": 0.5, \"axis\": \"x\"}],\n"
    "\"bodies\": [{\"shape\": \"sphere\", \"center\": [0.3, 0.55, 0.3], \"radius\": 0.15,\n"
    "\"velocity\": [1, -12, -1]}],\n"
    "\"solver\": {\"method\": \"%s\"}}";

static void strike(const char *method, double restitution, const char *walls)
{
    struct world w;
    world_open(&w, crowd, restitution, walls, method);
    double worst = 0;
    for (int k = 1; k <= 40; k++) {
        world_advance(&w, 0.005 * k);
        worst = fmax(worst, deepest(&w));
    }
    print_message("# %s, restitution %g: %zu particles, %ld steps, deepest %.1e m\n", method, restitution,
                  world_state(&w)->count, w.simulation.stats.steps, worst);
    assert_true(worst <= 1e-9); /* a count or so */
    world_close(&w);
}

static void nothing_gets_in(void **state)
{
    static const char *const methods[] = {"isph", "wcsph", "dfsph", "muller"};
    (void)state;
    for (size_t k = 0; k < sizeof methods / sizeof *methods; k++) {
        strike(methods[k], 0, "\"closed\"");
        strike(methods[k], 0.5, "{\"-x\": \"periodic\", \"+x\": \"periodic\"}");
    }
}

/* The stop itself, from places all over the domain: out, at the nearest surface, and not faster. */
static void stops(void **state)
{
    (void)state;
    struct world w;
    uint64_t seed = 5;
    world_open(&w, crowd, 0.25, "{\"-x\": \"periodic\", \"+x\": \"periodic\"}", "wcsph");
    const struct obstacles *all = &w.plan.choice.each.obstacles;
    size_t moved = 0, kept = 0;
    assert_int_equal(all->count, 4);
    for (int n = 0; n < 200000; n++) {
        uint32_t before[3], count[3];
        float v[3], speed2[2] = {0};
        double p[3], inside = 0;
        for (int a = 0; a < 3; a++) {
            p[a] = random_between(&seed, w.scene->domain.min[a], w.scene->domain.max[a]);
            count[a] = before[a] = space_count(&w.plan.space, a, p[a]);
            v[a] = (float)random_between(&seed, -1, 1);
            speed2[0] += v[a] * v[a];
        }
        for (size_t k = 0; k < w.scene->obstacle_count; k++) {
            const struct solid solid = solid_make(w.scene, &w.scene->obstacles[k]);
            inside = fmin(inside, solid_distance(&solid, p));
        }
        obstacles_stop(all, before, count, v);
        bool same = memcmp(before, count, sizeof count) == 0;
        for (int a = 0; a < 3; a++) {
            p[a] = space_metres(&w.plan.space, a, count[a]);
            speed2[1] += v[a] * v[a];
        }
        kept += same;
        assert_true(speed2[1] <= speed2[0] * 1.00001f);
        if (inside >= 0) {
            assert_true(same && speed2[0] == speed2[1]);
            continue;
        }
        if (same) { /* nowhere to go: the two blocks meet there */
            assert_true(speed2[1] == 0);
            continue;
        }
        moved++;
        for (size_t k = 0; k < w.scene->obstacle_count; k++) {
            const struct solid solid = solid_make(w.scene, &w.scene->obstacles[k]);
            assert_true(solid_distance(&solid, p) > -1e-9);
        }
    }
    print_message("# %zu moved out of 200000, %zu not\n", moved, kept);
    assert_true(moved > 5000);
    world_close(&w);
}

struct rest {
    double pressure; /* root mean square error, of rho g H */
    double speed;    /* root mean square, of sqrt(g H) */
};

#define TANK_DEPTH 0.4

/* Water 0.4 m deep that starts at rest round an obstacle, after `time`. Fluid within two spacings of the
 * surface is left out. */
static struct rest tank(const char *solver, double viscosity, const char *obstacles, double time)
{
    struct world w;
    struct rest rest = {0};
    size_t n = 0;
    world_open(&w,
               "{\"particles\": {\"spacing\": 0.025}, \"fluids\": [{\"viscosity\": %g}], \"time\": {\"end\": 9},\n"
               "\"domain\": {\"min\": [0, 0, 0], \"max\": [0.5, 0.6, 0.4]}, \"obstacles\": [%s],\n"
               "\"bodies\": [{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.5, 0.4, 0.4]}],\n"
               "\"solver\": {%s}}", viscosity, obstacles, solver);
    world_advance(&w, time);
    const struct particles *p = world_state(&w);
    for (size_t i = 0; i < p->count; i++) {
        double depth = TANK_DEPTH - world_metres(&w, i, 1);
        const struct motion *m = &particles_motion(p)[i];
        for (int a = 0; a < 3; a++)
            rest.speed += (double)m->velocity[a] * (double)m->velocity[a];
        if (depth < 0.05)
            continue;
        double error = (double)m->pressure / (1000 * 9.81 * TANK_DEPTH) - depth / TANK_DEPTH;
        rest.pressure += error * error;
        n++;
    }
    rest.pressure = sqrt(rest.pressure / (double)n);
    rest.speed = sqrt(rest.speed / (double)p->count / (9.81 * TANK_DEPTH));
    world_close(&w);
    return rest;
}

/* The exact solution is rho g times the depth, with or without an obstacle; what is wrong near one is no more
 * than what is wrong without. */
static void check_rest(const char *solver, double viscosity, double time, double pressure, double speed)
{
    static const struct { const char *name, *obstacles; } tanks[] = {
        {"no obstacle", ""},
        {"block on the floor", "{\"shape\": \"box\", \"min\": [0.15, 0, 0.1], \"max\": [0.35, 0.2, 0.3]}"},
        {"block in the water", "{\"shape\": \"box\", \"min\": [0.15, 0.1, 0.1], \"max\": [0.35, 0.2, 0.3]}"},
        {"ball in the water", "{\"shape\": \"sphere\", \"center\": [0.25, 0.2, 0.2], \"radius\": 0.1}"},
        {"post through the surface", "{\"shape\": \"cylinder\", \"center\": [0.25, 0.3, 0.2], \"radius\": 0.08, "
                                     "\"height\": 0.6}"}};
    for (size_t k = 0; k < sizeof tanks / sizeof *tanks; k++) {
        struct rest rest = tank(solver, viscosity, tanks[k].obstacles, time);
        print_message("# {%s}, %s: pressure %.2f %% of rho g H, speed %.1e sqrt(g H)\n", solver, tanks[k].name,
                      100 * rest.pressure, rest.speed);
        assert_true(rest.pressure < pressure);
        assert_true(rest.speed < speed);
    }
}

static void isph_rests(void **state)
{
    (void)state;
    check_rest("\"method\": \"isph\"", 1e-3, 0.6, 0.01, 0.02);
}
static void wcsph_rests(void **state)
{
    (void)state;
    check_rest("\"method\": \"wcsph\", \"sound_speed\": 20", 20, 0.4, 0.03, 0.02);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(stops), cmocka_unit_test(nothing_gets_in),
                                       cmocka_unit_test(isph_rests), cmocka_unit_test(wcsph_rests)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
