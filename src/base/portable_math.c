/* Sine, cosine and tangent by series, the same bits wherever they are computed. */
#include "base/portable_math.h"

#include "base/log_by_series.h"

#include <math.h>

/* pi / 2 in parts whose multiples up to 2^20 are exact. */
static const double half_pi[3] = {0x1.921fb544p+0, 0x1.0b4611a6p-34, 0x1.3198a2e037073p-69};

/* angle - quarter * pi / 2, within pi / 4 of 0. */
static double reduce(double angle, long *quarter)
{
    double k = floor(angle / (half_pi[0] + half_pi[1]) + 0.5);
    *quarter = (long)k;
    return ((angle - k * half_pi[0]) - k * half_pi[1]) - k * half_pi[2];
}

/* Taylor's series within pi / 4, rests below 1e-19. */
static double sin_near(double r)
{
    double q = r * r, sum = 0;
    for (int n = 16; n > 0; n -= 2)
        sum = (1 + sum) * (-q / (n * (n + 1)));
    return r + r * sum;
}

static double cos_near(double r)
{
    double q = r * r, sum = 0;
    for (int n = 17; n > 1; n -= 2)
        sum = (1 + sum) * (-q / (n * (n + 1)));
    return 1 - (q / 2 + q / 2 * sum);
}

double portable_sin(double angle)
{
    long quarter;
    if (!(fabs(angle) <= 1000))
        return (double)NAN;
    double r = reduce(angle, &quarter);
    double value = quarter & 1 ? cos_near(r) : sin_near(r);
    return quarter & 2 ? -value : value;
}

double portable_cos(double angle)
{
    long quarter;
    if (!(fabs(angle) <= 1000))
        return (double)NAN;
    double r = reduce(angle, &quarter);
    double value = quarter & 1 ? sin_near(r) : cos_near(r);
    return (quarter + 1) & 2 ? -value : value;
}

double portable_tan(double angle)
{
    return portable_sin(angle) / portable_cos(angle);
}

double portable_log(double x)
{
    return log_by_series(x);
}
