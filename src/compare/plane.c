/* Filters float planes along rows and columns. */
#include "compare/plane.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

struct kernel kernel_gaussian(double sigma, int radius)
{
    struct kernel kernel = {.radius = radius};
    double value[2 * KERNEL_RADIUS_MAX + 1];
    for (int i = -radius; i <= radius; i++)
        kernel.sum += value[i + radius] = exp(-i * i / (2 * sigma * sigma));
    for (int i = 0; i <= 2 * radius; i++)
        kernel.weight[i] = (float)(value[i] / kernel.sum);
    return kernel;
}

float *plane_create(int width, int height, struct error *e)
{
    return memory_create("compare", (size_t)width * (size_t)height, sizeof(float), e);
}

static int clamp(int value, int most)
{
    return value < 0 ? 0 : value > most ? most : value;
}

static float row_edge(const float *in, int width, int x, const struct kernel *kernel)
{
    float sum = 0;
    for (int i = 0; i <= 2 * kernel->radius; i++)
        sum += kernel->weight[i] * in[clamp(x + i - kernel->radius, width - 1)];
    return sum;
}

/* Blocks of pixels stay in registers while the taps pass by. */
enum { BLOCK = 32 };

static void row_block(float *out, const float *in, const struct kernel *kernel)
{
    float sum[BLOCK] = {0};
    for (int i = 0; i <= 2 * kernel->radius; i++) {
        float weight = kernel->weight[i];
#pragma omp simd
        for (int x = 0; x < BLOCK; x++)
            sum[x] += weight * in[x + i];
    }
    memcpy(out, sum, sizeof sum);
}

void plane_rows(float *out, const float *in, int width, int height, const struct kernel *kernel)
{
    int radius = kernel->radius;
    for (int y = 0; y < height; y++, in += width, out += width) {
        int x = 0;
        for (; x < radius && x < width; x++)
            out[x] = row_edge(in, width, x, kernel);
        for (; x + BLOCK + radius <= width; x += BLOCK)
            row_block(out + x, in + x - radius, kernel);
        for (; x < width; x++)
            out[x] = row_edge(in, width, x, kernel);
    }
}

static void column_block(float *out, const float *const *rows, int x0, const struct kernel *kernel)
{
    float sum[BLOCK] = {0};
    for (int i = 0; i <= 2 * kernel->radius; i++) {
        float weight = kernel->weight[i];
        const float *row = rows[i] + x0;
#pragma omp simd
        for (int x = 0; x < BLOCK; x++)
            sum[x] += weight * row[x];
    }
    memcpy(out + x0, sum, sizeof sum);
}

void plane_columns(float *out, const float *in, int width, int height, const struct kernel *kernel)
{
    const float *rows[2 * KERNEL_RADIUS_MAX + 1];
    for (int y = 0; y < height; y++, out += width) {
        int x = 0;
        for (int i = 0; i <= 2 * kernel->radius; i++)
            rows[i] = in + (size_t)clamp(y + i - kernel->radius, height - 1) * (size_t)width;
        for (; x + BLOCK <= width; x += BLOCK)
            column_block(out, rows, x, kernel);
        for (; x < width; x++) {
            out[x] = 0;
            for (int i = 0; i <= 2 * kernel->radius; i++)
                out[x] += kernel->weight[i] * rows[i][x];
        }
    }
}
