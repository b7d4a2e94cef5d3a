/* Start flow: a standing gravity wave as it passes through a level surface. */
#include "particles/flows.h"
#include "particles/waves.h"

/* Linear potential flow over a floor at y = 0, k = 2 pi/L, crest to be at x = 0:
 * u = -U sin kx cosh ky, v = U cos kx sinh ky. Amplitude a on depth H: U = a omega / sinh kH,
 * omega^2 = g k tanh kH. Its pressure is hydrostatic at that moment. */
static void velocity(const double x[3], double length, double speed, double v[3])
{
    double up = wave_exp(2 * WAVE_PI * x[1] / length), down = 1 / up;
    v[0] = -speed * wave_sine(x[0] / length) * (up + down) / 2;
    v[1] = speed * wave_cosine(x[0] / length) * (up - down) / 2;
    v[2] = 0;
}

const struct flow_row flow_standing_wave = {
    .variant = {.name = "standing-wave",
                .doc = "wave of length flow_length along x through its level; flow_center on the "
                       "floor below a crest, flow_speed the fastest at the floor"},
    .velocity = velocity,
};
