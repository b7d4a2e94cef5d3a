/* Metric "psnr": peak signal-to-noise ratio of red, green and blue together, dB. */
#include "compare/metric.h"

#include <math.h>

static enum status measure(const struct image *a, const struct image *b,
                           const struct metric_settings *settings, double *values, struct error *e)
{
    uint64_t squares = 0; /* whole numbers: exact in any order */
    (void)settings;
    (void)e;
    for (size_t i = 0; i < metric_pixels(a); i++)
        for (size_t k = 4 * i; k < 4 * i + 3; k++) {
            int difference = a->rgba[k] - b->rgba[k];
            squares += (uint64_t)(difference * difference);
        }
    double mean = (double)squares / (3 * (double)metric_pixels(a));
    values[0] = squares ? 10 * log10(255.0 * 255.0 / mean) : (double)INFINITY;
    return STATUS_OK;
}

static const struct score scores[] = {
    {.name = "psnr", .option = "min-psnr", .equal = INFINITY, .most = 1000, .is_likeness = true,
     .doc = "Least PSNR, dB"},
};

extern const struct metric metric_psnr;
const struct metric metric_psnr = {
    .variant = {.name = "psnr", .doc = "psnr: peak signal-to-noise ratio, dB; inf when equal"},
    .scores = scores,
    .score_count = sizeof scores / sizeof *scores,
    .measure = measure,
};
