/* Tests the smoothing kernels: normalisation, slopes, lattice sums, half-space integrals. */
#include "backend/cpu/lanes_scalar.h"

#include "solver/kernel.h"
#include "solver/kernels/bodies.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#define PI 3.14159265358979323846

static const struct kernel_row *const kernels[] = {&kernel_wendland_c2, &kernel_cubic_spline,
                                                   &kernel_poly6};
enum { KERNELS = 3 };

/* Simpson's rule for f(context, x) over n (even) intervals. */
static double integrate(double (*f)(const void *, double), const void *context, double low,
                        double high, int n)
{
    double step = (high - low) / n, sum = f(context, low) + f(context, high);
    for (int k = 1; k < n; k++)
        sum += f(context, low + k * step) * (k % 2 ? 4 : 2);
    return sum * step / 3;
}

/* w(q), w'(q)/q and h^2 of its Laplacian as the pair passes evaluate them. */
static double body_value(const struct kernel_row *k, double q)
{
    float x = (float)q;
    return k == &kernel_poly6 ? poly6_value(x * x) : k->flag & KERNEL_CUBIC ? cubic_value(x)
                                                                            : wendland_value(x);
}
static double body_slope(const struct kernel_row *k, double q)
{
    float x = (float)q, inverse = q > 0 ? 1 / x : 1e19f;
    return k == &kernel_poly6 ? spiky_slope(x, inverse)
           : k->flag & KERNEL_CUBIC ? cubic_slope(x, inverse)
                                    : wendland_slope(x);
}

static double shell(const void *k, double q)
{
    return 4 * PI * q * q * ((const struct kernel_row *)k)->value(q);
}
/* The integral of W is minus a third of that of x . grad W, also for spiky's slope over poly6's
 * sigma: this is what makes gradients of linear functions exact. */
static double slope_shell(const void *k, double q)
{
    return -4 * PI / 3 * q * q * q * q * body_slope(k, q);
}
/* and a sixth of that of r^2 lap W. */
static double laplacian_shell(const void *k, double q)
{
    (void)k;
    return 4 * PI / 6 * q * q * q * q * viscosity_laplacian((float)q);
}

static void integrates_to_one(void **state)
{
    (void)state;
    for (int k = 0; k < KERNELS; k++) {
        double whole = kernels[k]->sigma * integrate(shell, kernels[k], 0, 2, 2000);
        double slope = kernels[k]->sigma * integrate(slope_shell, kernels[k], 1e-9, 2, 2000);
        if (!(fabs(whole - 1) < 1e-9 && fabs(slope - 1) < 1e-6))
            fail_msg("%s: %.12f, by its slope %.9f", kernels[k]->variant.name, whole, slope);
    }
    double viscous = kernel_poly6.sigma * integrate(laplacian_shell, NULL, 0, 2, 2000);
    assert_true(fabs(viscous - 1) < 1e-6);
}

/* Values against the double version, slopes against finite differences of it. */
static void bodies_agree(void **state)
{
    (void)state;
    for (int k = 0; k < KERNELS; k++)
        for (double q = 0.005; q < 2.5; q += 0.00497) {
            double exact = q < 2 ? kernels[k]->value(q) : 0, e = 1e-5;
            double rise = q < 2 - e ? kernels[k]->value(q + e) - kernels[k]->value(q - e) : 0;
            if (!(fabs(body_value(kernels[k], q) - exact) < 4e-7))
                fail_msg("%s: value at %g", kernels[k]->variant.name, q);
            if (k < 2 && !(fabs(body_slope(kernels[k], q) * q - rise / (2 * e)) < 1e-5))
                fail_msg("%s: slope at %g", kernels[k]->variant.name, q);
        }
}

static void ends_at_two(void **state)
{
    static const float far[] = {2, 2.0000002f, 2.5f, 16, 1e6f};
    (void)state;
    for (size_t i = 0; i < sizeof far / sizeof *far; i++) {
        for (int k = 0; k < KERNELS; k++) {
            assert_true(body_value(kernels[k], far[i]) == 0);
            assert_true(body_slope(kernels[k], far[i]) == 0);
        }
        assert_true(viscosity_laplacian(far[i]) == 0);
    }
    for (int k = 0; k < KERNELS; k++) {
        assert_true(body_value(kernels[k], 0) == 1); /* what pair_constants.self says */
        assert_true(isfinite(body_slope(kernels[k], 0)));
    }
}

/* numerics: the sums that calibrate particle mass, from independent computation. */
static void sums_lattices(void **state)
{
    static const struct { const struct kernel_row *kernel; double h, sum; } known[] = {
        {&kernel_cubic_spline, 1.0, 1.0000}, {&kernel_cubic_spline, 1.2, 1.0008},
        {&kernel_wendland_c2, 1.3, 1.0095},  {&kernel_wendland_c2, 1.5, 1.0031},
        {&kernel_wendland_c2, 2.0, 1.0005},
    };
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        double sum = kernel_lattice_sum(known[i].kernel, 2 * known[i].h);
        if (!(fabs(sum - known[i].sum) < 0.51e-4))
            fail_msg("%s h = %g d: %.6f", known[i].kernel->variant.name, known[i].h, sum);
    }
    assert_int_equal(kernel_lattice_neighbours(2), 26);
    assert_int_equal(kernel_lattice_neighbours(2.6), 80);
    assert_int_equal(kernel_lattice_neighbours(1), 0);
}

/* Half-space integrals in cylinder coordinates, straight from their definitions. */
struct plane {
    const struct kernel_row *kernel;
    double distance, depth; /* of the plane, and of the disc from the particle */
};

static double disc_value(const void *context, double r)
{
    const struct plane *p = context;
    double q = hypot(p->depth, r);
    return q < 2 ? 2 * PI * r * p->kernel->sigma * p->kernel->value(q) : 0;
}
static double disc_slope(const void *context, double r)
{
    const struct plane *p = context;
    double q = hypot(p->depth, r), e = 1e-5;
    if (q > 2 - e || q < e)
        return 0;
    double rise = (p->kernel->value(q + e) - p->kernel->value(q - e)) / (2 * e);
    return -2 * PI * r * p->kernel->sigma * rise / q;
}
static double disc(const struct plane *p, double depth, double (*f)(const void *, double))
{
    struct plane at = *p;
    at.depth = depth;
    return depth < 2 ? integrate(f, &at, 0, sqrt(4 - depth * depth), 400) : 0;
}
static double area(const void *p, double depth)
{
    return disc(p, depth, disc_value);
}
static double drag(const void *p, double depth)
{
    return disc(p, depth, disc_slope);
}
static double lever(const void *p, double depth)
{
    return (depth - ((const struct plane *)p)->distance) * drag(p, depth);
}

/* The same times 5 c x^2, for pairs that drag along the line of centres. */
static double fourth_shell(const void *k, double q)
{
    return 5.0 / 3 * q * q * shell(k, q);
}
static double central(const struct plane *p)
{
    return 5 / (p->kernel->sigma * integrate(fourth_shell, p->kernel, 0, 2, 400));
}
static double disc_along(const void *p, double r)
{
    return r * r / 2 * disc_slope(p, r);
}
static double central_along(const void *p, double depth)
{
    return central(p) * disc(p, depth, disc_along);
}

static void measures_central_drag(void **state)
{
    static struct plane_table table;
    (void)state;
    for (int k = 0; k < 2; k++) {
        kernel_plane_drag(kernels[k], true, &table);
        for (int step = 0; step <= PLANE_STEPS; step += 64) {
            double s = 2.0 * step / PLANE_STEPS;
            struct plane plane = {kernels[k], s, s};
            double error[2] = {table.drag[0][step] - integrate(central_along, &plane, s, 2, 200),
                               table.drag[1][step] - integrate(drag, &plane, s, 2, 200)};
            for (int i = 0; i < 2; i++)
                if (!(fabs(error[i]) < 2e-4))
                    fail_msg("%s, axis %d at %g is off by %g", kernels[k]->variant.name, i, s, error[i]);
        }
    }
}

/* Resistance of the lattice to shear along its axes, of Morris's operator's. */
static double shear(const struct kernel_row *kernel, double support)
{
    double h = support / 2, sum = 0, laplacian = 0;
    int reach = (int)ceil(support);
    for (int z = -reach; z <= reach; z++)
        for (int y = -reach; y <= reach; y++)
            for (int x = -reach; x <= reach; x++) {
                double q = sqrt(x * x + y * y + z * z) / h;
                double slope = q > 0 && q < 2 ? kernel->slope(q) : 0;
                sum += slope * x * x * y * y / (h * h);
                laplacian += slope * x * x;
            }
    return kernel_lattice_central(kernel, support) * sum / laplacian;
}

static void shears_lattices(void **state)
{
    (void)state;
    assert_true(fabs(shear(&kernel_cubic_spline, 2) - 0.947) < 1e-3);
    for (int k = 0; k < 2; k++)
        for (double support = 2.3; support < 3.5; support += 0.1)
            assert_true(fabs(shear(kernels[k], support) - 1) < 0.03);
}

static void measures_half_spaces(void **state)
{
    static struct plane_table table;
    (void)state;
    for (int k = 0; k < KERNELS; k++) {
        kernel_plane_table(kernels[k], 2.6, &table);
        for (int step = 0; step <= PLANE_STEPS; step += 32) {
            double s = 2.0 * step / PLANE_STEPS;
            struct plane plane = {kernels[k], s, s};
            double error[2] = {table.drag[0][step] - integrate(drag, &plane, s, 2, 400),
                               table.lever[0][step] - integrate(lever, &plane, s, 2, 400)};
            for (int i = 0; i < 2; i++)
                if (!(fabs(error[i]) < 1e-4))
                    fail_msg("%s, integral %d at %g is off by %g", kernels[k]->variant.name, i, s,
                             error[i]);
        }
        assert_true(table.area[PLANE_STEPS + 1] == 0 && table.volume[PLANE_STEPS + 1] == 0);
    }
}

/* Layers behind the plane: the sum of sheets at s + d/2, s + 3d/2, ...; area is minus its slope, and a
 * lattice that ends half a spacing before the plane has nearly its full density there. */
static void measures_layers(void **state)
{
    static struct plane_table table;
    (void)state;
    for (int k = 0; k < KERNELS; k++)
        for (double support = 2; support < 3.6; support += 0.5) {
            double h = support / 2, scale = 1 / (h * kernel_lattice_sum(kernels[k], support));
            kernel_plane_table(kernels[k], support, &table);
            for (int step = 16; step <= PLANE_STEPS - 16; step += 32) {
                double s = 2.0 * step / PLANE_STEPS, sum = 0;
                struct plane plane = {kernels[k], s, s};
                for (double at = s + 0.5 / h; at < 2; at += 1 / h)
                    sum += scale * area(&plane, at);
                double slope = -(table.volume[step + 1] - table.volume[step - 1]) * PLANE_STEPS / 4.0;
                assert_true(fabs(table.volume[step] - sum) < 1e-4);
                assert_true(fabs(table.area[step] - slope) < 2e-3);
            }
        }
    kernel_plane_table(&kernel_cubic_spline, 2, &table);
    int half = (int)(PLANE_STEPS / 2 * 0.5); /* s = d/2, h = d */
    double fluid = 0; /* of the lattice layers 0, -1 of a particle in layer 0 */
    for (int z = -1; z <= 0; z++)
        for (int y = -1; y <= 1; y++)
            for (int x = -1; x <= 1; x++)
                fluid += kernel_cubic_spline.value(sqrt(x * x + y * y + z * z)) / PI;
    assert_true(fabs(fluid + table.volume[half] - 1) < 4e-3);
}

/* Gradients of linear fields on the lattice, and the known windows of Jacobi sweeps (computed for
 * the 3-D lattice: mu of the cubic spline and Wendland C2 at h/d = 1, 1.2, 1.3, 1.5, 2). */
static void knows_lattices(void **state)
{
    static const double ratio[] = {1, 1.2, 1.3, 1.5, 2};
    static const double cubic[] = {2.814, 3.943, 4.906, 7.451, 17.601};
    static const double wendland[] = {2.605, 3.531, 4.198, 6.237, 14.302};
    (void)state;
    for (int i = 0; i < 5; i++) {
        double a = kernel_jacobi_radius(&kernel_cubic_spline, 2 * ratio[i]);
        double b = kernel_jacobi_radius(&kernel_wendland_c2, 2 * ratio[i]);
        if (fabs(a / cubic[i] - 1) > 0.02 || fabs(b / wendland[i] - 1) > 0.02)
            fail_msg("h/d %g: mu %g and %g", ratio[i], a, b);
    }
    assert_true(fabs(kernel_lattice_moment(&kernel_cubic_spline, 2) - 1.0201) < 1e-3);
    assert_true(fabs(kernel_lattice_moment(&kernel_wendland_c2, 8) - 1) < 1e-3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(integrates_to_one), cmocka_unit_test(bodies_agree),
        cmocka_unit_test(ends_at_two),       cmocka_unit_test(sums_lattices),
        cmocka_unit_test(measures_half_spaces), cmocka_unit_test(measures_central_drag),
        cmocka_unit_test(shears_lattices),  cmocka_unit_test(measures_layers),
        cmocka_unit_test(knows_lattices),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
