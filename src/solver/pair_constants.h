/* Flags that specialise the pair passes, and the constants they multiply by. */
#ifndef SOLVER_PAIR_CONSTANTS_H
#define SOLVER_PAIR_CONSTANTS_H

#define KERNEL_CUBIC 1u /* otherwise Wendland C2 (solver/kernels/bodies.h) */

/* Bit 0 is the kernel's. */
enum pair_flag {
    PAIR_MULLER = 2,         /* kernels of Mueller 2003 */
    PAIR_VISCOUS = 4,        /* all fluids share one dynamic viscosity */
    PAIR_OWN_VISCOSITY = 8,  /* fluids differ in it */
    PAIR_ARTIFICIAL = 16,
    PAIR_CONTINUITY = 32,    /* density by continuity, otherwise by summation */
    PAIR_DIFFUSION = 64,     /* delta-SPH; only with continuity */
    PAIR_SYMMETRIC = 128,    /* pressure form V_i^2 p_i + V_j^2 p_j */
    PAIR_DRAG_ONLY = 256,    /* no pressure: an implicit solver pushes */
    PAIR_MIXED = 512,        /* average form where rest densities differ; with own viscosities */
    PAIR_CENTRAL = 1024,     /* viscosity along the line of centres */
    PAIR_FLAGS_END = 2048
};

/* Chosen once by the plan. */
struct pair_constants {
    float scale[3];     /* counts to smoothing lengths, per axis */
    float gradient;     /* sigma d^3 / h^4, 1/m: grad W = gradient / d^3 * slope * (x_i - x_j)/h */
    float density;      /* sigma d^3 / h^3: sum W = density / d^3 * sum w */
    float self;         /* w(0) */
    float viscosity;    /* 2 mu / h, Pa s/m */
    float inverse_h;    /* 1/m */
    float central;      /* of viscosity along the line of centres (kernel_lattice_central) */
    float artificial;   /* alpha c0 rho0, Pa s/m; with PAIR_MIXED alpha c0, m/s */
    float diffusion;    /* 2 delta / c0, s/m */
    float head[3];      /* g h, m^2/s^2: times rest density, the hydrostatic difference per q;
                           0 along periodic axes */
    float gravity[3];   /* m/s^2 */
};

/* Floating-point operations of the force pass per pair, a fused multiply-add counting two. */
double pair_force_flops(unsigned flags);

#endif
