/* Start flow: rigid rotation about z, as of the square patch (Colagrossi 2005). */
#include "particles/flows.h"
#include "particles/waves.h"

enum { TERMS = 60 }; /* odd m and n below 2 TERMS; the rest is below 1e-4 of the sum */

/* v = omega (-y, x, 0), omega = U/L */
static void velocity(const double x[3], double length, double speed, double v[3])
{
    v[0] = -speed * (x[1] / length);
    v[1] = speed * (x[0] / length);
    v[2] = 0;
}

/* sin((2k+1) pi s) for s in 0..1, k = 0 .. TERMS-1 */
static void odd_sines(double s, double sine[TERMS])
{
    for (int k = 0; k < TERMS; k++)
        sine[k] = wave_sine((2 * k + 1) * s / 2);
}

/* The solution of Laplace p = 2 rho omega^2 that vanishes on the sides of the square of side L
 * (Colagrossi 2005; Le Touze et al. 2013), s and t from its corner in sides:
 * p/(rho U^2) = sum over odd m, n of -32 / (m n pi^4 (m^2 + n^2)) sin(m pi s) sin(n pi t) */
static double pressure(const double x[3], double length)
{
    double s = x[0] / length + 0.5, t = x[1] / length + 0.5, sum = 0;
    double sine_s[TERMS], sine_t[TERMS], pi2 = WAVE_PI * WAVE_PI;
    if (!(s > 0 && s < 1 && t > 0 && t < 1))
        return 0;
    odd_sines(s, sine_s);
    odd_sines(t, sine_t);
    for (int j = 0; j < TERMS; j++)
        for (int k = 0; k < TERMS; k++) {
            double m = 2 * j + 1, n = 2 * k + 1;
            sum -= 32 / (m * n * pi2 * pi2 * (m * m + n * n)) * sine_s[j] * sine_t[k];
        }
    return sum;
}

const struct flow_row flow_rotation = {
    .variant = {.name = "rotation",
                .doc = "rigid about z by flow_speed/flow_length 1/s; pressure of a square patch of "
                       "side flow_length"},
    .velocity = velocity,
    .pressure = pressure,
};
