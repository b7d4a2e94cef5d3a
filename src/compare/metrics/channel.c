/* Metric "channel": the largest difference of a channel, and how many pixels exceed a threshold. */
#include "compare/metric.h"

static enum status measure(const struct image *a, const struct image *b,
                           const struct metric_settings *settings, double *values, struct error *e)
{
    int most = 0;
    size_t over = 0;
    (void)e;
    for (size_t i = 0; i < metric_pixels(a); i++) {
        int difference = metric_pixel(a->rgba + 4 * i, b->rgba + 4 * i);
        most = difference > most ? difference : most;
        over += difference > settings->levels;
    }
    values[0] = most;
    values[1] = (double)over / (double)metric_pixels(a);
    return STATUS_OK;
}

static const struct score scores[] = {
    {.name = "difference", .option = "max-difference", .most = 255,
     .doc = "Levels (0 to 255) by which any channel may differ"},
    {.name = "over", .option = "max-fraction", .most = 1,
     .doc = "Part of the pixels that may differ by more than --max-channel"},
};

extern const struct metric metric_channel;
const struct metric metric_channel = {
    .variant = {.name = "channel", .doc = "difference: the largest of any channel, of 255; over: "
                                          "part of the pixels over --max-channel"},
    .scores = scores,
    .score_count = sizeof scores / sizeof *scores,
    .measure = measure,
};
