/* Exact solutions of the validation cases. SI units. */
#ifndef STUDY_EXACT_H
#define STUDY_EXACT_H

/* Channels that start from rest (Morris, Fox & Zhu, J. Comput. Phys. 136 (1997) 214-226): velocity,
 * m/s, at y above the lower wall, t after the start; kinematic viscosity nu, m^2/s. */

/* Between walls at rest; force per mass, m/s^2. */
double exact_poiseuille(double y, double t, double nu, double force, double width);

/* Below a wall that moves with that velocity, m/s. */
double exact_couette(double y, double t, double nu, double wall, double width);

/* Rate at which velocity decays, 1/s, of vortices of that period, m. */
double exact_taylor_green_rate(double nu, double length); /* Taylor & Green 1937: 2 nu k^2 */
double exact_beltrami_rate(double nu, double length);     /* ABC flow, curl u = k u: nu k^2 */

/* A drop that is an ellipse of semi-axes a along x and b along y, m, with velocity sigma (-x, y),
 * sigma in 1/s. */
struct exact_ellipse {
    double axes[2], sigma;
};

/* Round at first, without force (Monaghan, J. Comput. Phys. 110 (1994) 399-406):
 * a' = -sigma a, b' = sigma b, sigma' = sigma^2 (a^4 - R^4) / (a^4 + R^4). */
struct exact_ellipse exact_ellipse(double t, double sigma, double radius);

/* The same under the force -omega^2 (x, y) per mass (Monaghan & Rafiee, Int. J. Numer. Methods
 * Fluids 71 (2013) 537-561): sigma' = (sigma^2 + omega^2) (a^2 - b^2) / (a^2 + b^2). */
struct exact_ellipse exact_oscillating_drop(double t, double sigma, double omega, double radius);

/* s; sigma changes its sign a quarter of it after the start. */
double exact_oscillating_drop_period(double sigma, double omega);

/* x / a beyond which that part of an ellipse's area lies. */
double exact_ellipse_reach(double part);

/* A sphere's second mode by surface tension (Rayleigh, Proc. R. Soc. 29 (1879) 71-97; Lamb,
 * Hydrodynamics, arts. 275 and 355): angular frequency, rad/s, and small damping, 1/s. */
double exact_capillary_frequency(double tension, double density, double radius);
double exact_capillary_damping(double nu, double radius);

/* A small standing wave. */
struct exact_wave {
    double frequency, damping; /* rad/s, 1/s of the amplitude */
};

/* Potential flow: omega^2 = g k tanh kH, and its damping by viscosity 2 nu k^2 (Lamb, art. 348). */
struct exact_wave exact_wave(double depth, double length, double nu, double g);

/* The root s = -damping + i frequency of
 * (s + 2 nu k^2)^2 + omega^2 = 4 nu^2 k^4 sqrt(1 + s / (nu k^2))
 * (Lamb, art. 349, of deep water, with omega of that depth). Its right side counts the vorticity
 * below the surface. */
struct exact_wave exact_viscous_wave(double depth, double length, double nu, double g);

#endif
