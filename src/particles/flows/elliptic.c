/* Start flow: plane stretching, as of the drop that becomes an ellipse (Monaghan 1994). */
#include "particles/flows.h"

/* v = A0 (-x, y, 0), A0 = U/L */
static void velocity(const double x[3], double length, double speed, double v[3])
{
    v[0] = -speed * (x[0] / length);
    v[1] = speed * (x[1] / length);
    v[2] = 0;
}

/* Of a round drop of radius L, where dA/dt = 0: Dv/Dt = A0^2 (x, y), so that
 * p/(rho U^2) = (1 - (x^2 + y^2)/L^2) / 2 */
static double pressure(const double x[3], double length)
{
    double r2 = (x[0] * x[0] + x[1] * x[1]) / (length * length);
    return r2 < 1 ? 0.5 * (1 - r2) : 0;
}

const struct flow_row flow_elliptic = {
    .variant = {.name = "elliptic",
                .doc = "flow_speed/flow_length (-x, y, 0); pressure of a drop of radius "
                       "flow_length"},
    .velocity = velocity,
    .pressure = pressure,
};
