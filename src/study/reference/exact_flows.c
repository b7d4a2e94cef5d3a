/* Exact flows of channels that start and of vortices that decay. */
#include "study/reference/exact.h"

#include <math.h>

enum { TERMS = 200 }; /* of the series; at t nu/H^2 = 1e-4 the last is e^-400 (couette: e^-39) */

double exact_poiseuille(double y, double t, double nu, double force, double width)
{
    double u = force / (2 * nu) * y * (width - y);
    for (int n = 0; n < TERMS; n++) {
        double k = (2 * n + 1) * M_PI / width;
        u -= 4 * force / (nu * width * k * k * k) * sin(k * y) * exp(-nu * k * k * t);
    }
    return u;
}

double exact_couette(double y, double t, double nu, double wall, double width)
{
    double u = wall * y / width;
    for (int n = 1; n < TERMS; n++) {
        double k = n * M_PI / width, sign = n % 2 ? -1 : 1;
        u += sign * 2 * wall / (n * M_PI) * sin(k * y) * exp(-nu * k * k * t);
    }
    return u;
}

double exact_taylor_green_rate(double nu, double length)
{
    double k = 2 * M_PI / length;
    return 2 * nu * k * k;
}

double exact_beltrami_rate(double nu, double length)
{
    double k = 2 * M_PI / length;
    return nu * k * k;
}
