/* Tests implicit viscosity: against the series of start-up flows, against the explicit pass, and that it
 * takes kinetic energy, whatever its size. Its two operators: t416. */
#include "base/exact_sum.h"
#include "start_up.h"

/* Sums have the same bits in any order, and are exact where doubles are not. */
static void sums(void **state)
{
    (void)state;
    enum { TERMS = 1000 };
    double term[TERMS];
    uint64_t seed = 7;
    for (int i = 0; i < TERMS; i++) {
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        term[i] = ldexp((double)(int64_t)seed, (int)(seed >> 33) % 90 - 120);
    }
    struct exact_sum up = {0}, down = {0}, halves[2] = {0}, small = {0}, bad = {0};
    for (int i = 0; i < TERMS; i++) {
        exact_add(&up, term[i]);
        exact_add(&down, term[TERMS - 1 - i]);
        exact_add(&halves[i * 7 % 2], term[i * 7 % TERMS]);
    }
    exact_merge(&halves[0], &halves[1]);
    assert_memory_equal(&up.part, &down.part, sizeof up.part);
    assert_memory_equal(&up.part, &halves[0].part, sizeof up.part);
    exact_add(&small, 0x1p100);
    exact_add(&small, 1e-30);
    exact_add(&small, -0x1p100);
    assert_float_equal(exact_value(&small) * 1e30, 1, 1e-12);
    exact_add(&bad, INFINITY);
    assert_true(isnan(exact_value(&bad)));
}

#define EXPLICIT "\"dfsph\", \"viscosity\": \"explicit\""
#define IMPLICIT "\"dfsph\", \"viscosity\": \"implicit\""
#define AUTO "\"dfsph\""

static void gentle(void **state)
{
    (void)state;
    const struct flow f = {1, 0.1, 1.5, false}, c = {1, 0.1, 1.5, true};
    assert_true(start_up(&f, 10, EXPLICIT, 1) < 0.04);
    assert_true(start_up(&f, 10, IMPLICIT, 1) < 0.04);
    assert_true(start_up(&c, 10, EXPLICIT, 1) < 0.04);
    assert_true(start_up(&c, 10, IMPLICIT, 1) < 0.04);
    assert_true(start_up(&f, 20, EXPLICIT, 1) < 0.03);
    assert_true(start_up(&f, 20, IMPLICIT, 1) < 0.03);
}

/* Steps that are as long as the flow allows: backward Euler is of first order in time. */
static void stiff(void **state)
{
    (void)state;
    const struct flow water = {1e-3, 1e-6, 1.25e-5, false}, thick = {1, 200, 1.5, false};
    const struct flow wall = {1, 100, 1.5, true};
    assert_true(start_up(&water, 10, AUTO, 10) < 0.05);
    assert_true(start_up(&water, 20, AUTO, 10) < 0.05);
    assert_true(start_up(&water, 10, AUTO, 1000) < 0.2);
    assert_true(start_up(&thick, 10, AUTO, 100) < 0.2);
    assert_true(start_up(&thick, 20, AUTO, 100) < 0.1);
    assert_true(start_up(&wall, 10, AUTO, 100) < 0.2);
}

/* The particles' velocities in order of id; their count. */
static size_t velocities(struct world *w, float (*out)[3], size_t room)
{
    const struct particles *p = world_state(w);
    assert_in_range(p->count, 1, room);
    for (size_t i = 0; i < p->count; i++)
        memcpy(out[particles_id(p)[i]], particles_motion(p)[i].velocity, sizeof *out);
    return p->count;
}

/* sqrt(sum |a - b|^2 / sum |a|^2) of explicit and implicit viscosity, in small steps. */
static double difference(const char *name, const char *form, const char *domain, const char *fluids,
                         const char *bodies, double dt, double end)
{
    static float v[2][4000][3];
    size_t count = 0;
    double sum = 0, all = 0;
    for (int k = 0; k < 2; k++) {
        struct world w;
        world_open(&w, "{\"gravity\": [1.2, 0, 0], \"particles\": {\"spacing\": 0.1},\n"
                       "\"time\": {\"end\": 9, \"step\": %g}, \"domain\": {%s},\n"
                       "\"fluids\": [%s], \"bodies\": [%s],\n\"solver\": {\"method\": \"dfsph\", "
                       "\"viscosity_form\": \"%s\", \"viscosity_error\": 1e-5, \"viscosity\": \"%s\"}}",
                   dt, domain, fluids, bodies, form, k ? "implicit" : "explicit");
        assert_int_equal((w.plan.choice.flags & PAIR_CENTRAL) != 0, strcmp(form, "weiler") == 0);
        assert_int_equal(w.plan.choice.implicit_viscosity, k);
        world_advance(&w, end);
        count = velocities(&w, v[k], 4000);
        world_close(&w);
    }
    for (size_t i = 0; i < count; i++)
        for (int a = 0; a < 3; a++) {
            double e = (double)v[1][i][a] - (double)v[0][i][a];
            sum += e * e, all += (double)v[0][i][a] * (double)v[0][i][a];
        }
    print_message("# %s, %s, steps of %g s to %g s: implicit - explicit %.2g of |v|\n", name, form,
                  dt, end, sqrt(sum / all));
    return sqrt(sum / all);
}

static void same_operator(const char *form)
{
    const char *box = "{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.7, 1, 0.7]}";
    const char *off = "{\"shape\": \"box\", \"min\": [0, 0.05, 0], \"max\": [0.7, 0.95, 0.7]}";
    const char *two = "{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.7, 0.5, 0.7]},"
                      "{\"shape\": \"box\", \"min\": [0, 0.5, 0], \"max\": [0.7, 0.9, 0.7], "
                      "\"fluid\": \"b\", \"velocity\": [1, 0, 0]}";
    const char *periodic = "\"-x\": \"periodic\", \"+x\": \"periodic\", \"-z\": \"periodic\", "
                           "\"+z\": \"periodic\"";
    char domain[3][400];
    static const char *const more[3] = {"\"wall_velocity\": {\"+y\": [2, 0, 0.5]}, ", "", ""};
    static const char *const walls[3] = {"", ", \"-y\": \"particles\", \"+y\": \"particles\"",
                                         ", \"+y\": \"particles\""};
    for (int k = 0; k < 3; k++)
        snprintf(domain[k], sizeof domain[k], "\"min\": [0, 0, 0], \"max\": [0.7, 1, 0.7], %s"
                 "\"walls\": {%s%s}", more[k], periodic, walls[k]);
    const char *one = "{\"density\": 1000, \"viscosity\": 200}";
    assert_true(difference("moving plane", form, domain[0], one, box, 2e-4, 0.1) < 1e-3);
    assert_true(difference("wall particles", form, domain[1], one, off, 2e-4, 0.1) < 1e-3);
    /* Not for long: pressure amplifies any difference where the fluids' layers meet. */
    assert_true(difference("two fluids", form, domain[2],
                           "{\"name\": \"a\", \"density\": 1000, \"viscosity\": 200}, "
                           "{\"name\": \"b\", \"density\": 500, \"viscosity\": 5}", two, 2e-5, 1e-4) < 1e-4);
}

static void same_laplacian(void **state)
{
    (void)state;
    same_operator("morris");
}

static void same_along_centres(void **state)
{
    (void)state;
    same_operator("weiler");
}

/* Mean energies per kg, and that the state is finite. */
static void energies(struct world *w, double *kinetic, double *potential)
{
    size_t count = world_state(w)->count;
    *kinetic = *potential = 0;
    for (size_t i = 0; i < world_state(w)->count; i++) {
        const float *v = particles_motion(world_state(w))[i].velocity;
        double v2 = 0;
        for (int a = 0; a < 3; a++)
            v2 += (double)v[a] * (double)v[a];
        assert_true(isfinite(v2));
        *kinetic += 0.5 * v2 / (double)count;
        *potential += 9.81 * world_metres(w, i, 1) / (double)count;
    }
}

#define HONEY(gravity, more, viscosity)                                                            \
    "{\"gravity\": [0, %g, 0], \"particles\": {\"spacing\": 0.02}, \"time\": {\"end\": 9},\n"      \
    "\"domain\": {\"min\": [-0.4, 0, -0.4], \"max\": [0.8, 0.8, 0.8]},\n"                          \
    "\"fluids\": [{\"density\": 1400, \"viscosity\": %g}],\n"                                      \
    "\"bodies\": [{\"shape\": \"box\", \"min\": [0.1, 0.1, 0.1], \"max\": [0.3, 0.3, 0.3]%s}],\n"  \
    "\"solver\": {\"method\": \"dfsph\"}}", gravity, viscosity, more

/* A block of very thick fluid falls, lands after 0.14 s, and stops at once. */
static void honey(void **state)
{
    (void)state;
    struct world w;
    double kinetic, potential, first, speed = 9.81 * 0.1;
    world_open(&w, HONEY(-9.81, "", 1e6));
    assert_true(w.plan.choice.implicit_viscosity);
    energies(&w, &kinetic, &first);
    world_advance(&w, 0.1);
    energies(&w, &kinetic, &potential);
    print_message("# honey falling: %.5f of the height, %.5f of the speed of free fall\n",
                  (first - potential) / (0.5 * speed * speed), sqrt(2 * kinetic) / speed);
    assert_float_equal(sqrt(2 * kinetic) / speed, 1, 1e-3);
    world_advance(&w, 0.2);
    energies(&w, &kinetic, &potential);
    double landed = potential;
    world_advance(&w, 0.5);
    energies(&w, &kinetic, &potential);
    const struct solve_stats *solve = &w.simulation.stats.solves[SOLVE_VISCOSITY];
    print_message("# honey landed: kinetic energy %.2g of the fall's; in 0.3 s the centre of mass "
                  "rises %.2f d; %ld steps, at most %d iterations, %ld unsolved\n",
                  kinetic / (first - landed), (potential - landed) / (9.81 * 0.02),
                  w.simulation.stats.steps, solve->most, solve->unsolved);
    assert_true(kinetic < 1e-3 * first && potential < first);
    assert_int_equal(solve->unsolved, 0);
    world_close(&w);
}

/* Mean velocity along x. */
static double drift(struct world *w)
{
    size_t count = world_state(w)->count;
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += (double)particles_motion(world_state(w))[i].velocity[0] / (double)count;
    return sum;
}

/* Kinetic energy falls, step by step, at any viscosity, but for the first solve of pressure; momentum
 * stays, but for rounding of what is 1e7 times as stiff as it is heavy. */
static void takes_energy(void **state)
{
    (void)state;
    for (double mu = 10; mu < 1e8; mu *= 100) {
        struct world w;
        double before, kinetic, potential, first, start, rises = 0;
        world_open(&w, HONEY(0.0, ", \"velocity\": [0.5, 0, 0], \"jitter\": 0.1, "
                             "\"flow\": \"rotation\", \"flow_speed\": 0.5, \"flow_length\": 0.2, "
                             "\"flow_center\": [0.2, 0.2, 0.2]", mu));
        energies(&w, &before, &potential);
        first = before;
        start = drift(&w);
        for (int k = 0; k < 20; k++) {
            assert_int_equal(simulation_step(&w.simulation, 0.2, &w.error), STATUS_OK);
            energies(&w, &kinetic, &potential);
            rises = k ? fmax(rises, kinetic / before - 1) : 0;
            assert_true(kinetic <= before * (1 + (k ? 1e-4 : 3e-4)));
            before = kinetic;
        }
        double momentum = drift(&w) / start;
        print_message("# mu %g: in %.3g s kinetic energy to %.4f, rises %.1g of it in a step at "
                      "most; momentum off by %.2g; %s\n", mu,
                      w.simulation.time, kinetic / first, rises, momentum - 1,
                      w.plan.choice.implicit_viscosity ? "implicit" : "explicit");
        assert_float_equal(momentum, 1, mu < 1e6 ? 1e-5 : 3e-4);
        world_close(&w);
    }
}

/* Water pays nothing: no pass and no field. */
static void unused(void **state)
{
    (void)state;
    const unsigned fields = FIELD_BIT(FIELD_SEARCH) | FIELD_BIT(FIELD_REMAINDER);
    static const double mu[] = {1e-3, 0, 1e3};
    for (int k = 0; k < 3; k++) {
        struct world w;
        world_open(&w, HONEY(-9.81, "", mu[k]));
        bool has = w.plan.fields & fields;
        assert_int_equal(has, mu[k] > 1);
        assert_int_equal((w.plan.fields & FIELD_BIT(FIELD_BLOCK)) != 0, mu[k] > 1);
        assert_int_equal(w.plan.choice.implicit_viscosity, mu[k] > 1);
        for (size_t i = 0; i < w.plan.pass_count; i++)
            assert_true(has || w.plan.passes[i]->id != PASS_DRAG_MATRIX);
        assert_int_equal((w.plan.fields & FIELD_BIT(FIELD_RATE)) != 0, k == 0);
        world_close(&w);
    }
}

int main(void)
{
    log_set_level(LOG_ERROR);
    const struct CMUnitTest tests[] = {cmocka_unit_test(sums), cmocka_unit_test(gentle),
                                       cmocka_unit_test(stiff), cmocka_unit_test(same_laplacian),
                                       cmocka_unit_test(same_along_centres),
                                       cmocka_unit_test(honey), cmocka_unit_test(takes_energy),
                                       cmocka_unit_test(unused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
