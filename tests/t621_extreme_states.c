/* Tests extreme states: impact, corner, overlap, coincident particles, density ratio 1000. */
#include "extreme.h"

#include "backend/cpu/isa.h"

static const char *const methods[] = {"wcsph", "dfsph", "muller", "isph"};
enum { METHODS = sizeof methods / sizeof *methods };

static void open_drop(struct world *w, const char *method, const char *center, const char *velocity)
{
    world_open(w, "{" EXTREME_GRAVITY "\"domain\": {\"min\": [0, 0, 0], \"max\": [1, 1, 1]}, "
               "\"particles\": {\"spacing\": 0.05}, \"solver\": {\"method\": \"%s\"}, "
               "\"fluids\": [" EXTREME_WATER "], \"bodies\": [{\"shape\": \"sphere\", "
               "\"center\": %s, \"radius\": 0.2, \"velocity\": %s}]}", method, center, velocity);
}

/* Water that hits a wall, or is thrown into a corner, stays inside and gains no energy. */
static void impact(void **state)
{
    static const char *const drops[][2] = {{"[0.5, 0.25, 0.5]", "[0, -50, 0]"},
                                           {"[0.75, 0.25, 0.75]", "[30, -30, 30]"}};
    (void)state;
    for (int k = 0; k < METHODS; k++)
        for (int d = 0; d < 2; d++) {
            struct world w;
            struct extreme most;
            open_drop(&w, methods[k], drops[d][0], drops[d][1]);
            double before = extreme_measure(&w).energy;
            bool ran = extreme_run(&w, 0.02, 40, &most);
            print_message("# %s, %s: energy %.4f of the first, fastest %.0f m/s of %.0f, "
                          "%ld steps, %ld rejected\n", methods[k], d ? "corner" : "wall",
                          most.energy / before, most.speed, w.plan.choice.fastest,
                          w.simulation.stats.steps, w.simulation.stats.rejected);
            if (!ran)
                print_message("# %s\n", w.error.text);
            assert_true(ran && most.energy < 1.01 * before && most.speed < 4 * 51.96);
            world_close(&w);
        }
}

/* Puts particle `from` where `to` is, by ids. */
static void put_on(struct world *w, uint32_t from, uint32_t to)
{
    const struct particles *p = world_state(w);
    size_t i = 0, j = 0;
    for (size_t k = 0; k < p->count; k++) {
        i = particles_id(p)[k] == from ? k : i;
        j = particles_id(p)[k] == to ? k : j;
    }
    memcpy(particles_position(p)[i].count, particles_position(p)[j].count,
           sizeof particles_position(p)[i].count);
}

/* Smallest distance of the particles of two ids, in spacings. */
static double gap(struct world *w, uint32_t a, uint32_t b)
{
    double at[2][3] = {{0}}, r2 = 0;
    for (size_t k = 0; k < world_state(w)->count; k++)
        for (int side = 0; side < 2; side++)
            if (particles_id(world_state(w))[k] == (side ? b : a))
                for (int d = 0; d < 3; d++)
                    at[side][d] = world_metres(w, k, d);
    for (int d = 0; d < 3; d++)
        r2 += (at[0][d] - at[1][d]) * (at[0][d] - at[1][d]);
    return sqrt(r2) / w->plan.choice.spacing;
}

#define TWO_BLOCKS "{\"shape\": \"box\", \"min\": [0.1, 0.1, 0.05], \"max\": [0.3, 0.3, 0.25]}, " \
                   "{\"shape\": \"box\", \"min\": [0.3, 0.1, 0.05], \"max\": [0.5, 0.3, 0.25]}"

/* The state just before a step: rows are made anew, as after a step that brought particles together. */
static void put_pairs(struct world *w, uint32_t pairs)
{
    for (uint32_t p = 0; p < pairs; p++)
        put_on(w, 64 + p, p);
    w->simulation.allowance = -1;
}

/* Sum of m x, in m kg, and of m v and m |v|, in kg m/s. */
static void sums(struct world *w, double place[3], double momentum[3], double *moving)
{
    *moving = 0;
    for (int a = 0; a < 3; a++)
        place[a] = momentum[a] = 0;
    for (size_t i = 0; i < world_state(w)->count; i++) {
        const float *v = particles_motion(world_state(w))[i].velocity;
        double v2 = 0, mass = world_mass(w, i);
        for (int a = 0; a < 3; a++) {
            place[a] += mass * world_metres(w, i, a);
            momentum[a] += mass * (double)v[a];
            v2 += (double)v[a] * v[a];
        }
        *moving += mass * sqrt(v2);
    }
}

/* Pairs in one place, at the start or later, and a whole block on another come apart. Only muller,
 * which sees its double density as pressure at once, may stop the run at a block upon a block. */
static void coincident(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++)
        for (int late = 0; late < 2; late++)
            for (uint32_t pairs = 1; pairs <= 64; pairs += 63) {
                struct world w;
                struct extreme most;
                world_open(&w, EXTREME_TANK, EXTREME_GRAVITY, methods[k], "", EXTREME_WATER,
                           TWO_BLOCKS);
                assert_int_equal(world_state(&w)->count, 128);
                if (late)
                    world_advance(&w, 0.05);
                put_pairs(&w, pairs);
                bool ran = extreme_run(&w, 0.15, 10, &most);
                double least = INFINITY;
                for (uint32_t p = 0; p < pairs; p++)
                    least = fmin(least, gap(&w, p, 64 + p));
                print_message("# %s, %u pairs: %s, fastest %.2f m/s, at least %.3g d apart at "
                              "0.15 s, %ld steps, %ld rejected\n", methods[k], pairs,
                              ran ? "ran" : w.error.text, most.speed, least,
                              w.simulation.stats.steps, w.simulation.stats.rejected);
                assert_true(ran || (k == 2 && pairs > 1 && strstr(w.error.text, "cause: ")));
                assert_true(least > (pairs > 1 ? 0.02 : 0.1) && (!ran || most.speed < 5));
                world_close(&w);
            }
}

/* Parting moves neither the mass centre nor, without gravity, momentum. */
static void parting_keeps(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++)
        for (uint32_t pairs = 1; pairs <= 16; pairs += 15) {
            struct world w;
            double place[2][3], momentum[2][3], moving;
            world_open(&w, "{\"gravity\": [0, 0, 0], \"time\": {\"end\": 10}, \"domain\": {\"min\": "
                       "[-0.5, -0.5, -0.5], \"max\": [1, 1, 1]}, \"particles\": {\"spacing\": 0.05}, "
                       "\"solver\": {\"method\": \"%s\"}, \"fluids\": [" EXTREME_WATER "], "
                       "\"bodies\": [" TWO_BLOCKS "]}", methods[k]);
            put_pairs(&w, pairs);
            sums(&w, place[0], momentum[0], &moving);
            for (double t = 0.001; t < 0.02; t += 0.004) {
                world_advance(&w, t);
                sums(&w, place[1], momentum[1], &moving);
                double scale = 128 * world_mass(&w, 0) * w.plan.choice.spacing;
                for (int a = 0; a < 3; a++) {
                    assert_true(fabs(momentum[1][a]) < 1e-5 * moving + 1e-12);
                    assert_true(fabs(place[1][a] - place[0][a]) < 1e-5 * scale);
                }
            }
            assert_true(gap(&w, 0, 64) > 0.1);
            print_message("# %s, %u pairs: momentum %.1e of the sum of m |v|\n", methods[k], pairs,
                          fabs(momentum[1][0]) / fmax(moving, 1e-300));
            world_close(&w);
        }
}

/* In a corner, at an edge, at a wall, and where there are many: inside and apart. */
static void coincident_at_walls(void **state)
{
    static const double places[][3] = {{0, 0, 0}, {0.5, 0.5, 0.3}, {0.25, 0, 0}, {0.25, 0.2, 0.3},
                                       {0.251, 0.2, 0.001}};
    (void)state;
    for (int k = 0; k < METHODS; k++)
        for (size_t n = 0; n < sizeof places / sizeof *places; n++)
            for (uint32_t crowd = 2; crowd <= 7; crowd += 5) {
                struct world w;
                struct extreme most;
                double least = INFINITY;
                world_open(&w, EXTREME_TANK, EXTREME_GRAVITY, methods[k], "", EXTREME_WATER,
                           TWO_BLOCKS);
                const struct particles *p = world_state(&w);
                for (size_t i = 0; i < p->count; i++)
                    for (int a = 0; a < 3 && particles_id(p)[i] == 0; a++)
                        particles_position(p)[i].count[a] =
                            space_count(&w.plan.space, a, places[n][a]);
                for (uint32_t c = 1; c < crowd; c++)
                    put_on(&w, c, 0);
                w.simulation.allowance = -1;
                bool ran = extreme_run(&w, 1e-3, 1, &most);
                for (uint32_t c = 1; c < crowd; c++)
                    for (uint32_t other = 0; other < c; other++)
                        least = fmin(least, gap(&w, c, other));
                if (!(least > (crowd > 2 ? 1e-3 : 0.1)) || !(ran || crowd > 2))
                    fail_msg("%s, %u in one place, %zu: %.3g d apart, %s", methods[k], crowd, n,
                             least, ran ? "ran" : w.error.text);
                world_close(&w);
            }
}

/* Parting has the same bits on any instruction set and number of threads. */
static void parting_bits(void **state)
{
    static const struct { const char *isa; int threads; } on[] = {
        {"scalar", 1}, {"avx2", 1}, {"avx512", 1}, {"auto", 2}, {"auto", 7}};
    (void)state;
    for (int k = 0; k < METHODS; k++) {
        uint64_t first = 0;
        for (size_t n = 0; n < sizeof on / sizeof *on; n++) {
            const struct variant *isa = variant_find(&isa_table, on[n].isa);
            struct world w;
            if (isa && !((const struct isa_row *)isa)->supported())
                continue;
            world_open_on(&w, on[n].isa, on[n].threads, EXTREME_TANK, EXTREME_GRAVITY, methods[k],
                          "", EXTREME_WATER, TWO_BLOCKS);
            put_pairs(&w, 16);
            world_advance(&w, 0.01);
            first = n ? first : particles_hash(world_state(&w));
            assert_true(particles_hash(world_state(&w)) == first);
            world_close(&w);
        }
    }
}

/* A random start overlaps: it runs with bounded speed, or names the cause. */
static void random_start(void **state)
{
    (void)state;
    for (int k = 0; k < METHODS; k++)
        for (int seed = 1; seed <= 4; seed++) {
            struct world w;
            struct extreme most;
            char keys[60], block[240];
            snprintf(keys, sizeof keys, ", \"fill\": \"random\", \"seed\": %d", seed);
            snprintf(block, sizeof block, EXTREME_BLOCK, keys);
            world_open(&w, EXTREME_TANK, EXTREME_GRAVITY, methods[k], "", EXTREME_WATER, block);
            bool ran = extreme_run(&w, 0.3, 30, &most);
            double fall = w.plan.choice.fastest;
            print_message("# %s, seed %d: %s, fastest %.2f m/s of %.2f expected\n", methods[k],
                          seed, ran ? "ran" : w.error.text, most.speed, fall);
            assert_true(ran || strstr(w.error.text, "cause: overlap"));
            assert_true(!ran || most.speed < 5 * fall);
            world_close(&w);
        }
}

/* Mean height of a fluid, m. */
static double mean_height(struct world *w, int fluid)
{
    double sum = 0, count = 0;
    for (size_t i = 0; i < world_state(w)->count; i++)
        if (particles_fluid(world_state(w), i) == fluid) {
            sum += world_metres(w, i, 1);
            count++;
        }
    return sum / count;
}

/* Air, nearly, upon water: a thousandth of its density. */
static void layers(void **state)
{
    static const char fluids[] = EXTREME_WATER ", {\"name\": \"light\", \"density\": 1, "
                                               "\"viscosity\": 1e-3}";
    static const char bodies[] =
        "{\"fluid\": \"water\", \"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.5, 0.2, 0.3]}, "
        "{\"fluid\": \"light\", \"shape\": \"box\", \"min\": [0, 0.2, 0], \"max\": [0.5, 0.4, 0.3]}";
    (void)state;
    for (int k = 0; k < METHODS; k++) {
        struct world w;
        struct extreme most;
        world_open(&w, EXTREME_TANK, EXTREME_GRAVITY, methods[k], "", fluids, bodies);
        double heavy = mean_height(&w, 0), light = mean_height(&w, 1);
        bool ran = extreme_run(&w, 0.1, 20, &most);
        heavy -= mean_height(&w, 0);
        light -= mean_height(&w, 1);
        print_message("# %s: %s, fastest %.2f m/s, water sank %.4f m, light %.4f m, %ld steps\n",
                      methods[k], ran ? "ran" : w.error.text, most.speed, heavy, light,
                      w.simulation.stats.steps);
        static const double most_speed[METHODS] = {0.2, 1.98, 1, 1};
        assert_true(ran && most.speed < most_speed[k] && fabs(heavy) < 0.01 && fabs(light) < 0.02);
        world_close(&w);
    }
}

/* The same with periodic sides, wcsph: kinetic energy stays below 1e-6 M g H. */
static void layers_at_rest(void **state)
{
    (void)state;
    struct world w;
    double most = 0;
    world_open(&w, "{" EXTREME_GRAVITY "\"domain\": {\"min\": [0, 0, 0], \"max\": [0.2, 0.5, 0.2], "
               "\"walls\": {\"-x\": \"periodic\", \"+x\": \"periodic\", \"-y\": \"closed\", "
               "\"+y\": \"closed\", \"-z\": \"periodic\", \"+z\": \"periodic\"}}, "
               "\"particles\": {\"spacing\": 0.025}, \"solver\": {\"method\": \"wcsph\"}, "
               "\"fluids\": [" EXTREME_WATER ", {\"name\": \"light\", \"density\": 1, "
               "\"viscosity\": 2e-5}], \"bodies\": [{\"fluid\": \"water\", \"shape\": \"box\", "
               "\"min\": [0, 0, 0], \"max\": [0.2, 0.2, 0.2]}, {\"fluid\": \"light\", \"shape\": "
               "\"box\", \"min\": [0, 0.2, 0], \"max\": [0.2, 0.4, 0.2]}]}");
    for (int k = 1; k <= 20; k++) {
        double kinetic = 0, weight = 0;
        world_advance(&w, 0.02 * k);
        for (size_t i = 0; i < world_state(&w)->count; i++) {
            const float *v = particles_motion(world_state(&w))[i].velocity;
            for (int a = 0; a < 3; a++)
                kinetic += world_mass(&w, i) * (double)v[a] * v[a] / 2;
            weight += world_mass(&w, i) * 9.81 * 0.4;
        }
        most = fmax(most, kinetic / weight);
    }
    print_message("# kinetic energy at most %.2e M g H, %ld steps\n", most, w.simulation.stats.steps);
    assert_true(most < 1e-6);
    world_close(&w);
}

int main(void)
{
    log_set_level(LOG_ERROR);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(impact),       cmocka_unit_test(coincident),
        cmocka_unit_test(parting_keeps), cmocka_unit_test(coincident_at_walls),
        cmocka_unit_test(parting_bits),
        cmocka_unit_test(random_start), cmocka_unit_test(layers),
        cmocka_unit_test(layers_at_rest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
