/* Tests motion with known answers: free fall, exact times, momentum, rest, containment. */
#include "world.h"

#define HEAD "{\"particles\": {\"spacing\": 0.05}, \"time\": {\"end\": 1}, " \
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

static void falls(const char *solver, const char *body, size_t count, double most)
{
    struct world w;
    double place, speed;
    world_open(&w, HEAD "\"gravity\": [0.5, -9.81, 0],\n"
                        "\"domain\": {\"min\": [0, 0, 0], \"max\": [2, 4, 2]},\n"
                        "\"solver\": {\"method\": \"%s\"}, \"bodies\": [%s]}", 1e-3, solver, body);
    assert_int_equal(world_state(&w)->count, count);
    world_advance(&w, 0.7);
    fall_error(&w, 0.7, &place, &speed);
    print_message("# %s, %zu particle%s: fall of 2 m is off by %.1e m, %.1e m/s after %ld steps\n",
                  solver, count, count == 1 ? "" : "s", place, speed, w.simulation.stats.steps);
    double rounding = w.simulation.stats.steps * 7.0 * 0x1p-24; /* of float velocities, m/s */
    assert_true(place < most + 0.7 * rounding && speed < most / 0.7 + rounding);
    world_close(&w);
}

#define ONE "{\"shape\": \"box\", \"min\": [1, 3, 1], \"max\": [1.05, 3.05, 1.05], " \
            "\"velocity\": [0, 1, -0.25]}"
#define BLOCK "{\"shape\": \"box\", \"min\": [0.5, 3, 0.5], \"max\": [0.9, 3.3, 0.9], " \
              "\"velocity\": [0, 1, 0.25]}"

static void one_particle_falls(void **state)
{
    (void)state;
    falls("wcsph", ONE, 1, 0);
    falls("muller", ONE, 1, 0);
}

/* In a block density diffusion (and, summed, the density at its faces) stirs a little: at most a
 * fiftieth of a spacing. */
static void block_falls(void **state)
{
    (void)state;
    falls("wcsph", BLOCK, 8 * 6 * 8, 0.02 * 0.05);
    falls("muller", BLOCK, 8 * 6 * 8, 0.02 * 0.05);
}

/* Momentum and sum m|v| along axis 0..2, kg m/s. */
static double momentum(struct world *w, double sum[3])
{
    const struct particles *p = world_state(w);
    double total = 0;
    sum[0] = sum[1] = sum[2] = 0;
    for (size_t i = 0; i < p->count; i++) {
        const float *v = particles_motion(p)[i].velocity;
        double m = world_mass(w, i);
        for (int a = 0; a < 3; a++)
            sum[a] += m * (double)v[a];
        total += m * sqrt((double)v[0] * v[0] + (double)v[1] * v[1] + (double)v[2] * v[2]);
    }
    return total;
}

static void collides(const char *solver)
{
    struct world w;
    double before[3], after[3], drift = 0;
    world_open(&w, HEAD "\"gravity\": [0, 0, 0], \"solver\": {%s},\n"
        "\"domain\": {\"min\": [-5, -5, -5], \"max\": [5, 5, 5]}, \"bodies\": [\n"
        "{\"shape\": \"box\", \"min\": [-0.5, 0, 0], \"max\": [-0.1, 0.4, 0.4], "
        "\"velocity\": [2, 0, 0], \"jitter\": 0.05},\n"
        "{\"shape\": \"box\", \"min\": [0.1, 0.1, 0], \"max\": [0.5, 0.4, 0.3], "
        "\"velocity\": [-1, 0.5, 0]}]}", 0.1, solver);
    double scale = momentum(&w, before);
    world_advance(&w, 0.4);
    double later = momentum(&w, after);
    for (int a = 0; a < 3; a++)
        drift = fmax(drift, fabs(after[a] - before[a]) / scale);
    print_message("# {%s}: momentum drifts by %.1e of sum m|v| in %ld steps; sum m|v| fell to %.2f\n",
                  solver, drift, w.simulation.stats.steps, later / scale);
    assert_true(later < 0.99 * scale); /* they did collide */
    assert_true(drift < 1e-6);
    world_close(&w);
}

static void keeps_momentum(void **state)
{
    (void)state;
    collides("\"method\": \"wcsph\", \"pressure_form\": \"symmetric\"");
    collides("\"method\": \"wcsph\", \"density\": \"summation\", \"pressure_form\": \"symmetric\"");
    collides("\"method\": \"wcsph\", \"kernel\": \"cubic-spline\"");
    collides("\"method\": \"muller\"");
}

/* A lattice that fills a periodic box has no reason to move. `most`: of the speed of sound. */
static void rests(const char *solver, double most)
{
    struct world w;
    world_open(&w, HEAD "\"gravity\": [0, 0, 0], \"solver\": {%s},\n"
        "\"domain\": {\"min\": [0, 0, 0], \"max\": [0.8, 0.8, 0.8], \"walls\": \"periodic\"},\n"
        "\"bodies\": [{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.8, 0.8, 0.8]}]}", 1.0,
        solver);
    uint64_t hash = particles_hash(world_state(&w));
    world_advance(&w, 0.2);
    assert_true(w.simulation.stats.steps >= 10);
    double speed = sqrt(w.simulation.extremes.speed2), sound = w.plan.choice.sound_speed;
    print_message("# {%s}: largest speed after %ld steps %.1e m/s\n", solver,
                  w.simulation.stats.steps, speed);
    if (speed > most * sound || (most == 0 && particles_hash(world_state(&w)) != hash))
        fail_msg("{%s}: the lattice moves", solver);
    world_close(&w);
}

/* By continuity not one bit changes. A summed density differs from rest by rounding, in the order
 * of the sum, and so do forces. */
static void lattice_stays_still(void **state)
{
    (void)state;
    rests("\"method\": \"wcsph\", \"sound_speed\": 10", 0);
    rests("\"method\": \"wcsph\", \"sound_speed\": 10, \"kernel\": \"cubic-spline\"", 0);
    rests("\"method\": \"wcsph\", \"sound_speed\": 10, \"density\": \"summation\"", 1e-5);
    rests("\"method\": \"wcsph\", \"sound_speed\": 10, \"density\": \"summation\", \"clamp_negative\": false", 1e-5);
    rests("\"method\": \"muller\", \"stiffness\": 100", 1e-5);
}

/* Frame times are hit to the last bit, whatever the steps. */
static void hits_times(void **state)
{
    static const double times[] = {1e-9, 0.01, 1.0 / 30, 0.0333334, 0.05};
    struct world w;
    (void)state;
    world_open(&w, HEAD "\"domain\": {\"min\": [0, 0, 0], \"max\": [1, 20, 1]}, \"bodies\": [%s]}",
               1e-3, "{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.4, 0.4, 0.4]}");
    for (size_t k = 0; k < sizeof times / sizeof *times; k++) {
        world_advance(&w, times[k]);
        assert_true(w.simulation.time == times[k]);
    }
    world_close(&w);
}

/* Fast, thin, cornered: every particle stays, and stays inside. */
static void contains(const char *walls, const char *solver)
{
    struct world w;
    world_open(&w, HEAD "\"gravity\": [3, -30, 2], \"solver\": {%s},\n"
        "\"domain\": {\"min\": [0, 0, 0], \"max\": [0.8, 0.8, 0.6], \"walls\": %s,"
        " \"restitution\": 0.7}, \"bodies\": [\n"
        "{\"shape\": \"sphere\", \"center\": [0.4, 0.6, 0.3], \"radius\": 0.18, "
        "\"velocity\": [9, -12, 7]},\n"
        "{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.8, 0.2, 0.6], \"jitter\": 0.2}]}", 0.0,
        solver, walls);
    size_t count = w.plan.bodies.count;
    bool *seen = calloc(count, 1);
    world_advance(&w, 0.5);
    const struct particles *p = world_state(&w);
    assert_int_equal(p->count, count);
    for (size_t i = 0; i < count; i++) {
        assert_in_range(particles_id(p)[i], 0, count - 1);
        assert_false(seen[particles_id(p)[i]]);
        seen[particles_id(p)[i]] = true;
        for (int a = 0; a < 3; a++) {
            const struct space *s = &w.plan.space;
            uint32_t x = particles_position(p)[i].count[a];
            if (x < s->low[a] || x > s->high[a])
                fail_msg("particle %u left along axis %d", particles_id(p)[i], a);
            assert_true(isfinite(particles_motion(p)[i].velocity[a]));
        }
    }
    free(seen);
    world_close(&w);
}

static void nothing_leaves(void **state)
{
    (void)state;
    contains("\"closed\"", "\"method\": \"wcsph\"");
    contains("\"closed\"", "\"method\": \"muller\"");
    contains("\"particles\"", "\"kernel\": \"cubic-spline\"");
    contains("{\"-x\": \"periodic\", \"+x\": \"periodic\", \"-y\": \"particles\"}",
             "\"method\": \"wcsph\", \"density\": \"summation\"");
}

/* A step across a face ends at that face, or as far inside as it was beyond, whichever of the six. */
static void bounces_off_each_face(void **state)
{
    struct world w;
    (void)state;
    world_open(&w, HEAD "\"domain\": {\"min\": [0, 0, 0], \"max\": [1, 2, 4]}}", 0.0);
    struct explicit_constants *c = &w.plan.choice.each;
    for (int face = 0; face < 6; face++)
        for (int restitution = 0; restitution < 2; restitution++) {
            int a = face / 2;
            double wall = face & 1 ? w.scene->domain.max[a] : 0, inward = face & 1 ? -1 : 1;
            struct position old = {{0}, 1}, x = {{0}, 1};
            struct motion v0 = {{0}, 0}, v = {{0}, 0};
            struct rate rate = {{0}, 0};
            float density;
            c->restitution = (float)restitution;
            for (int k = 0; k < 3; k++)
                old.count[k] = space_count(&w.plan.space, k, k == a ? wall + 0.01 * inward : 0.5);
            v0.velocity[a] = (float)(-2 * inward);
            explicit_predict(c, 0, 0.02f, &old, &v0, &rate, 1000, NULL, &x, &v, &density);
            double away = fabs(space_metres(&w.plan.space, a, x.count[a]) - wall);
            assert_true(fabs(away - 0.03 * restitution) < 1e-6);
            assert_true(fabs(v.velocity[a] - 2 * inward * restitution) < 1e-6);
        }
    world_close(&w);
}

/* With summed density the symmetric pressure force is the gradient of an energy:
 * kinetic energy + m c0^2/M (ln r + 1/r - 1), r = rho/rho0, of disordered fluid without walls stays;
 * M is the lattice moment that gradients are divided by. */
static void summed_energy_stays(void **state)
{
    struct world w;
    double first = 0;
    (void)state;
    world_open(&w, "{\"particles\": {\"spacing\": 0.05}, \"time\": {\"end\": 1, \"cfl\": 0.1}, "
               "\"gravity\": [0, 0, 0], "
               "\"fluids\": [{\"viscosity\": 0}],\n"
               "\"domain\": {\"min\": [0, 0, 0], \"max\": [0.6, 0.5, 0.5], "
               "\"walls\": \"periodic\"},\n"
               "\"bodies\": [{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.6, 0.5, 0.5], "
               "\"jitter\": 0.2}], \"solver\": {\"method\": \"wcsph\", \"density\": \"summation\", \"eos\": \"linear\", "
               "\"sound_speed\": 20, \"pressure_form\": \"symmetric\", "
               "\"artificial_viscosity\": 0}}");
    for (int k = 0; k <= 10; k++) {
        const struct particles *p = world_state(&w);
        double energy = 0;
        world_advance(&w, 0.01 * k);
        p = world_state(&w);
        for (size_t i = 0; i < p->count; i++) {
            const float *v = particles_motion(p)[i].velocity;
            double r = fmax(1, particles_density(p)[i] / 1000.0);
            energy += world_mass(&w, i) * (0.5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) +
                                           400 / w.plan.choice.moment * (log(r) + 1 / r - 1));
        }
        first = k ? first : energy;
        if (fabs(energy / first - 1) > 2e-3)
            fail_msg("t = %g s: energy %g, at the start %g", 0.01 * k, energy, first);
    }
    world_close(&w);
}

int main(void)
{
    log_set_level(LOG_ERROR);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_particle_falls), cmocka_unit_test(block_falls),
        cmocka_unit_test(keeps_momentum),     cmocka_unit_test(lattice_stays_still),
        cmocka_unit_test(hits_times),         cmocka_unit_test(nothing_leaves),
        cmocka_unit_test(bounces_off_each_face), cmocka_unit_test(summed_energy_stays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
