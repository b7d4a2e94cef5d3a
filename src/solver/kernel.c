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

int kernel_lattice_neighbours(double support)
{
    int reach = (int)ceil(support), n = 0;
    for (int z = -reach; z <= reach; z++)
        for (int y = -reach; y <= reach; y++)
            for (int x = -reach; x <= reach; x++)
                n += x * x + y * y + z * z < support * support;
    return n - 1;
}

void kernel_plane_table(const struct kernel_row *kernel, struct plane_table *table)
{
    enum { FINE = 16 }; /* midpoint steps per table entry, from the edge of the support inwards */
    const double pi = 3.14159265358979323846, fine = 2.0 / PLANE_STEPS / FINE;
    double area = 0, volume = 0, drag = 0, lever = 0;
    *table = (struct plane_table){0};
    for (int k = PLANE_STEPS * FINE - 1; k >= 0; k--) {
        double q = (k + 0.5) * fine, w = 2 * pi * kernel->sigma * kernel->value(q) * fine;
        volume += (area + w * q / 2) * fine;
        area += w * q;
        lever += (drag + w / 2) * fine;
        drag += w;
        if (k % FINE == 0) {
            table->area[k / FINE] = (float)area;
            table->volume[k / FINE] = (float)volume;
            table->drag[k / FINE] = (float)drag;
            table->lever[k / FINE] = (float)lever;
        }
    }
}
