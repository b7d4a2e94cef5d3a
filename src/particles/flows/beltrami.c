/* Start flow: Arnold-Beltrami-Childress with A = B = C, an exact decaying solution in 3-D. */
#include "particles/flows.h"
#include "particles/waves.h"

/* u = A sin kz + C cos ky, v = B sin kx + A cos kz, w = C sin ky + B cos kx, k = 2 pi/L */
static void velocity(const double x[3], double length, double speed, double v[3])
{
    for (int a = 0; a < 3; a++) {
        double before = x[(a + 2) % 3] / length, after = x[(a + 1) % 3] / length;
        v[a] = speed * (wave_sine(before) + wave_cosine(after));
    }
}

/* p/(rho A^2) = -|u|^2 / (2 A^2), up to a constant: curl u = k u, so u x curl u = 0. The mean of
 * |u|^2 is 3 A^2; less it, the pressure has no mean. */
static double pressure(const double x[3], double length)
{
    double v[3];
    velocity(x, length, 1, v);
    return 1.5 - 0.5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

const struct flow_row flow_beltrami = {
    .variant = {.name = "beltrami",
                .doc = "ABC flow of period flow_length, A = B = C = flow_speed"},
    .velocity = velocity,
    .pressure = pressure,
};
