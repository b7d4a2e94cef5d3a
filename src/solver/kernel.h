/* Smoothing kernels: W(r) = sigma / h^3 w(q), q = r/h, h the smoothing length; zero from q = 2 on,
 * so the support radius is 2h for all of them. */
#ifndef SOLVER_KERNEL_H
#define SOLVER_KERNEL_H

#include "base/variant.h"

#include <stdbool.h>

struct kernel_row {
    struct variant variant;
    double support;           /* usual support radius / particle spacing */
    double sigma;             /* normalization in 3-D */
    double (*value)(double q); /* w(q) */
    double (*slope)(double q); /* w'(q)/q of what forces use, q > 0 */
    unsigned flag;            /* bit that selects its body in the pair passes */
};

extern const struct variant_table kernel_table; /* "kernels" */
extern const struct kernel_row kernel_cubic_spline, kernel_wendland_c2, kernel_poly6;

/* S = d^3 sum W over the cubic lattice of spacing d, for support radius `support` * d. A particle of
 * mass rho0 d^3 / S on the lattice has density rho0 exactly, so volume is right from the start. */
double kernel_lattice_sum(const struct kernel_row *kernel, double support);

/* First moment of the lattice, M = -d^3 sum x^2 W'/r: a linear field has the gradient M times what it
 * should be, and a parabola M times its Laplacian, so gradients are divided by it. */
double kernel_lattice_moment(const struct kernel_row *kernel, double support);

/* What makes viscosity along the line of centres, with pairs that count q^2 times, as large as Morris's
 * on the lattice, in the mean over all directions: 5 sum x^2 W'/r / sum x^2 q^2 W'/r. Its resistance to
 * shear along the axes is then within 3 % of that from 2.3 d on, 5 % too low at 2 d (cubic spline). */
double kernel_lattice_central(const struct kernel_row *kernel, double support);

/* Sum of w'(q)/q over the lattice without its origin. */
double kernel_lattice_slope(const struct kernel_row *kernel, double support);

/* Largest eigenvalue mu of D^-1 A of the pressure operator on the cubic lattice: Jacobi sweeps
 * contract for a relaxation below 2 / mu (shared by all implicit solvers). */
double kernel_jacobi_radius(const struct kernel_row *kernel, double support);

/* Neighbours within `support` * d on the cubic lattice, without the particle itself. */
int kernel_lattice_neighbours(double support);

/* Integrals of the kernel over the half space behind a plane at distance s = q h, for closed walls,
 * in units of h; all zero from q = 2 on. With z' the depth behind the plane:
 *   area   = integral of W over the plane, so the half space's gradient is -area/h n
 *   volume = integral of W behind the plane; 1/2 at q = 0
 *   drag   = -integral of W'/r behind it       = 2 pi integral_s^2h W dz, over h^2
 *   lever  = -integral of z' W'/r behind it    = 2 pi integral_s^2h (z - s) W dz, over h */
enum { PLANE_STEPS = 512 };
struct plane_table {
    float area[PLANE_STEPS + 2], volume[PLANE_STEPS + 2]; /* at q = 2 k / PLANE_STEPS */
    float drag[2][PLANE_STEPS + 2], lever[2][PLANE_STEPS + 2]; /* along the plane and across it */
};
/* Largest excess of the summed density of a lattice that stands half a spacing off a plane of the
 * table, relative: layers behind the plane are smooth, those in front are points. */
double kernel_plane_excess(const struct kernel_row *kernel, double support,
                           const struct plane_table *table);
void kernel_plane_table(const struct kernel_row *kernel, double support, struct plane_table *table);

/* Drag and lever anew for viscosity along the line of centres (kernel_lattice_central): along the plane
 * W'/r times 5 c x^2, c = integral of w q^2 / (5/3 integral of w q^4). Across it, and without `central`
 * along it, times 1, as kernel_plane_table makes them. */
void kernel_plane_drag(const struct kernel_row *kernel, bool central, struct plane_table *table);

#endif
