/* Vorticity of the particles, for frames: the curl of a velocity gradient that is exact for linear flow.
 *
 *   grad v_i = [sum_j V_j (v_i - v_j) x_ij^T W'/r] M_i^-1,   M_i = sum_j V_j x_ij x_ij^T W'/r
 * (the gradient of solver/diffusion.h, of each component), so that rotation by omega shows 2 omega at a
 * free surface and at a wall too. Where neighbours lie nearly in a plane or a line it fades to 0. The
 * kernel is Wendland's for every solver: M^-1 takes out its size. */
#ifndef SOLVER_CURL_H
#define SOLVER_CURL_H

#include <math.h>

/* |curl v| of grad v, whose row a is the gradient of component a. */
static inline float curl_size(float gradient[3][3])
{
    float x = gradient[2][1] - gradient[1][2], y = gradient[0][2] - gradient[2][0];
    float z = gradient[1][0] - gradient[0][1];
    return sqrtf(x * x + y * y + z * z);
}

#endif
