/* Float planes of pictures, and filters that are products of a row and a column kernel. */
#ifndef COMPARE_PLANE_H
#define COMPARE_PLANE_H

#include "base/error.h"

enum { KERNEL_RADIUS_MAX = 24 };

/* Weights of the offsets -radius .. radius, in that order. */
struct kernel {
    int radius;
    double sum; /* of the samples before they were divided by it */
    float weight[2 * KERNEL_RADIUS_MAX + 1];
};

/* exp(-x^2 / (2 sigma^2)) in pixels, divided by its sum; radius at most KERNEL_RADIUS_MAX. */
struct kernel kernel_gaussian(double sigma, int radius);

/* height rows of width floats, no padding. NULL with STATUS_RUN when memory is short; memory_free. */
float *plane_create(int width, int height, struct error *e);

/* out = in filtered along rows, or along columns; beyond the edge the last pixel is repeated. Each
 * sum is from the smallest offset up, so the bits do not depend on vectors or threads. out != in. */
void plane_rows(float *out, const float *in, int width, int height, const struct kernel *kernel);
void plane_columns(float *out, const float *in, int width, int height,
                   const struct kernel *kernel);

#endif
