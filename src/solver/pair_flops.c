/* Counts the arithmetic of the force pass, for comparison with the machine's peak. */
#include "solver/pair_constants.h"

/* As written in pair.h and kernels/bodies.h. */
double pair_force_flops(unsigned flags)
{
    double geometry = 3 + 3 + 5 + 13, difference = 3, push = 2, spread = 6;
    double slope = flags & PAIR_MULLER ? 5 : flags & 1u ? 10 : 6;
    double sum = geometry + slope + difference + 1 + push + spread;
    if (flags & (PAIR_ARTIFICIAL | PAIR_CONTINUITY))
        sum += 5; /* v_ij . x_ij */
    if (flags & PAIR_SYMMETRIC)
        sum += 4;
    if (flags & PAIR_ARTIFICIAL)
        sum += 6;
    if (flags & (PAIR_VISCOUS | PAIR_OWN_VISCOSITY))
        sum += 7;
    if (flags & PAIR_CENTRAL)
        sum += 6;
    if (flags & PAIR_OWN_VISCOSITY)
        sum += 2;
    if (flags & PAIR_CONTINUITY)
        sum += 2;
    if (flags & PAIR_DIFFUSION)
        sum += 9;
    return sum;
}
