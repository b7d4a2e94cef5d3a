/* What every extreme case must keep: finite, contained, complete, with bounded energy. */
#ifndef TESTS_EXTREME_H
#define TESTS_EXTREME_H

#include "world.h"

/* A small tank: gravity, closed walls; arguments: solver object, extra keys, fluids, bodies. */
#define EXTREME_TANK "{%s \"domain\": {\"min\": [0, 0, 0], \"max\": [0.5, 0.5, 0.3]}, " \
                     "\"particles\": {\"spacing\": 0.05}, \"solver\": {\"method\": \"%s\"%s}, " \
                     "\"fluids\": [%s], \"bodies\": [%s]}"
#define EXTREME_GRAVITY "\"gravity\": [0, -9.81, 0], \"time\": {\"end\": 10},"
#define EXTREME_WATER "{\"name\": \"water\", \"density\": 1000, \"viscosity\": 1e-3}"
#define EXTREME_BLOCK "{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [0.25, 0.3, 0.3]%s}"

struct extreme {
    double energy, speed; /* J, kinetic and potential; m/s, largest */
};

/* Fails the test when a particle is missing, outside, or not finite. */
static inline struct extreme extreme_measure(struct world *w)
{
    const struct particles *p = world_state(w);
    const struct scene *scene = w->scene;
    struct extreme x = {0, 0};
    bool *seen = calloc(p->count + 1, sizeof *seen);
    assert_int_equal(p->count, w->plan.bodies.count);
    for (size_t i = 0; i < p->count; i++) {
        const float *v = particles_motion(p)[i].velocity;
        double v2 = 0, height = 0;
        for (int a = 0; a < 3; a++) {
            double at = world_metres(w, i, a);
            assert_true(isfinite(v[a]));
            assert_true(at >= scene->domain.min[a] - 1e-6 && at <= scene->domain.max[a] + 1e-6);
            v2 += (double)v[a] * v[a];
            height -= scene->gravity[a] * at;
        }
        assert_true(isfinite(particles_density(p)[i]) && isfinite(particles_motion(p)[i].pressure));
        assert_in_range(particles_id(p)[i], 0, p->count - 1);
        seen[particles_id(p)[i]] = true;
        x.speed = fmax(x.speed, sqrt(v2));
        x.energy += world_mass(w, i) * (v2 / 2 + height);
    }
    for (size_t i = 0; i < p->count; i++)
        assert_true(seen[i]);
    free(seen);
    return x;
}

/* The largest energy and speed in `parts` equal times up to `end`. False when the run stopped, with
 * its message in w->error; what it left must be whole all the same. */
static inline bool extreme_run(struct world *w, double end, int parts, struct extreme *most)
{
    struct extreme x;
    *most = extreme_measure(w);
    for (int k = 1; k <= parts; k++) {
        bool stopped = simulation_advance(&w->simulation, end * k / parts, &w->error) != STATUS_OK;
        x = extreme_measure(w);
        most->energy = fmax(most->energy, x.energy);
        most->speed = fmax(most->speed, x.speed);
        if (stopped)
            return false;
    }
    return true;
}

/* A result that is known to be wrong: reported, not counted. */
static inline void extreme_todo(bool good, const char *name, const char *why)
{
    printf("%s - %s%s%s\n", good ? "ok" : "not ok", name, good ? "" : " # TODO ", good ? "" : why);
}

#endif
