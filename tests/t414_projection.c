/* Tests motion by isph with known answers: falls, rest, momentum, moving observers, few particles. */
#include "world.h"

#define HEAD "{\"particles\": {\"spacing\": 0.05}, \"time\": {\"end\": 9}, " \
             "\"solver\": {\"method\": \"isph\"}, "                         \
             "\"fluids\": [{\"density\": 1000, \"viscosity\": %g}],\n"

/* Largest distance, m, and speed difference, m/s, from a fall out of the start points. */
static void fall_error(struct world *w, double time, double *place, double *speed)
{
    const struct particles *p = world_state(w);
    const double *g = w->scene->gravity;
    *place = *speed = 0;
    for (size_t i = 0; i < p->count; i++)
        for (int a = 0; a < 3; a++) {
            size_t id = particles_id(p)[i];
            double v0 = w->scene->bodies[0].velocity[a];
            double x = w->plan.bodies.point[id][a] + v0 * time + 0.5 * g[a] * time * time;
            *place = fmax(*place, fabs(world_metres(w, i, a) - x));
            *speed = fmax(*speed, fabs((double)particles_motion(p)[i].velocity[a] -
                                       (v0 + g[a] * time)));
        }
}

/* Falls are exact but for rounding: nothing is compressed, so no pressure may act. */
static void falls(const char *body, size_t count, double viscosity)
{
    struct world w;
    double place, speed;
    world_open(&w, HEAD "\"gravity\": [0.5, -9.81, 0],\n"
                        "\"domain\": {\"min\": [0, 0, 0], \"max\": [2, 4, 2]}, \"bodies\": [%s]}",
               viscosity, body);
    assert_int_equal(world_state(&w)->count, count);
    world_advance(&w, 0.7);
    fall_error(&w, 0.7, &place, &speed);
    print_message("# %zu particle%s, %g Pa s: fall of 2 m is off by %.1e m, %.1e m/s after %ld steps\n",
                  count, count == 1 ? "" : "s", viscosity, place, speed, w.simulation.stats.steps);
    double rounding = (double)w.simulation.stats.steps * 7 * 0x1p-24; /* of float velocities, m/s */
    assert_true(w.simulation.stats.steps >= 10);
    assert_true(place < 0.7 * rounding && speed < rounding);
    world_close(&w);
}

static void free_fall(void **state)
{
    (void)state;
    falls("{\"shape\": \"box\", \"min\": [1, 3, 1], \"max\": [1.05, 3.05, 1.05], "
          "\"velocity\": [0, 1, -0.25]}", 1, 1e-3);
    falls("{\"shape\": \"box\", \"min\": [1, 3, 1], \"max\": [1.1, 3.05, 1.05], "
          "\"velocity\": [0, 1, -0.25]}", 2, 1e-3);
    falls("{\"shape\": \"box\", \"min\": [0.5, 3, 0.5], \"max\": [0.9, 3.3, 0.9], "
          "\"velocity\": [0, 1, 0.25]}", 8 * 6 * 8, 1e-3);
    falls("{\"shape\": \"box\", \"min\": [0.5, 3, 0.5], \"max\": [0.9, 3.3, 0.9], "
          "\"velocity\": [0, 1, 0.25]}", 8 * 6 * 8, 1e4);
}

/* A lattice without forces never has a speed, and stays where it is to the last bit; next to planes,
 * whose share of the density is not the lattice's, its places even out by less than `most` spacings. */
static void rests(const char *walls, const char *body, double most)
{
    static struct position first[4096];
    struct world w;
    double moved = 0;
    world_open(&w, "{\"particles\": {\"spacing\": 0.05}, \"time\": {\"end\": 9, \"step\": 0.02}, "
               "\"solver\": {\"method\": \"isph\"}, \"fluids\": [{\"density\": 1000, \"viscosity\": "
               "1}], \"gravity\": [0, 0, 0], \"domain\": {\"min\": [0, 0, 0], \"max\": "
               "[0.8, 0.8, 0.8], \"walls\": \"%s\"}, \"bodies\": [%s]}", walls, body);
    const struct particles *p = world_state(&w);
    assert_in_range(p->count, 2, sizeof first / sizeof *first);
    for (size_t i = 0; i < p->count; i++)
        first[particles_id(p)[i]] = particles_position(p)[i];
    for (int k = 1; k <= 4; k++) {
        world_advance(&w, 0.25 * k);
        assert_true(w.simulation.extremes.speed2 == 0);
    }
    p = world_state(&w);
    for (size_t i = 0; i < p->count; i++)
        for (int a = 0; a < 3; a++) {
            uint32_t from = first[particles_id(p)[i]].count[a], to = particles_position(p)[i].count[a];
            moved = fmax(moved, fabs((double)(int32_t)(to - from)) * w.plan.space.unit[a] / 0.05);
        }
    print_message("# %s, %zu particles: moved by %.1e d in %ld steps\n", walls, p->count, moved,
                  w.simulation.stats.steps);
    assert_true(moved <= most && w.simulation.stats.steps >= 50);
    world_close(&w);
}

static void lattices_rest(void **state)
{
    (void)state;
    const char *full = "{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.8, 0.8, 0.8]}";
    rests("periodic", full, 0);
    rests("closed", "{\"shape\": \"box\", \"min\": [0.2, 0.2, 0.2], \"max\": [0.6, 0.5, 0.6]}", 0);
    rests("closed", "{\"shape\": \"sphere\", \"center\": [0.4, 0.4, 0.4], \"radius\": 0.25}", 0);
    rests("closed", full, 0.01);
    rests("closed", "{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.4, 0.5, 0.8]}", 0.015);
}

/* Sum m v along axis 0..2 and sum m |v|, kg m/s; sum m v^2/2, J. */
struct motions {
    double momentum[3], size, energy;
};

static struct motions motions(struct world *w)
{
    struct motions s = {{0}, 0, 0};
    for (size_t i = 0; i < world_state(w)->count; i++) {
        const float *v = particles_motion(world_state(w))[i].velocity;
        double m = world_mass(w, i), v2 = 0;
        for (int a = 0; a < 3; a++) {
            s.momentum[a] += m * (double)v[a];
            v2 += (double)v[a] * (double)v[a];
        }
        s.size += m * sqrt(v2);
        s.energy += m * v2 / 2;
    }
    return s;
}

/* Two bodies without walls or gravity; `most`: drift of momentum, of the first sum m |v|. */
static void collides(const char *name, const char *bodies, double most)
{
    struct world w;
    double drift = 0, gain = 0;
    world_open(&w, HEAD "\"gravity\": [0, 0, 0], \"domain\": {\"min\": [-5, -5, -5], \"max\": "
                        "[5, 5, 5]}, \"bodies\": [%s]}", 0.1, bodies);
    struct motions first = motions(&w), now = first;
    for (int k = 1; k <= 8; k++) {
        world_advance(&w, 0.05 * k);
        now = motions(&w);
        for (int a = 0; a < 3; a++)
            drift = fmax(drift, fabs(now.momentum[a] - first.momentum[a]) / first.size);
        gain = fmax(gain, now.energy / first.energy);
    }
    print_message("# %s: momentum drifts by %.1e of sum m|v| in %ld steps; sum m|v| fell to %.2f, "
                  "energy at most %.4f, at the end %.2f\n", name, drift, w.simulation.stats.steps,
                  now.size / first.size, gain, now.energy / first.energy);
    assert_true(now.size < 0.99 * first.size); /* they did collide */
    assert_true(drift < most && gain < 1.0001);
    world_close(&w);
}

/* Gradients inside and shifts keep momentum to the error of the discretization, not to rounding (halving
 * the spacing halves the drift): about twice what is measured. Pairs of particles keep it. */
static void keeps_momentum(void **state)
{
    (void)state;
    collides("equal blocks", "{\"shape\": \"box\", \"min\": [-0.5, 0, 0], \"max\": [-0.1, 0.4, 0.4], "
             "\"velocity\": [2, 0, 0]}, {\"shape\": \"box\", \"min\": [0.1, 0, 0], "
             "\"max\": [0.5, 0.4, 0.4], \"velocity\": [-2, 0, 0]}", 3e-3);
    collides("unequal blocks", "{\"shape\": \"box\", \"min\": [-0.5, 0, 0], \"max\": "
             "[-0.1, 0.4, 0.4], \"velocity\": [2, 0, 0], \"jitter\": 0.05}, {\"shape\": \"box\", "
             "\"min\": [0.1, 0.1, 0], \"max\": [0.5, 0.4, 0.3], \"velocity\": [-1, 0.5, 0]}", 3e-3);
    collides("two particles", "{\"shape\": \"box\", \"min\": [-0.15, 0, 0], \"max\": "
             "[-0.1, 0.05, 0.05], \"velocity\": [1, 0, 0]}, {\"shape\": \"box\", "
             "\"min\": [0.1, 0, 0], \"max\": [0.15, 0.05, 0.05], \"velocity\": [-1, 0, 0]}", 1e-6);
}

/* A scene 1e4 m from the origin: the same states to the last bit (lengths are exact in binary). */
static void far_away(void **state)
{
    static const char *const walls[] = {"closed", "particles", "periodic"};
    (void)state;
    for (int k = 0; k < 3; k++) {
        uint64_t hash[2], start = 0;
        for (int far = 0; far < 2; far++) {
            struct world w;
            double o = far * 1e4;
            world_open(&w, "{\"gravity\": [0, -9.81, 0], \"time\": {\"end\": 9}, \"particles\": "
                       "{\"spacing\": 0.0625}, \"solver\": {\"method\": \"isph\"}, \"fluids\": "
                       "[{\"density\": 1000, \"viscosity\": 1e-3}], \"domain\": {\"walls\": "
                       "{\"-x\": \"%s\", \"+x\": \"%s\"}, \"min\": [%.17g, %.17g, %.17g], "
                       "\"max\": [%.17g, %.17g, %.17g]}, \"bodies\": [{\"shape\": \"box\", "
                       "\"min\": [%.17g, %.17g, %.17g], \"max\": [%.17g, %.17g, %.17g]}]}",
                       walls[k], walls[k], o, -o, o, o + 1, -o + 1, o + 0.5,
                       o + 0.25, -o, o, o + 0.75, -o + 0.5, o + 0.5);
            start = particles_hash(world_state(&w));
            world_advance(&w, 0.4);
            assert_true(w.simulation.extremes.speed2 > 1);
            hash[far] = particles_hash(world_state(&w));
            world_close(&w);
        }
        assert_true(hash[0] == hash[1] && hash[0] != start);
    }
}

/* Velocities, in order of id. */
static void velocities(struct world *w, float (*out)[3])
{
    for (size_t i = 0; i < world_state(w)->count; i++)
        memcpy(out[particles_id(world_state(w))[i]],
               particles_motion(world_state(w))[i].velocity, sizeof *out);
}

/* A drop squeezed by its flow, without walls, and the same seen by a moving observer. */
static void boost(void **state)
{
    static const double speeds[2][3] = {{0, 0, 0}, {2, -1, 0.5}}; /* exact in a float */
    static float v[2][4000][3];
    size_t count = 0;
    double worst = 0, motion = 0;
    long steps[2];
    (void)state;
    for (int k = 0; k < 2; k++) {
        struct world w;
        world_open(&w, "{\"gravity\": [0, 0, 0], \"time\": {\"end\": 9, \"step\": 2e-3}, "
                   "\"particles\": {\"spacing\": 0.05}, \"solver\": {\"method\": \"isph\", "
                   "\"divergence_error\": 1e-7, \"density_error\": 1e-5}, "
                   "\"fluids\": [{\"density\": 1000, \"viscosity\": 1}], \"domain\": {\"min\": "
                   "[-8, -8, -8], \"max\": [8, 8, 8]}, \"bodies\": [{\"shape\": \"sphere\", \"center\": "
                   "[0, 0, 0], \"radius\": 0.4, \"flow\": \"elliptic\", \"flow_speed\": 0.4, "
                   "\"flow_length\": 0.4, \"velocity\": [%g, %g, %g]}]}",
                   speeds[k][0], speeds[k][1], speeds[k][2]);
        count = world_state(&w)->count;
        assert_in_range(count, 100, 4000);
        world_advance(&w, 0.1);
        velocities(&w, v[k]);
        steps[k] = w.simulation.stats.steps;
        world_close(&w);
    }
    assert_int_equal(steps[0], steps[1]);
    for (size_t i = 0; i < count; i++)
        for (int a = 0; a < 3; a++) {
            worst = fmax(worst, fabs((double)v[1][i][a] - speeds[1][a] - (double)v[0][i][a]));
            motion = fmax(motion, fabs((double)v[0][i][a]));
        }
    print_message("# a moving observer sees speeds that differ by %.1e of %.2f m/s after %ld steps\n",
                  worst, motion, steps[0]);
    assert_true(motion > 0.1 && worst < 1e-4 * motion);
}

/* None at all: time passes. */
static void nothing(void **state)
{
    struct world w;
    (void)state;
    world_open(&w, HEAD "\"gravity\": [0, -9.81, 0], \"domain\": {\"min\": [0, 0, 0], \"max\": "
                        "[1, 1, 1]}, \"bodies\": []}", 1e-3);
    assert_int_equal(world_state(&w)->count, 0);
    world_advance(&w, 0.3);
    assert_true(w.simulation.time == 0.3);
    world_close(&w);
}

int main(void)
{
    log_set_level(LOG_ERROR);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(free_fall), cmocka_unit_test(lattices_rest), cmocka_unit_test(keeps_momentum),
        cmocka_unit_test(far_away),  cmocka_unit_test(boost),         cmocka_unit_test(nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
