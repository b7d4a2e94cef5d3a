/* Pressure solvers: what a solver chooses for a scene, once, before the first step. */
#ifndef SOLVER_SOLVER_H
#define SOLVER_SOLVER_H

#include "base/variant.h"
#include "particles/space.h"
#include "scene/scene.h"
#include "solver/external.h"
#include "solver/implicit.h"
#include "solver/kernel.h"
#include "solver/pair_constants.h"
#include "solver/pass.h"
#include "solver/projection.h"
#include "solver/tension.h"

#include <stdbool.h>

/* The largest stable time steps, s; INFINITY where a limit does not apply.
 * dt <= min(acoustic h/(c0 + |v|max), force sqrt(h/|a|max), viscous h^2/nu,
 *           capillary sqrt(rho h^3/(2 pi sigma)), damping/rate). */
struct step_limits {
    double acoustic;  /* C1 h c0/c of the fluid with the fastest sound, m */
    double force;     /* C2 */
    double viscous;   /* C3 h^2 / nu, s */
    double capillary; /* C4 sqrt(rho h^3 / (2 pi sigma)) (Brackbill et al. 1992), s */
    double damping;   /* 0.5 / dissipation; s */
    double user;      /* time.step */
};

#define DFSPH_WINDOW_PART 0.6 /* relaxation, of what the Jacobi window allows */

/* When the sweeps of an implicit solve end. */
struct solve_limits {
    double tolerance; /* mean positive compression; of viscosity: relative residual */
    int least, most;  /* sweeps */
    double resume;    /* part of the last step's pressure to start from */
    double momentum;  /* of sweep k: times (k - 1)/(k + 2) */
};

struct solver_choice {
    const struct kernel_row *kernel;
    double spacing;          /* d, m */
    double support;          /* support radius 2h, m */
    double smoothing_length; /* h, m */
    double sound_speed;      /* c0, of the densest fluid, m/s */
    double fastest;          /* expected largest speed, m/s */
    double wall_speed;       /* of the fastest wall, m/s */
    double depth;            /* expected depth for pressure, m, along gravity */
    struct step_limits limits;
    double cfl;              /* of the scene or the solver */
    double moment;           /* of gradients on the lattice, with masses as they are */
    unsigned flags;          /* enum pair_flag, and the kernel's */
    bool mixed;              /* rest densities of fluids differ */
    float softness[FLUIDS_MAX]; /* c0 / speed of sound of each fluid, of wcsph */
    bool continuity;         /* density by continuity equation */
    bool gradients;          /* density diffuses but for its gradients (solver/diffusion.h) */
    bool shifting;           /* particles drift towards emptier places */
    float closeness;         /* 1 / w(d), of shifting */
    bool wall_planes, wall_particles;
    struct pair_constants pair;
    struct explicit_constants each;
    struct tension_constants tension;
    struct external_constants external;
    double ripple;           /* viscous pressure per speed that ripples of tension need, Pa s/m */
    bool starts_rate;        /* no force pass: the external pass begins with gravity */
    double pull;             /* largest expected acceleration by the central force, m/s^2 */
    bool enclosed;           /* bodies fill the domain: no free surface */
    bool is_implicit;        /* pressure by solving; particles move last in a step */
    bool projects;           /* by Poisson's equation (solver/projection.h) */
    struct implicit_constants implicit;
    struct projection_constants projection;
    struct solve_limits solves[SOLVE_COUNT]; /* by enum solve */
    bool implicit_viscosity; /* by solving, too; limits.viscous is then INFINITY */
    double viscous_step, other_step; /* the explicit viscous limit and the least other, s */
    bool form_asked;         /* the scene names the operator of viscosity (PAIR_CENTRAL) */
};

struct solver_row {
    struct variant variant;
    const char *kernel;         /* of "auto" */
    double cfl;                 /* C1 of "auto" */
    double support;             /* support radius / spacing of "auto"; 0: the kernel's */
    const enum pass_id *passes; /* of one step, in order; the plan leaves out what is not wanted */
    size_t pass_count;
    /* Fills flags and the constants that are the solver's own; common ones are set before. */
    void (*choose)(const struct scene *scene, struct solver_choice *choice);
};

extern const struct variant_table solver_table; /* "solvers" */
extern const struct solver_row solver_isph, solver_dfsph, solver_wcsph, solver_muller;

/* Everything that follows from the scene and its solver. `cell_volume` of each body, m^3, and the
 * number of particles of each fluid give the particle masses. */
void solver_choose(const struct solver_row *solver, const struct scene *scene,
                   const struct space *space, const double *fluid_volume,
                   const size_t *fluid_particles, struct solver_choice *choice);

/* Bytes that a neighbour takes in a row: its index and, with a projection, its weight. */
static inline int solver_row_bytes(const struct solver_choice *choice)
{
    return choice->projects ? 8 : 4;
}

/* Viscosity of implicit solvers: explicit, or solved for where that would bound the step. Their keys
 * of it (scene/key.h). */
#define VISCOSITY_KEYS \
    {.path = "solver.viscosity", .type = KEY_CHOICE, .fallback = "\"auto\"", \
     .choices = "auto|explicit|implicit", .unit = "", .offset = KEY_OPTION, \
     .doc = "viscosity by the force pass, or by solving where that would bound the step"}, \
    {.path = "solver.viscosity_error", .type = KEY_REAL, .flags = KEY_ABOVE_MIN, \
     .fallback = "1e-4", .min = 0, .max = 0.1, .unit = "", .offset = KEY_OPTION, \
     .doc = "residual of implicit viscosity, relative to the velocity and to its change"}, \
    {.path = "solver.viscosity_form", .type = KEY_CHOICE, .fallback = "\"auto\"", \
     .choices = "auto|morris|weiler", .unit = "", .offset = KEY_OPTION, \
     .doc = "weiler: along the line of centres, free of stress at a surface; morris: a Laplacian, " \
            "right where fluid is enclosed"}

/* What stops particles at obstacles; they are made of wall particles. */
void obstacles_choose(const struct scene *scene, const struct space *space, struct solver_choice *choice);

void viscosity_choose(const struct scene *scene, struct solver_choice *choice);

/* The part that optional accelerations have in it; each also bounds the step and raises the
 * expected speed. */
enum { VISCOSITY_STEPS = 8 }; /* that explicit viscosity may take for one of an implicit solver */
void tension_choose(const struct scene *scene, struct solver_choice *choice);
void external_choose(const struct scene *scene, const struct space *space,
                     const double *fluid_volume, struct solver_choice *choice);

/* Sum over the depth of a plane surface on the lattice of what tension takes for |grad c|
 * (solver/tension.h), for a support in spacings. */
double tension_plane(double support);

/* Mass of all fluids over their volume, kg/m^3. */
double external_mean_density(const struct scene *scene, const double *fluid_volume);

/* Chooses the pressure form for fluids that differ in rest density, if they do; it takes viscosity per
 * particle. */
void solver_mix(struct solver_choice *choice);

/* Makes the particles' density follow from the pressure they start with, by the inverse of the
 * equation of state, where density is a state (continuity); their masses stay. Negative pressure
 * becomes zero where the solver has none. STATUS_USAGE when a fluid is too soft for it. */
enum status solver_start(const struct solver_choice *choice, struct particles *particles,
                         struct error *e);

/* Support radius of the scene's kernel, m. */
double solver_support(const struct solver_row *solver, const struct scene *scene,
                      const struct kernel_row **kernel);

#endif
