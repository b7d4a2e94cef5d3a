/* Tests the start-up of plane Couette flow, a wall that moves, against its exact series. */
#include "world.h"

#define PI 3.14159265358979323846

static const double width = 1, nu = 0.1, speed = 1.5;

/* u(y, t) = U y/H + sum_n 2U/(n pi) (-1)^n sin(n pi y/H) exp(-nu n^2 pi^2 t/H^2) */
static double exact(double y, double t)
{
    double u = speed * y / width;
    for (int n = 1; n < 60; n++)
        u += 2 * speed / (n * PI) * (n % 2 ? -1 : 1) * sin(n * PI * y / width) *
             exp(-nu * n * n * PI * PI * t / (width * width));
    return u;
}

/* The largest L2 error of u over the times of the reference, in a frame where the lower wall and all
 * fluid have `low_speed` at first. */
static double run(int across, const char *wall, double low_speed)
{
    static const double times[] = {0.0225, 0.045, 0.1125, 0.225, 1};
    struct world w;
    double d = width / across, length = 7 * d, most = 0;
    world_open(&w,
        "{\"gravity\": [0, 0, 0], \"particles\": {\"spacing\": %.17g}, \"time\": {\"end\": 20},\n"
        "\"domain\": {\"min\": [0, 0, 0], \"max\": [%.17g, 1, %.17g], \"wall_velocity\": {%s},\n"
        "\"walls\": {\"-x\": \"periodic\", \"+x\": \"periodic\", \"-z\": \"periodic\", "
        "\"+z\": \"periodic\"}},\n"
        "\"fluids\": [{\"viscosity\": 100}],\n"
        "\"bodies\": [{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [%.17g, 1, %.17g],\n"
        "\"velocity\": [%.17g, 0, 0]}],\n"
        "\"solver\": {\"method\": \"wcsph\", \"artificial_viscosity\": 0, \"clamp_negative\": false, \"sound_speed\": 15}}",
        d, length, length, wall, length, length, low_speed);
    for (int k = 0; k < 5; k++) {
        double t = times[k] * width * width / nu, sum = 0, all = 0;
        world_advance(&w, t);
        for (size_t i = 0; i < world_state(&w)->count; i++) {
            double u = exact(world_metres(&w, i, 1), t) + low_speed;
            double e = (double)particles_motion(world_state(&w))[i].velocity[0] - u;
            sum += e * e, all += u * u;
        }
        print_message("# H/d %d {%s}: t nu/H^2 = %-6g L2 error of u %.2f %%\n", across, wall,
                      times[k], 100 * sqrt(sum / all));
        most = fmax(most, sqrt(sum / all));
    }
    world_close(&w);
    return most;
}

static void one_wall(void **state)
{
    (void)state;
    assert_true(run(10, "\"+y\": [1.5, 0, 0]", 0) < 0.04);
    assert_true(run(20, "\"+y\": [1.5, 0, 0]", 0) < 0.025);
}
/* Seen from a moving frame both walls move. */
static void both_walls(void **state)
{
    (void)state;
    assert_true(run(10, "\"-y\": [-0.5, 0, 0], \"+y\": [1, 0, 0]", -0.5) < 0.06);
}

static void refuses(void **state)
{
    (void)state;
    static const struct { const char *domain, *says; } wrong[] = {
        {"\"wall_velocity\": {\"+y\": [0, 1, 0]}", "can move along itself only"},
        {"\"wall_velocity\": {\"+y\": [1, 0, 0]}, \"no_slip\": false", "only a closed wall"},
        {"\"wall_velocity\": {\"+y\": [1, 0, 0]}, \"walls\": \"particles\"", "only a closed wall"},
        {"\"wall_velocity\": {\"y\": [1, 0, 0]}", "did you mean \"domain.wall_velocity.-y\""},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char text[500];
        struct scene *scene;
        struct error e;
        int n = snprintf(text, sizeof text, "{\"domain\": {\"min\": [0, 0, 0], \"max\": [1, 1, 1], "
                         "%s}, \"particles\": {\"spacing\": 0.1}, \"fluids\": [{}], "
                         "\"time\": {\"end\": 1}}", wrong[i].domain);
        assert_int_equal(scene_from_text(&scene, text, (size_t)n, NULL, &run_vocabulary, &e),
                         STATUS_USAGE);
        if (!strstr(e.text, wrong[i].says))
            fail_msg("%s: %s", wrong[i].domain, e.text);
    }
}

int main(void)
{
    log_set_level(LOG_ERROR);
    const struct CMUnitTest tests[] = {cmocka_unit_test(one_wall), cmocka_unit_test(both_walls),
                                       cmocka_unit_test(refuses)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
