/* Start-up of plane Poiseuille and Couette flow against its exact series (Morris et al. 1997). */
#ifndef TESTS_START_UP_H
#define TESTS_START_UP_H

#include "world.h"

#define PI 3.14159265358979323846

struct flow {
    double width, nu, fastest; /* m, m^2/s, m/s */
    bool couette;
};

static inline double driving(const struct flow *f)
{
    return f->couette ? 0 : 8 * f->nu * f->fastest / (f->width * f->width);
}

/* Poiseuille: F/(2 nu) y (H - y) - sum_n 4 F H^2/(nu k^3) sin(k y/H) exp(-k^2 nu t/H^2), odd n
 * Couette: U y/H + sum_n 2U/k (-1)^n sin(k y/H) exp(-k^2 nu t/H^2); k = n pi */
static inline double exact(const struct flow *f, double y, double t)
{
    double w = f->width, drive = driving(f), sum = drive / (2 * f->nu) * y * (w - y);
    if (f->couette)
        sum = f->fastest * y / w;
    for (int n = 1; n < 120; n += f->couette ? 1 : 2) {
        double k = n * PI, fade = sin(k * y / w) * exp(-k * k * f->nu * t / (w * w));
        sum += f->couette ? 2 * f->fastest / k * (n % 2 ? -1 : 1) * fade
                          : -4 * drive * w * w / (f->nu * k * k * k) * fade;
    }
    return sum;
}

static inline void open_flow(struct world *w, const struct flow *f, int across,
                             const char *solver, double dt)
{
    double d = f->width / across, length = 7 * d;
    world_open(w,
        "{\"gravity\": [%.17g, 0, 0], \"particles\": {\"spacing\": %.17g},\n"
        "\"time\": {\"end\": 20, \"step\": %.17g},\n"
        "\"domain\": {\"min\": [0, 0, 0], \"max\": [%.17g, %.17g, %.17g], \"no_slip\": true,\n"
        "\"wall_velocity\": {\"+y\": [%.17g, 0, 0]}, \"walls\": "
        "{\"-x\": \"periodic\", \"+x\": \"periodic\", \"-z\": \"periodic\", \"+z\": \"periodic\"}},\n"
        "\"fluids\": [{\"density\": 1000, \"viscosity\": %.17g}],\n"
        "\"bodies\": [{\"shape\": \"box\", \"min\": [0, 0, 0], \"max\": [%.17g, %.17g, %.17g]}],\n"
        "\"solver\": {\"method\": %s}}",
        driving(f), d, dt, length, f->width, length, f->couette ? f->fastest : 0, 1000 * f->nu,
        length, f->width, length, solver);
}

/* The largest L2 error of u at the two latest times of the reference, t nu/H^2 = 0.225 and 1, with
 * steps of `times` the explicit limit, where the flow allows. */
static inline double start_up(const struct flow *f, int across, const char *solver, double times)
{
    static const double moments[] = {0.225, 1};
    struct world w;
    double d = f->width / across, most = 0, limit = 0.125 * d * d / f->nu;
    open_flow(&w, f, across, solver, times * limit);
    for (int k = 0; k < 2; k++) {
        double t = moments[k] * f->width * f->width / f->nu, sum = 0, all = 0;
        world_advance(&w, t);
        for (size_t i = 0; i < world_state(&w)->count; i++) {
            double u = exact(f, world_metres(&w, i, 1), t);
            double e = (double)particles_motion(world_state(&w))[i].velocity[0] - u;
            sum += e * e, all += u * u;
        }
        const struct solve_stats *solve = &w.simulation.stats.solves[SOLVE_VISCOSITY];
        print_message("# %s H/d %d nu %g {%s}: %ld steps, mean %.3g limits; t nu/H^2 = %-5g L2 error "
                      "%.2f %%; %.1f iterations a step\n",
                      f->couette ? "Couette" : "Poiseuille", across, f->nu, solver,
                      w.simulation.stats.steps,
                      w.simulation.stats.dt_sum / (double)w.simulation.stats.steps / limit,
                      moments[k], 100 * sqrt(sum / all),
                      (double)solve->sweeps / (double)w.simulation.stats.steps);
        assert_int_equal(solve->unsolved, 0);
        most = fmax(most, sqrt(sum / all));
    }
    world_close(&w);
    return most;
}

#endif
