/* Advances particles through time, safely: chooses time steps, rejects bad ones, sorts when needed. */
#ifndef RUN_SIMULATION_H
#define RUN_SIMULATION_H

#include "run/limits.h"
#include "run/plan.h"

/* Work of an implicit solve so far. */
struct solve_stats {
    long sweeps, unsolved; /* in all; solves that ended by their limit */
    int most, last;        /* sweeps of one solve */
    double residual;       /* that the last one left */
};

struct simulation {
    const struct plan *plan;
    const struct backend_row *row;
    struct backend *backend;
    double time;              /* s, of the present state */
    double dt;                /* the last step, s; 0 before the first */
    double last_dt;           /* natural limit of the last step, s */
    double least_dt;          /* a rejected step below this ends the run, s */
    struct extremes extremes; /* of the present state */
    bool queues;              /* passes wait until they are settled */
    bool strict;              /* a step shorter than the scene's is an error */
    double relax[SOLVE_COUNT];          /* of the sweeps of each solve, besides the solver's relaxation */
    double moved, allowance;  /* m since the last sort, and at most */
    struct {
        long steps, rejected, sorts;
        double dt_min, dt_max, dt_sum; /* s */
        struct solve_stats solves[SOLVE_COUNT];  /* by enum solve */
        double limits[LIMIT_COUNT]; /* at the start, s */
        long bound[LIMIT_COUNT];    /* steps, by the limit that was least */
    } stats;
};

/* The back end of the plan, or the first that can run here. */
const struct backend_row *simulation_backend(const struct plan *plan, const struct run_options *options);

/* Creates the particles and evaluates the first forces. */
enum status simulation_open(struct simulation *s, const struct plan *plan,
                            const struct run_options *options, struct error *e);

/* Steps until the state is at exactly `target` seconds. STATUS_RUN when a step cannot be made
 * stable: the message names the particle, the cause and what to change. */
enum status simulation_advance(struct simulation *s, double target, struct error *e);

/* Takes one step of the natural size, not beyond `target`. */
enum status simulation_step(struct simulation *s, double target, struct error *e);
void simulation_close(struct simulation *s);

#endif
