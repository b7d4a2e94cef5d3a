/* Tests tanks of thin fluid that start under their own weight: right slope at once, and calm. */
#include "world.h"

static const double depth = 0.4, g = 9.81;

/* Water-thin oil, depth 0.4 m = 16 spacings, in a closed tank. */
static void open_tank(struct world *w, const char *walls, const char *start, const char *solver)
{
    world_open(w, "{\"gravity\": [0, -9.81, 0], \"particles\": {\"spacing\": 0.025},\n"
                  "\"domain\": {\"min\": [0, 0, 0], \"max\": [0.3, 0.6, 0.3], \"walls\": %s},\n"
                  "\"fluids\": [{\"density\": 900, \"viscosity\": 1e-3}],\n"
                  "\"bodies\": [{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.3, 0.4, 0.3], "
                  "\"start\": \"%s\"}],\n"
                  "\"solver\": {\"method\": \"wcsph\"%s}, \"time\": {\"end\": 9}}",
               walls, start, solver);
}

/* Least squares of p = a + b depth over particles at least a support from floor and surface. */
static double slope(struct world *w)
{
    const struct particles *p = world_state(w);
    double n = 0, sx = 0, sp = 0, sxx = 0, sxp = 0, support = w->plan.choice.support;
    for (size_t i = 0; i < p->count; i++) {
        double x = depth - world_metres(w, i, 1), y = (double)particles_motion(p)[i].pressure;
        if (x < support || x > depth - support)
            continue;
        n++;
        sx += x, sp += y, sxx += x * x, sxp += x * y;
    }
    return (n * sxp - sx * sp) / (n * sxx - sx * sx);
}

static double kinetic(struct world *w) /* of M g H */
{
    double sum = 0, mass = 0;
    for (size_t i = 0; i < world_state(w)->count; i++) {
        const float *v = particles_motion(world_state(w))[i].velocity;
        double m = world_mass(w, i);
        sum += 0.5 * m * ((double)v[0] * v[0] + (double)v[1] * v[1] + (double)v[2] * v[2]);
        mass += m;
    }
    return sum / (mass * g * depth);
}

struct calm {
    double first, least, most; /* error of the slope at once; range of it to 0.4 s */
    double speed;              /* the largest to 0.4 s, sqrt(g H) */
};

static struct calm calm(const char *walls, const char *start, const char *solver)
{
    struct world w;
    open_tank(&w, walls, start, solver);
    struct calm c = {.first = slope(&w) / (900 * g) - 1, .least = INFINITY, .most = -INFINITY};
    for (int k = 1; k <= 40; k++) {
        world_advance(&w, 0.01 * k);
        double s = slope(&w) / (900 * g) - 1;
        c.least = fmin(c.least, s), c.most = fmax(c.most, s);
        c.speed = fmax(c.speed, sqrt(w.simulation.extremes.speed2) / sqrt(g * depth));
    }
    print_message("# walls %s, start %s%s: slope %+.3f %% at once, %+.1f to %+.1f %% to 0.4 s; "
                  "largest speed %.1e sqrt(g H), in the end %.1e; kinetic energy %.1e M g H\n",
                  walls, start, solver, 100 * c.first, 100 * c.least, 100 * c.most, c.speed,
                  sqrt(w.simulation.extremes.speed2) / sqrt(g * depth), kinetic(&w));
    world_close(&w);
    return c;
}

#define CLOSED "\"closed\""
#define SIDES "{\"-x\": \"periodic\", \"+x\": \"periodic\", \"-z\": \"periodic\", \"+z\": \"periodic\"}"

static void column(void **state)
{
    (void)state;
    struct calm c = calm(SIDES, "auto", "");
    assert_true(fabs(c.first) < 1e-3);
    assert_true(c.least > -0.05 && c.most < 0.12 && c.speed < 0.03);
    c = calm(SIDES, "auto", ", \"eos\": \"linear\"");
    assert_true(fabs(c.first) < 1e-3);
    assert_true(c.least > -0.05 && c.most < 0.12 && c.speed < 0.03);
}
/* Along closed sides the fluid sinks: the half spaces do not continue its pressure downwards. */
static void closed_tank(void **state)
{
    (void)state;
    struct calm c = calm(CLOSED, "auto", "");
    assert_true(fabs(c.first) < 1e-3);
    assert_true(c.least > -0.2 && c.most < 0.3);
}
/* What it is compared with. */
static void from_rest(void **state)
{
    (void)state;
    struct calm c = calm(SIDES, "rest", "");
    assert_true(c.least < -0.5 && c.most > 0.5);
    c = calm(CLOSED, "rest", "");
    assert_true(c.least < -0.5 && c.most > 0.5);
}

int main(void)
{
    log_set_level(LOG_ERROR);
    const struct CMUnitTest tests[] = {cmocka_unit_test(column), cmocka_unit_test(closed_tank),
                                       cmocka_unit_test(from_rest)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
