/* Numbers of one step: from the loop to the passes, between passes, and back. In the common subset of C
 * and CUDA. */
#ifndef BACKEND_SCALARS_H
#define BACKEND_SCALARS_H

#include "base/exact_sum.h"
#include "solver/explicit.h"
#include "solver/implicit.h"
#include "solver/loop.h"

enum { SCALAR_SUMS = 4 };

/* Sums over particles as passes collect them; none depends on the order of its terms. */
struct scalar_sums {
    struct exact_sum exact[SCALAR_SUMS];
    int64_t fixed[2]; /* in 2^-40 */
};

struct scalars {
    /* from the time loop */
    float dt;          /* s, of the step */
    float before;      /* s: of the step before; 0 at the first, and where no solver needs it */
    float resume;      /* part of the last step's shift that the next starts from */
    struct loop loop;  /* of the present solve */
    /* between passes */
    float relax;       /* times the solver's relaxation */
    float momentum;    /* of its sweeps */
    float target;      /* density ratio to aim at */
    float offset;      /* mean compression of the last sweep, where enclosed */
    float mean;        /* over the particles, where enclosed; else 0 */
    float length, keep;/* of conjugate gradients: along the direction, and part of it that is kept */
    double descent;    /* residual . residual / diagonal, of the projection's solves */
    double product;    /* of viscosity's residual with itself, preconditioned, J/m^3 */
    double scale2;     /* what residuals of viscosity are relative to */
    struct scalar_sums sums;
    /* back to the time loop, with the solve's */
    struct extremes extremes; /* of the last predict, correct or move pass */
    double residual;   /* left by the last sweep, as solve_limits count it */
};

#endif
