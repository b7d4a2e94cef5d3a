/* Start flow: the Taylor-Green vortices (Taylor & Green 1937), an exact decaying solution. */
#include "particles/flows.h"
#include "particles/waves.h"

/* u = -U cos 2 pi x/L sin 2 pi y/L, v = U sin 2 pi x/L cos 2 pi y/L */
static void velocity(const double x[3], double length, double speed, double v[3])
{
    double s = x[0] / length, t = x[1] / length;
    v[0] = -speed * wave_cosine(s) * wave_sine(t);
    v[1] = speed * wave_sine(s) * wave_cosine(t);
    v[2] = 0;
}

/* p/(rho U^2) = -(cos 4 pi x/L + cos 4 pi y/L) / 4 */
static double pressure(const double x[3], double length)
{
    return -0.25 * (wave_cosine(2 * x[0] / length) + wave_cosine(2 * x[1] / length));
}

const struct flow_row flow_taylor_green = {
    .variant = {.name = "taylor-green",
                .doc = "vortices in x and y of period flow_length, fastest flow_speed"},
    .velocity = velocity,
    .pressure = pressure,
};
