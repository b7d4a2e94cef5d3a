/* Metric "flip": LDR-FLIP, the difference seen when two pictures alternate, mean and percentiles.
 *
 * Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom, Fairchild 2020, "FLIP: A Difference
 * Evaluator for Alternating Images": colours blurred as the eye does at a distance, their HyAB
 * distance in Hunt-adjusted CIELAB, raised where edges or points differ. */
#include "base/memory.h"
#include "compare/flip_color.h"
#include "compare/metric.h"
#include "compare/plane.h"

#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

/* A screen of 0.7 m and 3840 pixels, seen from 0.7 m (section 5): pixels per degree. */
#define PIXELS_PER_DEGREE (0.7 * 3840 / 0.7 * 3.14159265358979323846 / 180)

enum { SIDE_PLANES = 5, WORK_PLANES = 4 };

struct side {
    float *lab[3];
    float *edge, *point; /* strengths of features */
};

/* Contrast sensitivity of each opponent colour: a sqrt(pi/b) exp(-pi^2 z^2 / b), z in degrees, the sum
 * of two such for blue-yellow (table 1). */
static const struct {
    double a[2], b[2];
} sensitivity[3] = {
    {{1, 0}, {0.0047, 1e-5}}, {{1, 0}, {0.0053, 1e-5}}, {{34.1, 13.5}, {0.04, 0.025}}};

/* The radius is 3 sigma of the widest filter, 10 pixels; beyond 6 sigma a weight is below 1e-7. */
static struct kernel sensitivity_kernel(double b)
{
    double sigma = sqrt(b / 2) / pi * PIXELS_PER_DEGREE;
    double widest = sqrt(0.04 / 2) / pi * PIXELS_PER_DEGREE;
    return kernel_gaussian(sigma, (int)fmin(ceil(3 * widest), ceil(6 * sigma)));
}

/* One opponent colour as the eye sees it; work: two planes. */
static void blur(float *out, const float *in, int colour, float *const work[2], int w, int h)
{
    double part[2];
    for (int k = 0; k < 2 && sensitivity[colour].a[k] > 0; k++) {
        double a = sensitivity[colour].a[k], b = sensitivity[colour].b[k];
        struct kernel kernel = sensitivity_kernel(b);
        part[k] = a * sqrt(pi / b) * kernel.sum * kernel.sum;
        plane_rows(work[0], in, w, h, &kernel);
        plane_columns(k ? work[1] : out, work[0], w, h, &kernel);
    }
    if (sensitivity[colour].a[1] > 0) {
        float first = (float)(part[0] / (part[0] + part[1])), second = 1 - first;
        for (size_t i = 0; i < (size_t)w * (size_t)h; i++)
            out[i] = first * out[i] + second * work[1][i];
    }
}

/* Feature detectors of 0.082 degrees (section 4.2): Gaussian, its first and its second derivative;
 * of the latter two the positive weights add to 1 and the negative ones to -1. */
static void feature_kernels(struct kernel kernels[3])
{
    double sigma = 0.5 * 0.082 * PIXELS_PER_DEGREE;
    int radius = (int)ceil(3 * sigma);
    kernels[0] = kernel_gaussian(sigma, radius);
    for (int order = 1; order <= 2; order++) {
        double value[2 * KERNEL_RADIUS_MAX + 1], positive = 0, negative = 0;
        kernels[order].radius = radius;
        for (int i = 0; i <= 2 * radius; i++) {
            double x = i - radius, g = exp(-x * x / (2 * sigma * sigma));
            value[i] = order == 1 ? -x * g : (x * x / (sigma * sigma) - 1) * g;
            *(value[i] > 0 ? &positive : &negative) += fabs(value[i]);
        }
        for (int i = 0; i <= 2 * radius; i++)
            kernels[order].weight[i] = (float)(value[i] / (value[i] > 0 ? positive : negative));
    }
}

/* Length of the gradient, or of both second derivatives, of lightness; work: three planes. */
static void features(float *out, const float *lightness, int order, float *const work[3], int w,
                     int h)
{
    struct kernel kernels[3] = {0};
    feature_kernels(kernels);
    plane_rows(work[0], lightness, w, h, &kernels[order]);
    plane_columns(work[1], work[0], w, h, &kernels[0]);
    plane_rows(work[0], lightness, w, h, &kernels[0]);
    plane_columns(work[2], work[0], w, h, &kernels[order]);
    for (size_t i = 0; i < (size_t)w * (size_t)h; i++) /* lightness from 0 to 1: Y/116 */
        out[i] = sqrtf(work[1][i] * work[1][i] + work[2][i] * work[2][i]) / 116;
}

static void side_make(struct side *side, const struct image *image, float *const work[4])
{
    int w = image->width, h = image->height;
    float *const opponent[3] = {side->lab[0], side->lab[1], side->lab[2]};
    flip_opponent(opponent, image);
    features(side->edge, opponent[0], 1, work, w, h);
    features(side->point, opponent[0], 2, work, w, h);
    for (int k = 0; k < 3; k++) {
        memcpy(work[3], opponent[k], (size_t)w * (size_t)h * sizeof(float));
        blur(opponent[k], work[3], k, work, w, h);
    }
    flip_lab(opponent, (size_t)w * (size_t)h);
}

/* Errors up to 0.4 of the largest take the range to 0.95 (section 4.1.3). */
static float compress(float error, float largest)
{
    const float knee = 0.4f * largest;
    return error < knee ? error / knee * 0.95f
                        : 0.95f + (error - knee) / (largest - knee) * 0.05f;
}

/* map = colour error ^ (1 - feature error), 0 to 1 (eq. 9). */
static void combine(float *map, const struct side *a, const struct side *b, size_t count)
{
    const float largest = powf(flip_largest_distance(), 0.7f);
    for (size_t i = 0; i < count; i++) {
        float p[3] = {a->lab[0][i], a->lab[1][i], a->lab[2][i]};
        float q[3] = {b->lab[0][i], b->lab[1][i], b->lab[2][i]};
        float colour = compress(powf(flip_distance(p, q), 0.7f), largest);
        float feature = fmaxf(fabsf(a->edge[i] - b->edge[i]), fabsf(a->point[i] - b->point[i]));
        feature = sqrtf(fminf(feature * 0.70710678f, 1));
        map[i] = powf(fminf(colour, 1), 1 - feature);
    }
}

/* The value that `part` thousandths of the pixels do not exceed: floats from 0 up have the order of their bits. */
static double percentile(const float *map, size_t count, size_t part)
{
    static const uint32_t shift[2] = {16, 0};
    size_t wanted = (count * part + 999) / 1000;
    uint32_t found = 0, bits;
    float value;
    for (int pass = 0; pass < 2; pass++) {
        static _Thread_local uint32_t bins[1 << 16];
        uint32_t bin = 0;
        memset(bins, 0, sizeof bins);
        for (size_t i = 0; i < count; i++) {
            memcpy(&bits, map + i, sizeof bits);
            if (pass == 0 || bits >> 16 == found >> 16)
                bins[bits >> shift[pass] & 0xffff]++;
        }
        while (bins[bin] < wanted)
            wanted -= bins[bin++];
        found |= bin << shift[pass];
    }
    memcpy(&value, &found, sizeof value);
    return (double)value;
}

static double mean(const float *map, size_t count)
{
    double sum = 0;
    for (size_t i = 0; i < count; i++)
        sum += (double)map[i];
    return sum / (double)count;
}

static enum status measure(const struct image *a, const struct image *b,
                           const struct metric_settings *settings, double *values, struct error *e)
{
    float *planes[2 * SIDE_PLANES + WORK_PLANES] = {0}, **work = planes + 2 * SIDE_PLANES;
    const struct image *images[2] = {a, b};
    struct side sides[2];
    (void)settings;
    e->status = STATUS_OK;
    for (int k = 0; k < 2 * SIDE_PLANES + WORK_PLANES; k++)
        if (!(planes[k] = plane_create(a->width, a->height, e)))
            goto cleanup;
    for (int k = 0; k < 2; k++) {
        float **p = planes + k * SIDE_PLANES;
        sides[k] = (struct side){{p[0], p[1], p[2]}, p[3], p[4]};
        side_make(&sides[k], images[k], work);
    }
    combine(work[0], &sides[0], &sides[1], metric_pixels(a));
    values[0] = mean(work[0], metric_pixels(a));
    values[1] = percentile(work[0], metric_pixels(a), 990);
    values[2] = percentile(work[0], metric_pixels(a), 999);
cleanup:
    for (int k = 0; k < 2 * SIDE_PLANES + WORK_PLANES; k++)
        memory_free(planes[k]);
    return e->status;
}

static const struct score scores[] = {
    {.name = "flip", .option = "max-flip", .most = 1, .doc = "Largest mean FLIP of a frame"},
    {.name = "flip-p99", .option = "max-flip-p99", .most = 1,
     .doc = "Largest FLIP that 99 % of the pixels may have"},
    {.name = "flip-p999", .option = "max-flip-p999", .most = 1,
     .doc = "Largest FLIP that 99.9 % of the pixels may have"},
};

extern const struct metric metric_flip;
const struct metric metric_flip = {
    .variant = {.name = "flip", .doc = "flip: difference seen by alternating pictures at 67 pixels a "
                                       "degree (Andersson et al. 2020), mean; flip-p99, flip-p999: what 99 and "
                                       "99.9 % of the pixels do not exceed"},
    .scores = scores,
    .score_count = sizeof scores / sizeof *scores,
    .measure = measure,
};
