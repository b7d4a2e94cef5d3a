/* Evaluates sines and exponentials by their series. */
#include "particles/waves.h"

#include <math.h>

double wave_sine(double turns)
{
    double t = turns - floor(turns + 0.5); /* -1/2 .. 1/2 */
    if (t > 0.25)
        t = 0.5 - t;
    if (t < -0.25)
        t = -0.5 - t;
    double x = 2 * WAVE_PI * t, square = x * x, sum = 0;
    for (int n = 23; n > 1; n -= 2) /* (pi/2)^25/25! = 5e-21 */
        sum = (1 + sum) * -square / (n * (n - 1));
    return x * (1 + sum);
}

double wave_cosine(double turns)
{
    return wave_sine(turns + 0.25);
}

/* The series on x/1024, then ten squarings. */
double wave_exp(double x)
{
    double part = x / 1024, sum = 0;
    if (!(x > -700))
        return 0;
    if (!(x < 700))
        return INFINITY;
    for (int n = 16; n > 0; n--) /* 0.69^17/17! = 5e-18 */
        sum = (1 + sum) * part / n;
    sum += 1;
    for (int k = 0; k < 10; k++)
        sum *= sum;
    return sum;
}
