/* Metric "exact": the part of the pixels that are not the same bits. */
#include "compare/metric.h"

static enum status measure(const struct image *a, const struct image *b,
                           const struct metric_settings *settings, double *values, struct error *e)
{
    size_t changed = 0;
    (void)settings;
    (void)e;
    for (size_t i = 0; i < metric_pixels(a); i++)
        changed += metric_pixel(a->rgba + 4 * i, b->rgba + 4 * i) > 0;
    values[0] = (double)changed / (double)metric_pixels(a);
    return STATUS_OK;
}

static const struct score scores[] = {
    {.name = "changed", .option = "max-changed", .most = 1,
     .doc = "Part of the pixels that may differ at all"},
};

extern const struct metric metric_exact;
const struct metric metric_exact = {
    .variant = {.name = "exact", .doc = "changed: part of the pixels that are not the same bits"},
    .scores = scores,
    .score_count = sizeof scores / sizeof *scores,
    .measure = measure,
};
