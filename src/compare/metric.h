/* Metrics: numbers that say how far two pictures of one size differ; rows of a table. */
#ifndef COMPARE_METRIC_H
#define COMPARE_METRIC_H

#include "base/error.h"
#include "base/image.h"
#include "base/variant.h"

#include <stdbool.h>

enum { SCORES_MAX = 9 }; /* of all metrics together */

/* One number of a metric. */
struct score {
    const char *name;   /* "flip-p99", in tables and JSON */
    const char *option; /* of its limit, "max-flip-p99" */
    const char *doc;    /* of that option */
    double equal;       /* of equal pictures */
    double most;        /* the largest limit that makes sense */
    bool is_likeness;   /* the limit is the least allowed, not the largest */
};

/* What a metric needs to know besides the pictures. */
struct metric_settings {
    double levels; /* of 0..255: channels that differ by this much count as the same */
};

struct metric {
    struct variant variant;
    const struct score *scores;
    size_t score_count;
    /* A number for each score; both pictures have the same size. STATUS_RUN: memory. */
    enum status (*measure)(const struct image *a, const struct image *b,
                           const struct metric_settings *settings, double *values, struct error *e);
};

extern const struct variant_table metric_table; /* "metrics": exact, channel, psnr, ssim, flip */

/* Scores are numbered through all metrics in table order. */
size_t metric_score_count(void);
const struct score *metric_score(size_t index);

/* True when the limit, NAN for none, is kept. */
bool metric_keeps(const struct score *score, double value, double limit);

/* All scores; pictures of the same bytes cost no more than reading them. */
enum status metric_measure(const struct image *a, const struct image *b,
                           const struct metric_settings *settings, double *values,
                           struct error *e);

/* The largest difference of a pixel's channels, 0..255. */
static inline int metric_pixel(const uint8_t *a, const uint8_t *b)
{
    int most = 0;
    for (int k = 0; k < 4; k++) {
        int difference = a[k] < b[k] ? b[k] - a[k] : a[k] - b[k];
        most = difference > most ? difference : most;
    }
    return most;
}

static inline size_t metric_pixels(const struct image *image)
{
    return (size_t)image->width * (size_t)image->height;
}

#endif
