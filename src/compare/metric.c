/* The table of metrics, and all their scores of two pictures. */
#include "compare/metric.h"

#include <math.h>
#include <string.h>

extern const struct metric metric_exact, metric_channel, metric_psnr, metric_ssim, metric_flip;

static const struct metric *const metrics[] = {
    &metric_exact, &metric_channel, &metric_psnr, &metric_ssim, &metric_flip,
};
enum { METRIC_COUNT = sizeof metrics / sizeof metrics[0] };

static const struct variant *const variants[METRIC_COUNT] = {
    &metric_exact.variant, &metric_channel.variant, &metric_psnr.variant,
    &metric_ssim.variant,  &metric_flip.variant,
};

const struct variant_table metric_table = {
    .name = "metrics",
    .doc = "how far two pictures differ, as `sph-render compare' measures it",
    .rows = variants,
    .count = METRIC_COUNT,
};

size_t metric_score_count(void)
{
    size_t count = 0;
    for (size_t m = 0; m < METRIC_COUNT; m++)
        count += metrics[m]->score_count;
    return count;
}

const struct score *metric_score(size_t index)
{
    size_t m = 0;
    while (index >= metrics[m]->score_count)
        index -= metrics[m++]->score_count;
    return &metrics[m]->scores[index];
}

bool metric_keeps(const struct score *score, double value, double limit)
{
    return isnan(limit) || (score->is_likeness ? value >= limit : value <= limit);
}

enum status metric_measure(const struct image *a, const struct image *b,
                           const struct metric_settings *settings, double *values, struct error *e)
{
    bool equal = memcmp(a->rgba, b->rgba, 4 * metric_pixels(a)) == 0;
    for (size_t m = 0; m < METRIC_COUNT; m++) {
        const struct metric *row = metrics[m];
        for (size_t k = 0; equal && k < row->score_count; k++)
            values[k] = row->scores[k].equal;
        if (!equal && row->measure(a, b, settings, values, e))
            return error_context(e, "%s", row->variant.name);
        values += row->score_count;
    }
    return STATUS_OK;
}
