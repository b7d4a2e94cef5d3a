/* Tests tanks of isph against exact states: hydrostatic, in layers, between wall particles; thick fluid. */
#include "extreme.h"

#define DEPTH 1.0

struct tank {
    double slope, l2, kinetic, volume, centre, lowest[2], highest[2]; /* see `measure` */
};

/* Exact pressure at a height, of up to two layers that meet at half the depth, Pa. */
static double exact(double y, double lower, double upper)
{
    double under = y < DEPTH / 2 ? DEPTH / 2 - y : 0;
    return 9.81 * (lower * under + upper * (DEPTH - y - under));
}

/* Slope (least squares) and L2 error of p against the exact pressure, kinetic energy / M g H, and
 * relative changes: volume under the surface (highest of columns 2 d wide, and d/2) and mass centre;
 * heights of each fluid. Fails when a particle is outside or not finite. */
static struct tank measure(struct world *w, double lower, double upper, const double low[3],
                           const double high[3])
{
    const struct particles *p = world_state(w);
    double d = w->plan.choice.spacing, top[64][64] = {{0}};
    double sxx = 0, sxp = 0, error = 0, all = 0, mass = 0, height = 0;
    struct tank t = {.lowest = {9, 9}};
    int columns[2] = {(int)lrint((high[0] - low[0]) / (2 * d)), (int)lrint((high[2] - low[2]) / (2 * d))};
    for (size_t i = 0; i < p->count; i++) {
        const float *v = particles_motion(p)[i].velocity;
        double x[3], m = world_mass(w, i), pressure = (double)particles_motion(p)[i].pressure;
        assert_true(isfinite(pressure));
        for (int a = 0; a < 3; a++) {
            x[a] = world_metres(w, i, a);
            assert_true(isfinite(v[a]));
            assert_true(x[a] >= low[a] - 1e-6 && x[a] <= w->scene->domain.max[a] + 1e-6);
            t.kinetic += m * (double)v[a] * (double)v[a] / 2;
        }
        double right = exact(x[1] - low[1], lower, upper);
        sxx += right * right, sxp += right * pressure;
        error += (pressure - right) * (pressure - right), all += right * right;
        mass += m, height += m * (x[1] - low[1]);
        int fluid = particles_fluid(p, i) != 0;
        t.lowest[fluid] = fmin(t.lowest[fluid], x[1] - low[1]);
        t.highest[fluid] = fmax(t.highest[fluid], x[1] - low[1]);
        int cx = (int)((x[0] - low[0]) / (2 * d)), cz = (int)((x[2] - low[2]) / (2 * d));
        cx = cx < columns[0] ? cx : columns[0] - 1, cz = cz < columns[1] ? cz : columns[1] - 1;
        top[cx][cz] = fmax(top[cx][cz], x[1] - low[1] + d / 2);
    }
    for (int x = 0; x < columns[0]; x++)
        for (int z = 0; z < columns[1]; z++)
            t.volume += top[x][z] / DEPTH / (columns[0] * columns[1]);
    double centre = (lower + 3 * upper) / (lower + upper) / 4 * DEPTH;
    t.slope = sxp / sxx - 1; /* of p against the exact p */
    t.l2 = sqrt(error / all);
    t.kinetic /= mass * 9.81 * DEPTH;
    t.volume -= 1;
    t.centre = height / mass / centre - 1;
    return t;
}

/* Runs for 2 s and returns the worst of every 0.1 s after the first. */
static struct tank worst(struct world *w, const char *name, double lower, double upper)
{
    static const double low[3] = {0, 0, 0}, high[3] = {0.5, 1.2, 0.5};
    struct tank most = measure(w, lower, upper, low, high);
    print_message("# %s, at the start: slope %+.2e, L2 %.2e\n", name, most.slope, most.l2);
    most = (struct tank){.lowest = {9, 9}};
    for (int k = 1; k <= 20; k++) {
        world_advance(w, 0.1 * k);
        struct tank t = measure(w, lower, upper, low, high);
        most.slope = fmax(most.slope, fabs(t.slope));
        most.l2 = fmax(most.l2, t.l2);
        most.kinetic = fmax(most.kinetic, t.kinetic);
        most.volume = fmax(most.volume, fabs(t.volume));
        most.centre = fmax(most.centre, fabs(t.centre));
        for (int f = 0; f < 2; f++) {
            most.lowest[f] = fmin(most.lowest[f], t.lowest[f]);
            most.highest[f] = fmax(most.highest[f], t.highest[f]);
        }
    }
    print_message("# %s, to 2 s at most: slope %.2f %%, L2 %.2f %%, kinetic energy %.1e M g H, volume "
                  "%.2f %%, mass centre %.2f %%; lower fluid up to %.4f m, upper down to %.4f m; "
                  "%ld steps\n", name, 100 * most.slope, 100 * most.l2, most.kinetic,
                  100 * most.volume, 100 * most.centre, most.highest[0], most.lowest[1],
                  w->simulation.stats.steps);
    return most;
}

#define TANK(spacing, walls, fluids, bodies)                                                       \
    "{\"gravity\": [0, -9.81, 0], \"particles\": {\"spacing\": %g}, \"time\": {\"end\": 9}, "      \
    "\"domain\": {\"min\": [0, 0, 0], \"max\": [0.5, 1.2, 0.5], \"walls\": \"%s\"}, "              \
    "\"solver\": {\"method\": \"isph\"}, \"fluids\": [%s], \"bodies\": [%s]}",                     \
        spacing, walls, fluids, bodies
#define WATER "{\"density\": 1000, \"viscosity\": 1e-3}"
#define FULL "{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.5, 1, 0.5], \"start\": \"hydrostatic\"}"

static void hydrostatic(void **state)
{
    (void)state;
    struct world w;
    world_open(&w, TANK(0.05, "closed", WATER, FULL));
    struct tank t = worst(&w, "tank 20 d deep", 1000, 1000);
    assert_true(t.slope < 0.01 && t.l2 < 0.01 && t.volume < 0.005 && t.centre < 0.005);
    assert_true(t.kinetic < 2.5e-5);
    world_close(&w);
}

#define LAYERS(upper)                                                                              \
    TANK(0.05, "closed", "{\"name\": \"lower\", \"density\": 1000, \"viscosity\": 1e-3}, "         \
         "{\"name\": \"upper\", \"density\": " upper ", \"viscosity\": 1e-3}",                       \
         "{\"fluid\": \"lower\", \"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.5, 0.5, 0.5], "  \
         "\"start\": \"hydrostatic\"}, {\"fluid\": \"upper\", \"shape\": \"box\", "                  \
         "\"min\": [0, 0.5, 0], \"max\": [0.5, 1, 0.5], \"start\": \"hydrostatic\"}")

/* With nothing to drive it, what moves must fade; `most`: kinetic energy / M g H, twice what is measured. */
static void long_layers(double upper, double end, double most)
{
    static const double low[3] = {0, 0, 0}, high[3] = {0.5, 1.2, 0.5};
    struct world w;
    char name[40];
    double early = 0, late = 0;
    if (upper > 1)
        world_open(&w, LAYERS("500"));
    else
        world_open(&w, LAYERS("1"));
    snprintf(name, sizeof name, "1000 under %g kg/m3", upper);
    for (int k = 1; k <= 6; k++) {
        world_advance(&w, end * k / 6);
        late = measure(&w, 1000, upper, low, high).kinetic;
        early = k == 1 ? late : early;
    }
    print_message("# %s: kinetic energy %.1e M g H at %g s, %.1e at %g s\n", name, early, end / 6, late,
                  end);
    extreme_todo(late < early, name, "layers at rest gain kinetic energy");
    assert_true(late < most);
    world_close(&w);
}

static void layers(void **state)
{
    (void)state;
    struct world w;
    world_open(&w, LAYERS("500"));
    struct tank t = worst(&w, "two layers", 1000, 500);
    /* By chance 0.4 to 1.3 %: a viscosity changed by 1e-4 of it is enough. */
    assert_true(t.slope < 0.025 && t.l2 < 0.025 && t.volume < 0.005 && t.centre < 0.005);
    assert_true(t.kinetic < 2e-4 && t.highest[0] < t.lowest[1]);
    world_close(&w);
    long_layers(500, 6, 1.2e-3);
    long_layers(1, 3, 2.4e-3);
}

static void wall_particles(void **state)
{
    (void)state;
    struct world w;
    world_open(&w, TANK(0.05, "particles", WATER, FULL));
    struct tank t = worst(&w, "wall particles", 1000, 1000);
    assert_true(t.slope < 0.01 && t.l2 < 0.01 && t.volume < 0.005 && t.centre < 0.005);
    assert_true(t.kinetic < 2.5e-5);
    world_close(&w);
}

/* Honey: falls as a rigid body (t414 has the places), lands after 0.2 s and stays a block. */
static void honey(void **state)
{
    (void)state;
    struct world w;
    double most = 0, kinetic = 0, centre = 0;
    world_open(&w, "{\"gravity\": [0, -9.81, 0], \"particles\": {\"spacing\": 0.025}, "
               "\"time\": {\"end\": 9}, \"domain\": {\"min\": [0, 0, 0], \"max\": [0.6, 0.6, 0.6]}, "
               "\"solver\": {\"method\": \"isph\"}, \"fluids\": [{\"density\": 1400, \"viscosity\": "
               "1e4}], \"bodies\": [{\"shape\": \"box\", \"min\": [0.2, 0.2, 0.2], "
               "\"max\": [0.4, 0.4, 0.4]}]}");
    assert_true(w.plan.choice.implicit_viscosity);
    world_advance(&w, 0.15);
    for (size_t i = 0; i < world_state(&w)->count; i++) {
        const float *v = particles_motion(world_state(&w))[i].velocity;
        most = fmax(most, fmax(fabs((double)v[1] + 9.81 * 0.15), fmax(fabsf(v[0]), fabsf(v[2]))));
    }
    assert_true(most < 1e-4);
    for (int k = 1; k <= 5; k++) {
        world_advance(&w, 0.15 + 0.07 * k);
        kinetic = centre = 0;
        for (size_t i = 0; i < world_state(&w)->count; i++) {
            const float *v = particles_motion(world_state(&w))[i].velocity;
            for (int a = 0; a < 3; a++)
                kinetic += 0.5 * (double)v[a] * (double)v[a] / (double)world_state(&w)->count;
            centre += world_metres(&w, i, 1) / (double)world_state(&w)->count;
            assert_true(isfinite(kinetic) && world_metres(&w, i, 1) >= -1e-9);
        }
    }
    const struct solve_stats *solve = &w.simulation.stats.solves[SOLVE_VISCOSITY];
    print_message("# honey: speeds of the fall differ by %.1e m/s; landed: kinetic energy %.1e of the "
                  "fall's, centre at %.4f m; %ld steps, at most %d iterations, %ld unsolved\n", most,
                  kinetic / (9.81 * 0.2), centre, w.simulation.stats.steps, solve->most,
                  solve->unsolved);
    assert_true(kinetic < 1e-3 * 9.81 * 0.2 && solve->unsolved == 0);
    assert_true(fabs(centre - 0.1) < 0.01);
    world_close(&w);
}

/* A collapse never gains energy, and its steps are those of the flow, not of sound. */
static void collapse(void **state)
{
    (void)state;
    struct world w;
    double first = 0, most = 0;
    world_open(&w, TANK(0.05, "closed", WATER,
                        "{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.25, 0.8, 0.5]}"));
    for (int k = 0; k <= 40; k++) {
        double energy = 0;
        world_advance(&w, 0.05 * k);
        for (size_t i = 0; i < world_state(&w)->count; i++) {
            const float *v = particles_motion(world_state(&w))[i].velocity;
            energy += 9.81 * world_metres(&w, i, 1);
            for (int a = 0; a < 3; a++)
                energy += 0.5 * (double)v[a] * (double)v[a];
        }
        first = k ? first : energy;
        most = fmax(most, energy / first);
    }
    print_message("# collapse: energy at most %.5f of the first, %ld steps\n", most,
                  w.simulation.stats.steps);
    assert_true(most < 1.001);
    world_close(&w);
}

int main(void)
{
    log_set_level(LOG_ERROR);
    const struct CMUnitTest tests[] = {cmocka_unit_test(hydrostatic), cmocka_unit_test(layers),
                                       cmocka_unit_test(wall_particles), cmocka_unit_test(honey),
                                       cmocka_unit_test(collapse)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
