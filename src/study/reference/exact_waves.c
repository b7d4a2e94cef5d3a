/* Frequency and damping of small standing waves. */
#include "study/reference/exact.h"

#include <complex.h>
#include <math.h>

enum { ITERATIONS = 100 };

struct exact_wave exact_wave(double depth, double length, double nu, double g)
{
    double k = 2 * M_PI / length;
    return (struct exact_wave){sqrt(g * k * tanh(k * depth)), 2 * nu * k * k};
}

/* Iterates the equation solved for the s on its left. */
struct exact_wave exact_viscous_wave(double depth, double length, double nu, double g)
{
    struct exact_wave wave = exact_wave(depth, length, nu, g);
    double rate = wave.damping / 2, omega2 = wave.frequency * wave.frequency;
    double complex s = -wave.damping + I * wave.frequency;
    for (int k = 0; k < ITERATIONS && nu > 0; k++)
        s = -wave.damping + I * csqrt(omega2 - 4 * rate * rate * csqrt(1 + s / rate));
    return (struct exact_wave){cimag(s), -creal(s)};
}
