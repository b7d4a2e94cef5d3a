/* Metric "ssim": structural similarity of luma, its mean and its worst tile.
 *
 * Wang, Bovik, Sheikh, Simoncelli 2004, eq. 13: Gaussian windows of 11 pixels, sigma 1.5; edges are
 * repeated. A small defect drowns in the mean of a frame, but not in that of its tile. */
#include "base/memory.h"
#include "compare/metric.h"
#include "compare/plane.h"

#include <math.h>

enum { TILE = 64 };

/* Luma of BT.709 over black, less 128 so that squares keep their digits. */
static void luma(float *out, const struct image *image)
{
    for (size_t i = 0; i < metric_pixels(image); i++) {
        const uint8_t *p = image->rgba + 4 * i;
        float y = 0.2126f * p[0] + 0.7152f * p[1] + 0.0722f * p[2];
        out[i] = y * ((float)p[3] / 255) - 128;
    }
}

static void multiply(float *out, const float *a, const float *b, size_t count)
{
    for (size_t i = 0; i < count; i++)
        out[i] = a[i] * b[i];
}

/* means: of a, b, aa, bb, ab in each pixel's window; the result replaces the first. */
static void combine(float *const means[5], size_t count)
{
    const float c1 = 6.5025f, c2 = 58.5225f; /* (0.01 * 255)^2, (0.03 * 255)^2 */
    for (size_t i = 0; i < count; i++) {
        float a = means[0][i], b = means[1][i];
        float aa = means[2][i] - a * a, bb = means[3][i] - b * b, ab = means[4][i] - a * b;
        a += 128;
        b += 128;
        means[0][i] = (2 * a * b + c1) * (2 * ab + c2) / ((a * a + b * b + c1) * (aa + bb + c2));
    }
}

static double tile_mean(const float *map, int width, int x0, int y0, int x1, int y1)
{
    double sum = 0;
    for (int y = y0; y < y1; y++)
        for (int x = x0; x < x1; x++)
            sum += (double)map[(size_t)y * (size_t)width + (size_t)x];
    return sum / ((double)(x1 - x0) * (y1 - y0));
}

/* Tiles that do not fit at the right and lower edge are moved in, over their neighbours. */
static double worst_tile(const float *map, int width, int height)
{
    double worst = 1;
    for (int y = 0; y < height; y += TILE)
        for (int x = 0; x < width; x += TILE) {
            int x1 = x + TILE < width ? x + TILE : width, y1 = y + TILE < height ? y + TILE : height;
            worst = fmin(worst, tile_mean(map, width, x1 > TILE ? x1 - TILE : 0,
                                          y1 > TILE ? y1 - TILE : 0, x1, y1));
        }
    return worst;
}

static enum status measure(const struct image *a, const struct image *b,
                           const struct metric_settings *settings, double *values, struct error *e)
{
    static const int factors[5][2] = {{0, -1}, {1, -1}, {0, 0}, {1, 1}, {0, 1}};
    struct kernel window = kernel_gaussian(1.5, 5);
    int w = a->width, h = a->height;
    float *planes[9] = {0}; /* two lumas, two of work, and the means */
    float **means = planes + 4;
    (void)settings;
    e->status = STATUS_OK;
    for (int k = 0; k < 9; k++)
        if (!(planes[k] = plane_create(w, h, e)))
            goto cleanup;
    luma(planes[0], a);
    luma(planes[1], b);
    for (int k = 0; k < 5; k++) {
        const float *in = planes[factors[k][0]];
        if (factors[k][1] >= 0) {
            multiply(planes[2], in, planes[factors[k][1]], metric_pixels(a));
            in = planes[2];
        }
        plane_rows(planes[3], in, w, h, &window);
        plane_columns(means[k], planes[3], w, h, &window);
    }
    combine(means, metric_pixels(a));
    values[0] = tile_mean(means[0], w, 0, 0, w, h);
    values[1] = worst_tile(means[0], w, h);
cleanup:
    for (int k = 0; k < 9; k++)
        memory_free(planes[k]);
    return e->status;
}

static const struct score scores[] = {
    {.name = "ssim", .option = "min-ssim", .equal = 1, .most = 1, .is_likeness = true,
     .doc = "Least mean SSIM of a frame"},
    {.name = "ssim-tile", .option = "min-ssim-tile", .equal = 1, .most = 1, .is_likeness = true,
     .doc = "Least mean SSIM of a tile of 64 x 64 pixels"},
};

extern const struct metric metric_ssim;
const struct metric metric_ssim = {
    .variant = {.name = "ssim", .doc = "ssim: structural similarity of luma (Wang et al. 2004), mean; "
                                       "ssim-tile: of the worst 64 x 64 pixels"},
    .scores = scores,
    .score_count = sizeof scores / sizeof *scores,
    .measure = measure,
};
