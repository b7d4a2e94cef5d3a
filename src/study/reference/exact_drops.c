/* Exact motion of drops: ellipses by Runge-Kutta, and a sphere under surface tension. */
#include "study/reference/exact.h"

#include <math.h>

enum { STEPS = 4000, PERIOD_STEPS = 800, BISECTIONS = 60 };

/* State: a, b, sigma; the area pi a b stays as the equations have it. */
static void rates(const double s[3], double omega, double out[3])
{
    double a2 = s[0] * s[0], b2 = s[1] * s[1];
    out[0] = -s[2] * s[0];
    out[1] = s[2] * s[1];
    out[2] = (s[2] * s[2] + omega * omega) * (a2 - b2) / (a2 + b2);
}

/* The classical fourth-order Runge-Kutta method. */
static void runge_kutta(double state[3], double omega, double t, int steps)
{
    static const double reach[4] = {0, 0.5, 0.5, 1}, weight[4] = {1, 2, 2, 1};
    double h = t / steps;
    for (int step = 0; step < steps; step++) {
        double rate[3] = {0}, sum[3] = {0}, at[3];
        for (int stage = 0; stage < 4; stage++) {
            for (int k = 0; k < 3; k++)
                at[k] = state[k] + reach[stage] * h * rate[k];
            rates(at, omega, rate);
            for (int k = 0; k < 3; k++)
                sum[k] += weight[stage] * rate[k];
        }
        for (int k = 0; k < 3; k++)
            state[k] += h / 6 * sum[k];
    }
}

static struct exact_ellipse moved(double t, double sigma, double omega, double radius, int steps)
{
    double state[3] = {radius, radius, sigma};
    runge_kutta(state, omega, t, steps);
    return (struct exact_ellipse){{state[0], state[1]}, state[2]};
}

/* With a b = R^2, (a^4 - R^4) / (a^4 + R^4) is (a^2 - b^2) / (a^2 + b^2): the drop without force. */
struct exact_ellipse exact_ellipse(double t, double sigma, double radius)
{
    return moved(t, sigma, 0, radius, STEPS);
}

struct exact_ellipse exact_oscillating_drop(double t, double sigma, double omega, double radius)
{
    return moved(t, sigma, omega, radius, STEPS);
}

/* A quarter period is between pi / (2 sqrt 2 omega), of a small sigma, and pi / (2 omega). */
double exact_oscillating_drop_period(double sigma, double omega)
{
    double low = 1 / omega, high = 1.6 / omega;
    for (int k = 0; k < BISECTIONS; k++) {
        double middle = (low + high) / 2;
        if (moved(middle, fabs(sigma), omega, 1, PERIOD_STEPS).sigma > 0)
            low = middle;
        else
            high = middle;
    }
    return 4 * low;
}

/* The part of the area beyond x = a cos th is (th - sin th cos th) / pi. */
double exact_ellipse_reach(double part)
{
    double low = 0, high = M_PI;
    for (int k = 0; k < BISECTIONS; k++) {
        double th = (low + high) / 2;
        if ((th - sin(th) * cos(th)) / M_PI < part)
            low = th;
        else
            high = th;
    }
    return cos(low);
}

/* omega^2 = n (n - 1) (n + 2) sigma / (rho R^3), n = 2 */
double exact_capillary_frequency(double tension, double density, double radius)
{
    return sqrt(8 * tension / (density * radius * radius * radius));
}

/* (n - 1) (2 n + 1) nu / R^2, n = 2 */
double exact_capillary_damping(double nu, double radius)
{
    return 5 * nu / (radius * radius);
}
