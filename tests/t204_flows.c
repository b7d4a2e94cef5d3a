/* Tests start velocity fields: formulas at points, divergence, pressure, use by bodies. */
#include "world.h"

#include "particles/flows.h"
#include "particles/waves.h"

static void waves(void **state)
{
    (void)state;
    for (int i = -4000; i <= 4000; i++) {
        double x = i * 0.00317;
        assert_true(fabs(wave_sine(x) - sin(2 * WAVE_PI * x)) < 2e-14);
        assert_true(fabs(wave_cosine(x) - cos(2 * WAVE_PI * x)) < 2e-14);
        assert_true(fabs(wave_exp(x) / exp(x) - 1) < 1e-12);
    }
    assert_true(wave_sine(0.5) == 0 && fabs(wave_cosine(0) - 1) < 1e-15);
}

static struct scene_body body(const char *flow, double length, double speed)
{
    struct scene_body b = {.shape = {.kind = SHAPE_BOX, .max = {1, 1, 1}}, .velocity = {10, 0, -3},
                           .flow_center = {0.5, -1, 2}, .flow_length = length,
                           .flow_speed = speed};
    snprintf(b.flow, sizeof b.flow, "%s", flow);
    return b;
}

/* The flow alone, at a place relative to its centre. */
static void at(const struct scene_body *b, double x, double y, double z, double v[3])
{
    double p[3] = {b->flow_center[0] + x, b->flow_center[1] + y, b->flow_center[2] + z};
    flow_velocity(b, p, v);
    for (int a = 0; a < 3; a++)
        v[a] -= b->velocity[a];
}

static double pressure(const struct scene_body *b, double x, double y, double z)
{
    double p[3] = {b->flow_center[0] + x, b->flow_center[1] + y, b->flow_center[2] + z};
    return flow_pressure(b, 1000, p) / (1000 * b->flow_speed * b->flow_speed);
}

static void assert_velocity(const char *flow, double x, double y, double z, double u, double v,
                            double w)
{
    struct scene_body b = body(flow, 2, 3);
    double got[3];
    at(&b, x, y, z, got);
    if (fabs(got[0] - u) > 1e-13 || fabs(got[1] - v) > 1e-13 || fabs(got[2] - w) > 1e-13)
        fail_msg("%s at (%g, %g, %g): (%.9g, %.9g, %.9g), not (%.9g, %.9g, %.9g)", flow, x, y, z,
                 got[0], got[1], got[2], u, v, w);
}

/* Length 2 m, speed 3 m/s: k = pi / m. */
static void formulas(void **state)
{
    (void)state;
    double x = 0.3, y = -0.4, z = 0.7, k = WAVE_PI;
    assert_velocity("none", x, y, z, 0, 0, 0);
    assert_velocity("taylor-green", x, y, z, -3 * cos(k * x) * sin(k * y),
                    3 * sin(k * x) * cos(k * y), 0);
    assert_velocity("beltrami", x, y, z, 3 * (sin(k * z) + cos(k * y)),
                    3 * (sin(k * x) + cos(k * z)), 3 * (sin(k * y) + cos(k * x)));
    assert_velocity("rotation", x, y, z, -1.5 * y, 1.5 * x, 0);
    assert_velocity("elliptic", x, y, z, -1.5 * x, 1.5 * y, 0);
    assert_velocity("standing-wave", x, y, z, -3 * sin(k * x) * cosh(k * y),
                    3 * cos(k * x) * sinh(k * y), 0);
    assert_velocity("shear", x, y, z, 1.5 * y, 0, 0);
}

/* Central differences of the components over `axis`. */
static void slope(const struct scene_body *b, const double x[3], int axis, double out[3])
{
    double step = 1e-4, high[3], low[3], p[3] = {x[0], x[1], x[2]};
    p[axis] += step;
    at(b, p[0], p[1], p[2], high);
    p[axis] -= 2 * step;
    at(b, p[0], p[1], p[2], low);
    for (int a = 0; a < 3; a++)
        out[a] = (high[a] - low[a]) / (2 * step);
}

/* (v . grad) v + grad p / rho, m/s^2: the acceleration that steady flow would leave. */
static void unbalance(const struct scene_body *b, const double x[3], double out[3])
{
    double v[3], part[3], step = 1e-4, u2 = b->flow_speed * b->flow_speed;
    at(b, x[0], x[1], x[2], v);
    out[0] = out[1] = out[2] = 0;
    for (int a = 0; a < 3; a++) {
        double high[3] = {x[0], x[1], x[2]}, low[3] = {x[0], x[1], x[2]};
        slope(b, x, a, part);
        for (int c = 0; c < 3; c++)
            out[c] += v[a] * part[c];
        high[a] += step, low[a] -= step;
        out[a] += u2 * (pressure(b, high[0], high[1], high[2]) -
                        pressure(b, low[0], low[1], low[2])) / (2 * step);
    }
}

static void keeps_volume(void **state)
{
    (void)state;
    for (size_t i = 0; i < flow_table.count; i++) {
        struct scene_body b = body(flow_table.rows[i]->name, 2, 3);
        for (int k = 0; k < 50; k++) {
            double x[3] = {0.13 * k - 3, 1.7 - 0.11 * k, 0.07 * k}, sum = 0, size = 1, part[3];
            for (int a = 0; a < 3; a++) {
                slope(&b, x, a, part);
                sum += part[a];
                size += fabs(part[a]);
            }
            if (fabs(sum) > 1e-6 * size)
                fail_msg("%s: divergence %g", flow_table.rows[i]->name, sum);
        }
    }
}

/* Pressure and inertia cancel in the flows that are steady but for viscosity, and in the drop at its
 * first moment. */
static void balances(void **state)
{
    (void)state;
    static const char *const steady[] = {"taylor-green", "beltrami", "elliptic"};
    for (size_t i = 0; i < 3; i++) {
        struct scene_body b = body(steady[i], 2, 3);
        for (int k = 0; k < 20; k++) {
            double x[3] = {0.06 * k - 0.6, 0.7 - 0.05 * k, 0.07 * k}, rest[3];
            unbalance(&b, x, rest);
            if (fabs(rest[0]) + fabs(rest[1]) + fabs(rest[2]) > 1e-5)
                fail_msg("%s: unbalanced by (%g, %g, %g)", steady[i], rest[0], rest[1], rest[2]);
        }
    }
}

/* Values of the series from numerics of the patch: the centre has -0.14734, (0.25 L, L/2) has
 * -0.11467, (0.05 L, L/2) has -0.031335 rho omega^2 L^2; zero on the sides. */
static void patch_pressure(void **state)
{
    (void)state;
    struct scene_body b = body("rotation", 2, 3);
    assert_true(fabs(pressure(&b, 0, 0, 5) + 0.14734274) < 1e-6);
    assert_true(fabs(pressure(&b, -0.5, 0, 0) + 0.11466983) < 1e-6);
    assert_true(fabs(pressure(&b, -0.9, 0, 0) + 0.0313350769) < 1e-6);
    assert_true(pressure(&b, 1, 0.2, 0) == 0 && pressure(&b, 0, 4, 0) == 0);
}

static void fastest(void **state)
{
    (void)state;
    struct scene_body b = body("none", 1, 5);
    assert_true(fabs(flow_fastest(&b) - sqrt(109)) < 1e-14);
    assert_false(flow_still(&b));
    b = body("shear", 1, 2);
    assert_true(fabs(flow_fastest(&b) - sqrt(14.0 * 14 + 9)) < 1e-14); /* y - centre = 2 at most */
    memset(b.velocity, 0, sizeof b.velocity);
    assert_false(flow_still(&b));
    b.flow_speed = 0;
    assert_true(flow_still(&b));
}

#define PERIODIC \
    "{\"gravity\": [0, 0, 0], \"particles\": {\"spacing\": 0.05}, \"time\": {\"end\": 1},\n" \
    "\"domain\": {\"min\": [0, 0, 0], \"max\": [1, 1, 0.4], \"walls\": \"periodic\"},\n" \
    "\"fluids\": [{\"viscosity\": 10}],\n" \
    "\"bodies\": [{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [1, 1, 0.4],\n" \
    "  \"flow\": \"taylor-green\"%s}], \"solver\": {\"method\": \"wcsph\", \"clamp_negative\": %s}}"

/* Particles of a scene start with the flow's velocity and pressure, and hence a density. */
static void starts_a_scene(void **state)
{
    (void)state;
    struct world w;
    world_open(&w, PERIODIC, "", "false");
    assert_true(fabs(w.plan.choice.sound_speed - 10) < 1e-9);
    const struct particles *p = world_state(&w);
    double worst = 0, most = 0;
    for (size_t i = 0; i < p->count; i++) {
        double x = world_metres(&w, i, 0), y = world_metres(&w, i, 1), k = 2 * WAVE_PI;
        const struct motion *m = &particles_motion(p)[i];
        worst = fmax(worst, fabs((double)m->velocity[0] + cos(k * x) * sin(k * y)));
        worst = fmax(worst, fabs((double)m->velocity[1] - sin(k * x) * cos(k * y)));
        most = fmax(most, fabs((double)m->pressure + 250 * (cos(2 * k * x) + cos(2 * k * y))));
    }
    print_message("# velocity off by %.1e m/s, pressure by %.1e of 500 Pa\n", worst, most);
    assert_true(worst < 1e-6 && most < 0.02);
    world_close(&w);
}

/* The same without pressure: asked for, or negative pressure is clamped. */
static void starts_without_pressure(void **state)
{
    (void)state;
    struct world w;
    world_open(&w, PERIODIC, ", \"start\": \"rest\"", "false");
    for (size_t i = 0; i < world_state(&w)->count; i++)
        assert_true(particles_motion(world_state(&w))[i].pressure == 0);
    world_close(&w);
    world_open(&w, PERIODIC, "", "true");
    for (size_t i = 0; i < world_state(&w)->count; i++)
        assert_true(particles_motion(world_state(&w))[i].pressure >= 0);
    world_close(&w);
}

int main(void)
{
    log_set_level(LOG_ERROR);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(waves),          cmocka_unit_test(formulas),
        cmocka_unit_test(keeps_volume),   cmocka_unit_test(balances),
        cmocka_unit_test(patch_pressure), cmocka_unit_test(fastest),
        cmocka_unit_test(starts_a_scene), cmocka_unit_test(starts_without_pressure),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
