/* When an iterative solve goes on, and how far its sweeps are relaxed. In the common subset of C and
 * CUDA. */
#ifndef SOLVER_LOOP_H
#define SOLVER_LOOP_H

#include <math.h>
#include <stdbool.h>

#define LOOP_CALM 0.6 /* a solve that diverges relaxes its sweeps by so much more */

struct loop {
    double tolerance; /* of the residual */
    int least, most;  /* sweeps */
    int exactly;      /* sweeps, whatever their residual; 0: as many as needed */
    double momentum;  /* of sweep k: times (k - 1)/(k + 2) (Nesterov 1983) */
    bool adapts;      /* sweeps are relaxed more when the residual grows */
    double relax;     /* times the solver's relaxation */
    double best;      /* residual since the last change of it */
    int sweeps;       /* that are begun */
    int since;        /* the same, since the last change of the relaxation */
    int unsolved;     /* sweeps at which it had to end */
    bool again;       /* it goes on */
};

/* The momentum of the present sweep. */
static inline float loop_momentum(const struct loop *l)
{
    return (float)(l->momentum * (l->since - 1) / (l->since + 2));
}

/* Before the first sweep. */
static inline void loop_begin(struct loop *l)
{
    l->best = (double)INFINITY;
    l->sweeps = l->since = 1;
    l->unsolved = 0;
    l->again = true;
}

/* After a sweep that left `residual`. */
static inline void loop_next(struct loop *l, double residual)
{
    bool solved = residual <= l->tolerance;
    bool ended = l->sweeps >= l->most || !isfinite(residual);
    if (ended && !solved)
        l->unsolved++;
    l->again = l->exactly > 0 ? l->sweeps < l->exactly : l->sweeps < l->least || (!ended && !solved);
    if (!l->again)
        return;
    l->best = fmin(l->best, residual);
    if (l->adapts && !(residual <= 1.5 * l->best)) { /* disorder narrows the window of the lattice */
        l->relax *= LOOP_CALM;
        l->best = residual;
        l->since = 0;
    }
    l->sweeps++;
    l->since++;
}

#endif
