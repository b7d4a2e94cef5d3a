/* State of the cpu back end, shared by its files. */
#ifndef BACKEND_CPU_CPU_H
#define BACKEND_CPU_CPU_H

#include "backend/backend.h"
#include "backend/cpu/isa.h"
#include "backend/cpu/rows.h"

struct backend {
    struct solver_choice choice;
    struct space space;
    const struct search_row *search;
    const struct isa_row *isa;
    int threads;
    struct particles particles, wall;
    struct cells cells, wall_cells;
    struct rows rows, wall_rows;
    uint32_t *order, *scratch;       /* particle indices */
    uint32_t *axis[3], *wall_axis[3];/* coordinates by axis, for the row build */
    void *spare;                     /* one field's worth of particles, for permuting */
    float *number;                   /* sum w; only with density by summation */
    float *inverse_density;          /* 1 / rest density; only with an implicit solver and fluids
                                        that differ in it */
    float *fluid;                    /* index; only with surface tension and several fluids */
    float *rest;                     /* rest densities; only with PAIR_MIXED */
    int64_t *residual;               /* of each block; only with an implicit solver */
    struct {
        double product; /* of the residual with itself, preconditioned, J/m^3 */
        double scale2;  /* what residuals are relative to */
    } drag;                          /* of the present solve of viscosity */
    double descent;                  /* residual . residual / diagonal, of the projection's solves */
    pair_function *density, *force;
    struct backend_counts counts;
    char text[128];
};

/* Sorts particles for rows of radius `radius` (m), and makes their coordinates by axis. */
enum status cpu_sort(struct backend *b, struct particles *p, struct cells *cells,
                     uint32_t *const axis[3], double radius, struct error *e);

/* What a build of the particles' rows reads; `radius` in m. */
struct row_build cpu_row_build(const struct backend *b, double radius);

/* Vorticity of the present state, from neighbours within `radius` (m); leaves the rest as it is. */
enum status cpu_curl(struct backend *b, double radius, struct error *e);

/* Moves particles apart whose distance squared is below `near`, in smoothing lengths, by their rows. */
void cpu_part(struct backend *b, float near);

/* The passes over particles. */
void cpu_predict(struct backend *b, struct step *step);
void cpu_correct(struct backend *b, struct step *step);
void cpu_pressure(struct backend *b);
void cpu_walls(struct backend *b);
void cpu_pairs(struct backend *b, pair_function *pass);
void cpu_shift(struct backend *b);
void cpu_kick(struct backend *b, struct step *step);
void cpu_resume(struct backend *b, const struct step *step);
void cpu_move(struct backend *b, struct step *step);

/* Rest volumes of the particles. */
void cpu_solve_start(struct backend *b);

/* A pair pass of the implicit solver; a sweep sets step->residual. */
void cpu_solve(struct backend *b, struct step *step, enum pair_pass pass);

/* Adds to the rate, or begins it with gravity. */
void cpu_external(struct backend *b, const struct step *step);

/* The pair passes of density diffusion by gradients. */
void cpu_diffusion(struct backend *b, enum pair_pass pass);

/* The pair passes of surface tension. */
struct tension_work cpu_tension_work(const struct backend *b, float *pressure);
void cpu_tension(struct backend *b, enum pair_pass pass, float *pressure);

/* Conjugate gradients of implicit viscosity: what is around each product (solver/drag.h). */
void cpu_drag_begin(struct backend *b, const struct step *step);
void cpu_drag_residual(struct backend *b, struct step *step);
void cpu_drag_step(struct backend *b, struct step *step);
void cpu_drag_end(struct backend *b);

/* 1 / rest density, in the present order of the particles. */
void cpu_invert_densities(struct backend *b);

/* The projection solver: pair passes, and what is around them (solver/projection.h). */
void cpu_projection(struct backend *b, const struct step *step, enum pair_pass pass);
void cpu_rewind(struct backend *b, const struct step *step);
void cpu_advance(struct backend *b, const struct step *step);
void cpu_crowding(struct backend *b, const struct step *step);
void cpu_shifted(struct backend *b);
void cpu_residual(struct backend *b, struct step *step);
void cpu_descent(struct backend *b, struct step *step);
void cpu_drift(struct backend *b, struct step *step);

/* The positions that forces are evaluated at: an implicit solver moves particles last. */
const struct position *cpu_position(const struct backend *b);
struct pair_work cpu_pair_work(const struct backend *b);
void cpu_pair_blocks(struct backend *b, const struct pair_work *work, pair_function *pass);

/* Extremes over threads: none yet, and the larger of each. */
struct extremes extremes_none(void);
void extremes_merge(struct extremes *a, const struct extremes *b);

#endif
