/* The table of smoothing kernels, and what follows from any of them by summation. */
#include "solver/kernel.h"

#include <math.h>

static const struct variant *const rows[] = {
    &kernel_wendland_c2.variant,
    &kernel_cubic_spline.variant,
    &kernel_poly6.variant,
};

const struct variant_table kernel_table = {
    .name = "kernels",
    .doc = "smoothing kernels",
    .rows = rows,
    .count = sizeof rows / sizeof *rows,
};

double kernel_lattice_sum(const struct kernel_row *kernel, double support)
{
    double h = support / 2, sum = 0;
    int reach = (int)ceil(support);
    for (int z = -reach; z <= reach; z++)
        for (int y = -reach; y <= reach; y++)
            for (int x = -reach; x <= reach; x++) {
                double q = sqrt(x * x + y * y + z * z) / h;
                sum += q < 2 ? kernel->value(q) : 0;
            }
    return sum * kernel->sigma / (h * h * h);
}

double kernel_lattice_moment(const struct kernel_row *kernel, double support)
{
    double h = support / 2, sum = 0;
    int reach = (int)ceil(support);
    for (int z = -reach; z <= reach; z++)
        for (int y = -reach; y <= reach; y++)
            for (int x = -reach; x <= reach; x++) {
                double q = sqrt(x * x + y * y + z * z) / h;
                sum -= q > 0 && q < 2 ? x * x * kernel->slope(q) : 0;
            }
    return sum * kernel->sigma / (h * h * h * h * h);
}

double kernel_lattice_central(const struct kernel_row *kernel, double support)
{
    double h = support / 2, second = 0, fourth = 0;
    int reach = (int)ceil(support);
    for (int z = -reach; z <= reach; z++)
        for (int y = -reach; y <= reach; y++)
            for (int x = -reach; x <= reach; x++) {
                double q = sqrt(x * x + y * y + z * z) / h;
                double part = q > 0 && q < 2 ? x * x * kernel->slope(q) : 0;
                second += part;
                fourth += part * q * q;
            }
    return 5 * second / fourth;
}

double kernel_lattice_slope(const struct kernel_row *kernel, double support)
{
    double h = support / 2, sum = 0;
    int reach = (int)ceil(support);
    for (int z = -reach; z <= reach; z++)
        for (int y = -reach; y <= reach; y++)
            for (int x = -reach; x <= reach; x++) {
                double q = sqrt(x * x + y * y + z * z) / h;
                sum += q > 0 && q < 2 ? kernel->slope(q) : 0;
            }
    return sum;
}

/* At wave number k the operator sum V^2 (grad W . )^2 has the symbol |sum grad W sin(k.r)|^2; its
 * diagonal is sum |grad W|^2. */
double kernel_jacobi_radius(const struct kernel_row *kernel, double support)
{
    enum { REACH_MAX = 6, WAVES = 24 };
    double h = support / 2, diagonal = 0, most = 0;
    double slope[REACH_MAX + 1][REACH_MAX + 1][REACH_MAX + 1]; /* W'/r of the octant */
    int reach = (int)ceil(support);
    reach = reach > REACH_MAX ? REACH_MAX : reach;
    for (int z = 0; z <= reach; z++)
        for (int y = 0; y <= reach; y++)
            for (int x = 0; x <= reach; x++) {
                double r = sqrt(x * x + y * y + z * z), q = r / h;
                slope[z][y][x] = r > 0 && q < 2 ? kernel->slope(q) : 0;
                int images = (x ? 2 : 1) * (y ? 2 : 1) * (z ? 2 : 1);
                diagonal += images * slope[z][y][x] * slope[z][y][x] * r * r;
            }
    for (int k = 0; k < WAVES * WAVES * WAVES; k++) {
        double wave[3] = {k % WAVES, k / WAVES % WAVES, k / (WAVES * WAVES)}, g[3] = {0};
        for (int a = 0; a < 3; a++)
            wave[a] *= 3.14159265358979323846 / (WAVES - 1);
        if (wave[0] < wave[1] || wave[1] < wave[2]) /* the others by symmetry */
            continue;
        for (int z = 0; z <= reach; z++)
            for (int y = 0; y <= reach; y++)
                for (int x = 0; x <= reach; x++) {
                    double cx = (x ? 2 : 1) * cos(wave[0] * x), cy = (y ? 2 : 1) * cos(wave[1] * y);
                    double cz = (z ? 2 : 1) * cos(wave[2] * z), s = slope[z][y][x];
                    g[0] += s * x * 2 * sin(wave[0] * x) * cy * cz;
                    g[1] += s * y * 2 * sin(wave[1] * y) * cx * cz;
                    g[2] += s * z * 2 * sin(wave[2] * z) * cx * cy;
                }
        most = fmax(most, g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    }
    return most / diagonal;
}

int kernel_lattice_neighbours(double support)
{
    int reach = (int)ceil(support), n = 0;
    for (int z = -reach; z <= reach; z++)
        for (int y = -reach; y <= reach; y++)
            for (int x = -reach; x <= reach; x++)
                n += x * x + y * y + z * z < support * support;
    return n - 1;
}

/* Behind the plane stand layers of depth d, each as thick sheets of fluid on the lattice at
 * distances s + d/2, s + 3d/2, ...; scaled as masses are. */
static void layer_table(const struct kernel_row *kernel, double support, struct plane_table *table)
{
    enum { FINE = 8192, LAYERS_MAX = 16 };
    static const double pi = 3.14159265358979323846;
    double h = support / 2, scale = 1 / (h * kernel_lattice_sum(kernel, support)); /* d/h V */
    static double sheet[FINE + 1]; /* integral of W over a plane at q = 2 k / FINE, times h */
    sheet[FINE] = 0;
    for (int k = FINE - 1; k >= 0; k--) {
        double q = (k + 0.5) * 2 / FINE;
        sheet[k] = sheet[k + 1] + 2 * pi * kernel->sigma * kernel->value(q) * q * 2 / FINE;
    }
    for (int k = 0; k <= PLANE_STEPS; k++) {
        double volume = 0, area = 0;
        for (int layer = 0; layer < LAYERS_MAX; layer++) {
            double q = 2.0 * k / PLANE_STEPS + (layer + 0.5) / h, at = q * FINE / 2;
            if (q >= 2)
                break;
            int low = (int)at;
            volume += scale * (sheet[low] + (at - low) * (sheet[low + 1] - sheet[low]));
            area += scale * 2 * pi * kernel->sigma * kernel->value(q) * q;
        }
        table->volume[k] = (float)volume;
        table->area[k] = (float)area;
    }
}

/* Over a sheet at depth z the integral of -W'/r is 2 pi W(z), and that of -W'/r x^2 is 2 pi times the
 * integral of r W from z on. That of -W'/r z^2, across the plane, is not taken: it reaches so far that a
 * wall would hold off a thick body that only comes near, and without any drag it would sink in. */
void kernel_plane_drag(const struct kernel_row *kernel, bool central, struct plane_table *table)
{
    enum { FINE = 16, STEPS = PLANE_STEPS * FINE }; /* midpoints, from the edge of the support inwards */
    const double fine = 2.0 / STEPS, scale = 2 * 3.14159265358979323846 * kernel->sigma * fine;
    double drag[2] = {0}, lever[2] = {0}, beyond = 0, second = 0, fourth = 0;
    for (int k = 0; k < STEPS; k++) {
        double q = (k + 0.5) * fine, part = kernel->value(q) * q * q;
        second += part;
        fourth += part * q * q;
    }
    for (int k = STEPS - 1; k >= 0; k--) {
        double q = (k + 0.5) * fine, w = kernel->value(q), five = 3 * second / fourth;
        double along = beyond + w * q * fine / 2;
        beyond += w * q * fine;
        for (int a = 0; a < 2; a++) {
            double part = scale * (central && a == 0 ? five * along : w);
            lever[a] += (drag[a] + part / 2) * fine;
            drag[a] += part;
            if (k % FINE == 0) {
                table->drag[a][k / FINE] = (float)drag[a];
                table->lever[a][k / FINE] = (float)lever[a];
            }
        }
    }
}

void kernel_plane_table(const struct kernel_row *kernel, double support, struct plane_table *table)
{
    *table = (struct plane_table){0};
    kernel_plane_drag(kernel, false, table);
    layer_table(kernel, support, table);
}

double kernel_plane_excess(const struct kernel_row *kernel, double support,
                           const struct plane_table *table)
{
    double h = support / 2, whole = kernel_lattice_sum(kernel, support), most = 0;
    int reach = (int)ceil(support);
    for (int layer = 0; layer < reach; layer++) {
        double at = (layer + 0.5) / h * PLANE_STEPS / 2, sum = 0;
        int k = (int)at;
        double behind = k < PLANE_STEPS ? table->volume[k] +
                            (at - k) * (table->volume[k + 1] - table->volume[k]) : 0;
        for (int z = -layer; z <= reach; z++)
            for (int y = -reach; y <= reach; y++)
                for (int x = -reach; x <= reach; x++) {
                    double q = sqrt(x * x + y * y + z * z) / h;
                    sum += q < 2 ? kernel->sigma / (h * h * h) * kernel->value(q) : 0;
                }
        most = fmax(most, sum / whole + behind - 1);
    }
    return most;
}
