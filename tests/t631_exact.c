/* Tests exact solutions and fits of studies: equations by finite differences, invariants, limits and
 * known values. */
#include "study/reference/exact.h"

#include "particles/flows.h"
#include "random.h"
#include "study/reference/columns.h"
#include "study/reference/fit.h"
#include "study/reference/martin_moyce.h"

#include <complex.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>

#include <cmocka.h>

static void near(double got, double wanted, double slack)
{
    if (!(fabs(got - wanted) <= slack))
        fail_msg("%.17g is not %.17g to %g", got, wanted, slack);
}

/* u_t - nu u_yy of a channel at points in space and time is the force. */
static void channel_equation(double (*u)(double y, double t), double nu, double force)
{
    const double dy = 1e-4, dt = 1e-5;
    for (int i = 1; i < 10; i++)
        for (int j = 1; j < 8; j++) {
            double y = 0.1 * i, t = 0.01 * j * j;
            double rate = (u(y, t + dt) - u(y, t - dt)) / (2 * dt);
            double bend = (u(y + dy, t) - 2 * u(y, t) + u(y - dy, t)) / (dy * dy);
            near(rate - nu * bend, force, 3e-4);
        }
}

static double half_poiseuille(double y, double t)
{
    return exact_poiseuille(y, t, 0.5, 3, 1);
}

static double half_couette(double y, double t)
{
    return exact_couette(y, t, 0.5, 3, 1);
}

static void channels_solve_their_equation(void **state)
{
    (void)state;
    channel_equation(half_poiseuille, 0.5, 3);
    channel_equation(half_couette, 0.5, 0);
    for (double t = 1e-3; t < 100; t *= 10) {
        near(half_poiseuille(0, t), 0, 0);
        near(half_poiseuille(1, t), 0, 1e-12);
        near(half_couette(0, t), 0, 0);
        near(half_couette(1, t), 3, 1e-12);
    }
    near(half_poiseuille(0.5, 1e-3), 3e-3, 1e-12); /* the force alone, far from walls */
    near(half_couette(0.5, 1e-3), 0, 1e-12);
    near(half_poiseuille(0.25, 100), 3 * 0.25 * 0.75, 1e-12);
    near(half_couette(0.25, 100), 0.75, 1e-12);
}

static void channels_have_known_values(void **state)
{
    /* nu = H = 1, F = 8: largest speed 1 */
    static const double fractions[5][2] = {
        {.0225, .17862}, {.045, .33877}, {.1125, .65999}, {.225, .88798}, {1, .99995}};
    (void)state;
    for (int k = 0; k < 5; k++)
        near(exact_poiseuille(0.5, fractions[k][0], 1, 8, 1), fractions[k][1], 5e-6);
    near(exact_poiseuille(0.25, .1125, 1, 8, 1), .509576349, 1e-9);
    near(exact_poiseuille(0.025, 4500, 1e-6, 1e-4, 0.05),
         1e-4 * 0.05 * 0.05 / 8e-6 * exact_poiseuille(0.5, 1.8, 1, 8, 1), 1e-12);
    near(exact_couette(0.5, .045, 1, 1, 1), .0955801312, 1e-9);
    near(exact_couette(0.9, .0225, 1, 1, 1), .637351888, 1e-9);
    near(exact_couette(0.75, 1, 1, 1, 1), .749976716, 1e-9);
    near(exact_couette(0.01, 90, 1e-6, 2, 0.02), 2 * exact_couette(0.5, .225, 1, 1, 1), 1e-12);
}

/* Laplacian of a start flow of period 1.5 by finite differences, against -rate/nu of it. */
static void decays(const struct flow_row *flow, double rate)
{
    const double h = 1e-3, at[3] = {0.21, -0.2, 0.11};
    double middle[3], sum[3] = {0};
    flow->velocity(at, 1.5, 2, middle);
    for (int k = 0; k < 6; k++) {
        double x[3] = {at[0], at[1], at[2]}, v[3];
        x[k / 2] += k % 2 ? h : -h;
        flow->velocity(x, 1.5, 2, v);
        for (int a = 0; a < 3; a++)
            sum[a] += (v[a] - middle[a]) / (h * h);
    }
    for (int a = 0; a < 3; a++)
        near(sum[a], -rate * middle[a], 1e-3);
    assert_true(fabs(middle[0]) > 0.5 && fabs(middle[1]) > 0.5);
}

static void vortices_decay_by_viscosity(void **state)
{
    (void)state;
    decays(&flow_taylor_green, exact_taylor_green_rate(0.1, 1.5) / 0.1);
    decays(&flow_beltrami, exact_beltrami_rate(0.1, 1.5) / 0.1);
    static const double energies[3][2] = {{0.5, 0.4540}, {1, 0.2062}, {2, 0.0425}};
    for (int k = 0; k < 3; k++) /* Re = 100 */
        near(exp(-2 * exact_taylor_green_rate(0.01, 1) * energies[k][0]), energies[k][1], 5e-5);
    near(exp(-exact_taylor_green_rate(0.01, 1) * 0.5), .673825451, 1e-9);
    near(exact_beltrami_rate(0.01, 1), 0.04 * M_PI * M_PI, 1e-15);
    near(exact_beltrami_rate(0.02, 2), 0.02 * M_PI * M_PI, 1e-15);
}

static void drop_becomes_an_ellipse(void **state)
{
    (void)state;
    struct exact_ellipse drop = exact_ellipse(0.0076, 100, 1);
    near(drop.axes[0], 0.514266, 5e-7);
    near(drop.axes[1], 1.944517, 1e-6);
    drop = exact_ellipse(0.01, 100, 2); /* keeps its area and energy, sigma^2 (a^2 + b^2) */
    near(drop.axes[0] * drop.axes[1], 4, 1e-10);
    near(drop.sigma * drop.sigma * (pow(drop.axes[0], 2) + pow(drop.axes[1], 2)), 1e4 * 8, 1e-6);
    struct exact_ellipse other = exact_ellipse(0.01, -100, 2);
    near(other.axes[0], drop.axes[1], 1e-12);
    near(exact_ellipse(0, 100, 3).axes[0], 3, 0);
}

static void drop_oscillates(void **state)
{
    (void)state;
    near(exact_oscillating_drop_period(0.5, 1), 4.567375, 2e-6);
    near(exact_oscillating_drop_period(-0.5, 1), 4.567375, 2e-6);
    near(exact_oscillating_drop_period(2, 4) * 4, 4.567375, 2e-6);
    near(exact_oscillating_drop_period(1e-4, 1), 2 * M_PI / sqrt(2), 1e-6);
    struct exact_ellipse top = exact_oscillating_drop(1.14184375, 0.5, 1, 1);
    near(top.axes[0], sqrt(0.5), 1e-7);
    near(top.axes[1], sqrt(2), 1e-7);
    near(top.sigma, 0, 1e-6);
    struct exact_ellipse half = exact_oscillating_drop(0.25, 0.5, 1, 1);
    near(exact_oscillating_drop(0.125, 1, 2, 3).axes[0], 3 * half.axes[0], 1e-12);
    double period = exact_oscillating_drop_period(0.7, 1.3);
    for (int k = 1; k <= 4; k++) { /* (sigma^2 + omega^2) (a^2 + b^2) is the energy */
        struct exact_ellipse drop = exact_oscillating_drop(period * k / 4, 0.7, 1.3, 1);
        near((pow(drop.sigma, 2) + 1.69) * (pow(drop.axes[0], 2) + pow(drop.axes[1], 2)),
             2 * (0.49 + 1.69), 1e-9);
        near(drop.axes[0] * drop.axes[1], 1, 1e-10);
    }
    near(exact_oscillating_drop(period, 0.7, 1.3, 1).axes[0], 1, 1e-8);
    near(exact_oscillating_drop(period, 0.7, 1.3, 1).sigma, 0.7, 1e-8);
}

/* The 99.5 % of an ellipse by the part of its area beyond a chord, and by counting a lattice. */
static void ellipse_reaches(void **state)
{
    static const double reaches[4] = {0, 0.3, 0.959, 1};
    (void)state;
    for (int k = 0; k < 4; k++) {
        double th = acos(reaches[k]);
        near(exact_ellipse_reach((th - sin(th) * cos(th)) / M_PI), reaches[k], 1e-6);
    }
    long inside = 0, below = 0, n = 1000;
    double reach = exact_ellipse_reach(0.005);
    for (long i = -n; i <= n; i++)
        for (long j = -n; j <= n; j++) {
            inside += i * i + j * j < n * n;
            below += i * i + j * j < n * n && (double)i <= reach * (double)n;
        }
    near((double)below / (double)inside, 0.995, 1e-4);
}

static void capillary_drop(void **state)
{
    (void)state;
    near(pow(exact_capillary_frequency(3, 5, 2), 2) * 5 * 8 / 3, 8, 1e-12); /* omega^2 rho R^3/sigma */
    near(exact_capillary_damping(0.3, 2), 4 * 0.3 / 4 + 0.3 / 4, 1e-15);  /* 5 nu / R^2 */
}

static void waves_have_limits(void **state)
{
    (void)state;
    near(2 * M_PI / exact_wave(1, 2, 0, 9.81).frequency, 1.13391748, 1e-8);
    near(2 * M_PI / exact_wave(0.1, 0.2, 0, 9.81).frequency, 0.358576191, 1e-9);
    near(exact_wave(100, 2, 0, 9.81).frequency, sqrt(9.81 * M_PI), 1e-12);         /* deep */
    near(exact_wave(0.001, 2, 0, 9.81).frequency, M_PI * sqrt(9.81 * 0.001), 1e-6); /* shallow */
    near(exact_wave(1, 2, 0.3, 9.81).damping, 0.6 * M_PI * M_PI, 1e-12);
    struct exact_wave still = exact_viscous_wave(1, 2, 0, 9.81);
    near(still.frequency, exact_wave(1, 2, 0, 9.81).frequency, 0);
    near(still.damping, 0, 0);
}

/* The root fulfils its equation, written with both sides squared away from the iteration's form. */
static void viscous_wave_solves_its_equation(void **state)
{
    (void)state;
    for (double nu = 1e-6; nu < 0.05; nu *= 3) {
        struct exact_wave wave = exact_viscous_wave(1, 2, nu, 9.81);
        double omega = exact_wave(1, 2, nu, 9.81).frequency, rate = nu * M_PI * M_PI;
        double complex s = -wave.damping + I * wave.frequency;
        double complex left = cpow(s + 2 * rate, 2) + omega * omega;
        double complex right = 4 * rate * rate * csqrt(1 + s / rate);
        assert_true(cabs(left - right) < 1e-10 * omega * omega);
        assert_true(wave.damping > 0 && wave.damping < 2 * rate && wave.frequency < omega);
    }
    struct exact_wave thin = exact_viscous_wave(1, 2, 1e-6, 9.81);
    near(thin.damping / (2e-6 * M_PI * M_PI), 1, 0.005);
    struct exact_wave thick = exact_viscous_wave(1, 2, sqrt(9.81) / 250, 9.81);
    near(thick.frequency, 5.51530140, 1e-8); /* by Newton's method */
    near(thick.damping, 0.220885114, 1e-9);
}

static void martin_moyce_tables(void **state)
{
    (void)state;
    for (int k = 0; k < MARTIN_MOYCE_FRONTS; k++) {
        const struct martin_moyce_front *row = &martin_moyce_fronts[k];
        assert_true(row->least <= row->mean && row->mean <= row->most);
        assert_true(k == 0 || (row[-1].z < row->z && row[-1].mean < row->mean));
    }
    for (int k = 1; k < MARTIN_MOYCE_HEIGHTS; k++) {
        const struct martin_moyce_height *row = &martin_moyce_heights[k];
        assert_true(row[-1].tau < row->tau && row[-1].h > row->h);
    }
}

/* Series made from the tables, of a column of another width, with clocks that began earlier. */
static void martin_moyce_fronts_compare(void **state)
{
    const struct martin_moyce_column column = {0.2, 5};
    double scale = sqrt(2 * 5 / 0.2), times[MARTIN_MOYCE_FRONTS], fronts[MARTIN_MOYCE_FRONTS];
    struct martin_moyce_errors found;
    double wanted = 0;
    (void)state;
    for (int k = 0; k < MARTIN_MOYCE_FRONTS; k++) {
        times[k] = (martin_moyce_fronts[k].mean + 0.3) / scale;
        fronts[k] = martin_moyce_fronts[k].z * 0.2;
    }
    assert_true(martin_moyce_compare_fronts(&column, times, fronts, MARTIN_MOYCE_FRONTS, &found));
    near(found.rms, 0, 1e-12);
    near(found.outside, 0, 0);
    assert_int_equal(found.count, 22);
    for (int k = 0; k < MARTIN_MOYCE_FRONTS; k++) { /* a tenth slower from Z = 1.44 on */
        double mean = martin_moyce_fronts[k].mean;
        times[k] *= 1.1;
        wanted += k < 3 ? 0 : pow(0.1 * (mean - 1.19) / mean, 2) / 22;
    }
    assert_true(martin_moyce_compare_fronts(&column, times, fronts, MARTIN_MOYCE_FRONTS, &found));
    near(found.rms, sqrt(wanted), 1e-12);
    assert_true(found.outside > 0.5);
    assert_true(martin_moyce_compare_fronts(&column, times, fronts, 5, &found));
    assert_int_equal(found.count, 2);
    assert_false(martin_moyce_compare_fronts(&column, times, fronts, 3, &found));
}

static void martin_moyce_heights_compare(void **state)
{
    const struct martin_moyce_column column = {0.2, 5};
    double times[MARTIN_MOYCE_HEIGHTS], heights[MARTIN_MOYCE_HEIGHTS];
    struct martin_moyce_errors found;
    (void)state;
    for (int k = 0; k < MARTIN_MOYCE_HEIGHTS; k++) {
        times[k] = martin_moyce_heights[k].tau / sqrt(5 / 0.2);
        heights[k] = martin_moyce_heights[k].h * 2 * 0.2;
    }
    times[16] *= 1 + 1e-12; /* the last must not be missed by rounding */
    times[0] *= 1 - 1e-12;
    assert_true(martin_moyce_compare_heights(&column, times, heights, 17, &found));
    near(found.rms, 0, 1e-9);
    assert_int_equal(found.count, 17);
    for (int k = 0; k < 17; k++)
        heights[k] += 0.02 * 0.2;
    assert_true(martin_moyce_compare_heights(&column, times, heights, 9, &found));
    near(found.rms, 0.01, 1e-9);
    assert_in_range(found.count, 8, 9);
    assert_false(martin_moyce_compare_heights(&column, times, heights, 0, &found));
}

/* 1, x and the parameter's power of x */
static void powers(double x, const double *parameters, double *values)
{
    values[0] = 1;
    values[1] = x;
    values[2] = pow(x, parameters[0]);
}

static void least_squares(void **state)
{
    const double xs[6] = {0, 1, 2, 3, 4, 5}, power = 3;
    double ys[6], factors[3];
    struct fit_bases bases = {3, powers, &power};
    (void)state;
    for (int k = 0; k < 6; k++)
        ys[k] = 4 - 2 * xs[k] + 0.5 * pow(xs[k], 3);
    near(fit_least_squares(&bases, xs, ys, 6, factors), 0, 1e-20);
    near(factors[0], 4, 1e-10);
    near(factors[1], -2, 1e-10);
    near(factors[2], 0.5, 1e-10);
    /* A straight line through (0,0) (1,1) (2,0) leaves 2/3 about its mean. */
    bases.count = 2;
    near(fit_least_squares(&bases, xs, (double[]){0, 1, 0}, 3, factors), 2.0 / 3, 1e-12);
    near(factors[0], 1.0 / 3, 1e-12);
    near(fit_slope((double[]){0, 1, 2}, (double[]){1, 3, 5}, 3), 2, 1e-15);
    near(fit_slope((double[]){0, 1, 5}, (double[]){1, -1, 1}, 3), 3.0 / 21, 1e-15);
}

static void damped_waves(void **state)
{
    enum { ROWS = 227 };
    double times[ROWS], values[ROWS];
    uint64_t seed = 1;
    (void)state;
    for (int k = 0; k < ROWS; k++) { /* a wave on a tank that settles */
        double t = times[k] = 0.04 * k;
        values[k] = 0.05 * exp(-0.25 * t) * sin(5.5 * t) + 0.03 * (1 - exp(-t / 8)) +
                    random_between(&seed, -9e-4, 9e-4);
    }
    struct fit_wave fit = fit_damped_wave(times, values, ROWS, 5.541, 0.2);
    near(fit.frequency / 5.5, 1, 0.005);
    near(fit.damping / 0.25, 1, 0.05);
    near(fit.amplitude / 0.05, 1, 0.05);
    for (int k = 0; k < ROWS; k++)
        values[k] = 0.05 * exp(-0.3 * times[k]) * cos(5.2 * times[k]) + 0.01 - 0.001 * times[k];
    fit = fit_damped_wave(times, values, ROWS, 5.541, 0.25);
    near(fit.frequency / 5.2, 1, 1e-6);
    near(fit.damping / 0.3, 1, 1e-5);
    near(fit.amplitude / 0.05, 1, 1e-5);
    for (int k = 0; k < ROWS; k++)
        values[k] = sin(5 * times[k]);
    fit = fit_damped_wave(times, values, ROWS, 5.2, 0.3);
    near(fit.frequency, 5, 5e-6);
    near(fit.damping, 0, 5e-6);
}

static void oscillations(void **state)
{
    enum { ROWS = 285 };
    double times[ROWS], values[ROWS], changes[10];
    struct fit_oscillation fit;
    (void)state;
    for (int k = 0; k < ROWS; k++) {
        times[k] = 0.05 * k;
        values[k] = exp(-0.02 * times[k]) * sin(2 * M_PI * times[k] / 4.5);
    }
    values[0] = -1e-3; /* a change before 1 s, which does not count */
    assert_int_equal(fit_sign_changes(times, values, ROWS, 1, changes, 10), 6);
    assert_int_equal(fit_sign_changes(times, values, ROWS, 0, changes, 10), 7);
    fit_sign_changes(times, values, ROWS, 1, changes, 10);
    assert_int_equal(fit_sign_changes(times, values, ROWS, 1, changes, 4), 4);
    near(changes[0], 2.25, 1e-3);
    near(changes[3], 9, 1e-3);
    near(fit_peak(times, values, ROWS, changes[0], changes[1]), exp(-0.02 * 3.375), 1e-3);
    assert_true(fit_oscillation(times, values, ROWS, 1, &fit));
    near(2 * fit.half, 4.5, 1e-3);
    assert_int_equal(fit.halves, 5);
    near(fit.last / fit.first, exp(-0.02 * 2.25 * 5), 1e-3);
    assert_false(fit_oscillation(times, values, 100, 1, &fit)); /* two changes */
}

static void crossings_and_late_means(void **state)
{
    const double times[5] = {0, 1, 2, 3, 4}, values[5] = {9, 9, 9, 1, 3};
    (void)state;
    near(fit_crossing(times, (double[]){0, 1, 0, 4, 5}, 5, 2), 2.5, 1e-15);
    near(fit_crossing(times, (double[]){0, 1, 0, 4, 5}, 5, 1), 1, 0);
    assert_true(isnan(fit_crossing(times, (double[]){0, 1, 0, 4, 5}, 5, 6)));
    assert_int_equal(fit_late(times, 5), 3);
    near(fit_late_mean(times, values, 5), 2, 0);
    assert_int_equal(fit_late(times, 1), 0);
    near(columns_interpolate(times, values, 5, 3.25), 1.5, 1e-15);
    assert_true(isnan(columns_interpolate(times, values, 5, 4.25)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(channels_solve_their_equation),
        cmocka_unit_test(channels_have_known_values),
        cmocka_unit_test(vortices_decay_by_viscosity),
        cmocka_unit_test(drop_becomes_an_ellipse),
        cmocka_unit_test(drop_oscillates),
        cmocka_unit_test(ellipse_reaches),
        cmocka_unit_test(capillary_drop),
        cmocka_unit_test(waves_have_limits),
        cmocka_unit_test(viscous_wave_solves_its_equation),
        cmocka_unit_test(martin_moyce_tables),
        cmocka_unit_test(martin_moyce_fronts_compare),
        cmocka_unit_test(martin_moyce_heights_compare),
        cmocka_unit_test(least_squares),
        cmocka_unit_test(damped_waves),
        cmocka_unit_test(oscillations),
        cmocka_unit_test(crossings_and_late_means),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
