/* Tests density diffusion by gradients (delta-SPH, Antuono et al. 2010): a linear field does not
 * diffuse, inside or at a surface; what one particle loses others gain; a tank stays at rest. */
#include "world.h"

#include "solver/diffusion.h"

enum { MOST = 4000 };

#define HEAD "{\"gravity\": [0, %g, 0], \"particles\": {\"spacing\": 0.05}, \"time\": {\"end\": 9},\n" \
             "\"domain\": {\"min\": [0, 0, 0], \"max\": [0.6, 0.8, 0.6]%s},\n"
#define ONE "\"fluids\": [{\"density\": 1000}],\n"
#define SOLVER_OF(form) \
    "\"solver\": {\"method\": \"wcsph\", \"diffusion_form\": \"" form "\"%s}}"
#define SOLVER SOLVER_OF("antuono")

/* A block in the air, disturbed, with all its faces, edges and corners. */
#define BLOCK "\"bodies\": [{\"shape\": \"box\", \"min\": [0.1, 0.1, 0.1], \"max\": [0.5, 0.6, 0.5], " \
              "\"jitter\": 0.1}],\n"
#define TANK "\"bodies\": [{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.6, 0.5, 0.6]}],\n"

static void run_pass(struct world *w, enum pass_id pass)
{
    struct step step = {.list_radius = w->plan.choice.support};
    if (w->simulation.row->run(w->simulation.backend, pass, &step, &w->error))
        fail_msg("%s", w->error.text);
}

/* Gives each particle the density rest + field, with the volume that follows. */
static void set_density(struct world *w, double (*field)(const double x[3], uint32_t id))
{
    const struct particles *p = world_state(w);
    const struct explicit_constants *each = &w->plan.choice.each;
    run_pass(w, PASS_SORT);
    run_pass(w, PASS_NEIGHBOURS);
    for (size_t i = 0; i < p->count; i++) {
        int fluid = particles_fluid(p, i);
        double x[3] = {world_metres(w, i, 0), world_metres(w, i, 1), world_metres(w, i, 2)};
        double density = (double)each->rest_density[fluid] + field(x, particles_id(p)[i]);
        particles_density(p)[i] = (float)density;
        particles_position(p)[i].volume = each->mass[fluid] / (float)density;
    }
}

/* Rates of density by diffusion alone into `rate`; with `plain` the gradients are left out. */
static size_t diffuse(struct world *w, bool plain, double *rate)
{
    const struct particles *p = world_state(w);
    struct gradient *gradient = p->now[FIELD_GRADIENT];
    assert_in_range(p->count, 1, MOST);
    memset(particles_rate(p), 0, p->count * sizeof(struct rate));
    run_pass(w, PASS_GRADIENT);
    for (size_t i = 0; plain && i < p->count; i++)
        memset(gradient[i].along, 0, sizeof gradient[i].along);
    run_pass(w, PASS_DIFFUSION);
    for (size_t i = 0; i < p->count; i++)
        rate[i] = particles_rate(p)[i].density;
    return p->count;
}

static double linear(const double x[3], uint32_t id)
{
    (void)id;
    return 3 + 20 * x[0] - 30 * x[1] + 10 * x[2];
}

static double quadratic(const double x[3], uint32_t id)
{
    (void)id;
    return 40 * (x[1] - 0.3) * (x[1] - 0.3);
}

static double noise(const double x[3], uint32_t id)
{
    (void)x;
    return 10 * sin(7.1 * id * id);
}

static double one(const double x[3], uint32_t id)
{
    (void)x;
    return id == 200;
}

static double largest(const double *values, size_t count)
{
    double most = 0;
    for (size_t i = 0; i < count; i++)
        most = fmax(most, fabs(values[i]));
    return most;
}

static void linear_stays(void **state)
{
    (void)state;
    static const char *const walls[] = {"", ", \"walls\": \"particles\""};
    static const char *const kernels[] = {"", ", \"kernel\": \"cubic-spline\""};
    static double whole[MOST], plain[MOST];
    for (int k = 0; k < 8; k++) {
        struct world w;
        world_open(&w, HEAD ONE "%s" SOLVER, 0.0, walls[k & 1], k & 2 ? TANK : BLOCK, kernels[k / 4]);
        set_density(&w, linear);
        size_t count = diffuse(&w, false, whole);
        diffuse(&w, true, plain);
        double left = largest(whole, count) / largest(plain, count);
        print_message("# %s%s%s: %.2g of what diffuses without gradients\n", k & 2 ? "tank" : "block",
                      walls[k & 1], kernels[k / 4], left);
        assert_true(left < 2e-4);
        world_close(&w);
    }
}

/* Inside a lattice the gradients take off a parabola as well. */
static void parabola_stays(void **state)
{
    (void)state;
    static double whole[MOST], plain[MOST];
    double left = 0, most = 0;
    struct world w;
    world_open(&w, HEAD ONE "%s" SOLVER, 0.0, "", TANK, "");
    set_density(&w, quadratic);
    size_t count = diffuse(&w, false, whole);
    diffuse(&w, true, plain);
    for (size_t i = 0; i < count; i++) {
        bool inside = true;
        for (int a = 0; a < 3; a++)
            inside = inside && fabs(world_metres(&w, i, a) - (a == 1 ? 0.25 : 0.3)) < 0.06;
        left = fmax(left, inside ? fabs(whole[i]) : 0);
        most = fmax(most, inside ? fabs(plain[i]) : 0);
    }
    print_message("# parabola: %.2g of what diffuses without gradients\n", left / most);
    assert_true(most > 0 && left < 1e-3 * most);
    world_close(&w);
}

/* Volume times rate, summed, over that of the absolute values. */
static double balance(struct world *w, const double *rate, size_t count)
{
    double sum = 0, all = 0;
    for (size_t i = 0; i < count; i++) {
        double flow = rate[i] * (double)particles_position(world_state(w))[i].volume;
        sum += flow, all += fabs(flow);
    }
    return fabs(sum) / all;
}

static void volume_is_kept(void **state)
{
    (void)state;
    static const char *const walls[] = {"", ", \"walls\": \"particles\""};
    static double rate[MOST];
    for (int k = 0; k < 4; k++) {
        struct world w;
        world_open(&w, HEAD ONE "%s" SOLVER, 0.0, walls[k & 1], k & 2 ? TANK : BLOCK, "");
        set_density(&w, noise);
        size_t count = diffuse(&w, false, rate);
        double error = balance(&w, rate, count);
        print_message("# noise: sum V D / sum V |D| = %.2g\n", error);
        assert_true(error < 1e-5);
        world_close(&w);
    }
}

/* A denser particle thins, and its neighbours do not. */
static void spike_spreads(void **state)
{
    (void)state;
    static double rate[MOST];
    struct world w;
    double other = 0;
    world_open(&w, HEAD ONE "%s" SOLVER, 0.0, "", BLOCK, "");
    set_density(&w, one);
    size_t count = diffuse(&w, false, rate);
    for (size_t i = 0; i < count; i++) {
        if (particles_id(world_state(&w))[i] == 200)
            assert_true(rate[i] < 0);
        else
            other += rate[i];
    }
    assert_true(other > 0);
    world_close(&w);
}

/* Two fluids: each is linear, and nothing passes between them. */
static void fluids_stay_apart(void **state)
{
    (void)state;
    static double whole[MOST], plain[MOST];
    struct world w;
    world_open(&w, HEAD "\"fluids\": [{\"name\": \"a\", \"density\": 1000},"
               "{\"name\": \"b\", \"density\": 400}],\n\"bodies\": [{\"fluid\": \"a\", "
               "\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.6, 0.3, 0.6], \"jitter\": 0.1}, "
               "{\"fluid\": \"b\", \"shape\": \"box\", \"min\": [0, 0.3, 0], "
               "\"max\": [0.6, 0.6, 0.6], \"jitter\": 0.1}],\n" SOLVER, 0.0, "", "");
    set_density(&w, linear);
    size_t count = diffuse(&w, false, whole);
    diffuse(&w, true, plain);
    double left = largest(whole, count) / largest(plain, count);
    print_message("# two fluids: %.2g of what diffuses without gradients\n", left);
    assert_true(left < 2e-4);
    set_density(&w, noise);
    diffuse(&w, false, whole);
    assert_true(balance(&w, whole, count) < 1e-5);
    world_close(&w);
}

/* Neighbours in a plane, a line or none: no gradient, and no number that is none. */
static void few_particles(void **state)
{
    (void)state;
    static const char *const bodies[] = {"[0.1, 0.1, 0.1], \"max\": [0.5, 0.15, 0.5]",
                                         "[0.1, 0.1, 0.1], \"max\": [0.5, 0.15, 0.15]",
                                         "[0.1, 0.1, 0.1], \"max\": [0.15, 0.15, 0.15]"};
    static double whole[MOST], plain[MOST];
    for (size_t k = 0; k < sizeof bodies / sizeof *bodies; k++) {
        struct world w;
        world_open(&w, HEAD ONE "\"bodies\": [{\"shape\": \"box\", \"min\": %s}],\n" SOLVER, 0.0, "",
                   bodies[k], "");
        set_density(&w, linear);
        size_t count = diffuse(&w, false, whole);
        diffuse(&w, true, plain);
        assert_memory_equal(whole, plain, count * sizeof *whole);
        assert_true(isfinite(largest(whole, count)));
        assert_true(count == 1 || largest(whole, count) > 0);
        world_close(&w);
    }
}

/* Kinetic energy over M g H 1.5 s after the start, and the rise of the mass centre over H. */
static double tank(const char *form, const char *walls, double *rise)
{
    struct world w;
    double energy = 0, height[2] = {0};
    world_open(&w, HEAD "\"fluids\": [{\"density\": 1000, \"viscosity\": 1}],\n%s" SOLVER_OF("%s"),
               -9.81, walls, TANK, form, "");
    const double count = (double)world_state(&w)->count;
    for (int last = 0; last < 2; last++) {
        world_advance(&w, last ? 1.5 : 0);
        for (size_t i = 0; i < world_state(&w)->count; i++) {
            const float *v = particles_motion(world_state(&w))[i].velocity;
            height[last] += world_metres(&w, i, 1) / count / 0.5;
            for (int a = 0; a < 3 && last; a++)
                energy += 0.5 * (double)v[a] * (double)v[a] / (9.81 * 0.5) / count;
        }
    }
    *rise = height[1] - height[0];
    print_message("# tank%s, %s: kinetic energy %.2g M g H, mass centre rises %.2g %% of H\n", walls,
                  form, energy, 100 * *rise);
    world_close(&w);
    return energy;
}

/* Not stirred more than with the other form. */
static void tank_at_rest(void **state)
{
    (void)state;
    static const char *const walls[] = {"", ", \"walls\": {\"-y\": \"particles\"}"};
    for (int k = 0; k < 2; k++) {
        double rise, other, energy = tank("antuono", walls[k], &rise);
        assert_true(energy < 2 * tank("fourtakas", walls[k], &other) && energy < 1e-4);
        assert_true(fabs(rise) < 0.01);
    }
}

/* The plan's error text for a scene that is refused. */
static void refused(const char *name, const char *text, const char *at, const char *what)
{
    struct scene *scene;
    struct error e = {0};
    struct run_options options = {.threads = 0};
    if (scene_from_text(&scene, text, strlen(text), NULL, &run_vocabulary, &e) == STATUS_OK) {
        assert_int_equal(plan_check(scene, &options, &e), STATUS_USAGE);
        scene_free(scene);
    }
    print_message("# %s: %s\n", name, e.text);
    assert_int_equal(e.status, STATUS_USAGE);
    assert_non_null(strstr(e.text, at));
    assert_non_null(strstr(e.text, what));
}

static void refusals(void **state)
{
    (void)state;
#define REFUSED(fluids, solver)                                                                    \
    "{\"particles\": {\"spacing\": 0.1}, \"time\": {\"end\": 1},\n"                                \
    "\"domain\": {\"min\": [0, 0, 0], \"max\": [1, 1, 1]}, \"bodies\": [],\n" fluids                \
    "\"solver\": {" solver ",\n  \"diffusion_form\": \"antuono\"}}"
    refused("summation", REFUSED(ONE, "\"method\": \"wcsph\", \"density\": \"summation\""), ":5:21: ",
            "needs solver.density continuity");
    refused("symmetric", REFUSED("\"fluids\": [{\"name\": \"a\"}, {\"name\": \"b\", \"density\": 9}],\n",
                                 "\"method\": \"wcsph\", \"pressure_form\": \"symmetric\""), ":5:21: ",
            "needs solver.pressure_form average");
    refused("isph", REFUSED(ONE, "\"method\": \"isph\""), ":5:21: ", "is read only while");
}

int main(void)
{
    log_set_level(LOG_ERROR);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(linear_stays),  cmocka_unit_test(parabola_stays),
        cmocka_unit_test(volume_is_kept), cmocka_unit_test(spike_spreads),
        cmocka_unit_test(fluids_stay_apart), cmocka_unit_test(few_particles),
        cmocka_unit_test(tank_at_rest),  cmocka_unit_test(refusals),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
