/* The ends of a colour map by a frame's own values. */
#include "render/percentiles.h"

#include <math.h>
#include <string.h>

/* Order of floats as integers; what is not a number is 0. */
static uint32_t rank_of(float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return value != value ? 0 : bits >> 31 ? ~bits : bits | 0x80000000u;
}

static float value_of(uint32_t rank)
{
    uint32_t bits = rank >> 31 ? rank & 0x7fffffffu : ~rank;
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* The value that `percent` of all do not exceed, found bit by bit from the top. */
static double percentile(const float *values, size_t count, double percent)
{
    size_t wanted = (size_t)ceil(percent / 100 * (double)count);
    uint32_t rank = 0;
    wanted = wanted < 1 ? 1 : wanted;
    for (int shift = 24; shift >= 0; shift -= 8) {
        size_t histogram[256] = {0};
        uint32_t part = 0;
        for (size_t i = 0; i < count; i++) {
            uint32_t own = rank_of(values[i]);
            if (shift == 24 || own >> (shift + 8) == rank >> (shift + 8))
                histogram[own >> shift & 255]++;
        }
        while (part < 255 && wanted > histogram[part])
            wanted -= histogram[part++];
        rank |= part << shift;
    }
    return (double)value_of(rank);
}

void percentiles_range(const struct render_setup *setup, const float *values, size_t count,
                       struct color_scale *scale)
{
    const double *percent = setup->scene->color.percentiles;
    double low, high;
    if (count == 0)
        return;
    low = percentile(values, count, percent[0]);
    high = percentile(values, count, percent[1]);
    if (setup->symmetric) {
        high = fmax(fabs(low), fabs(high));
        low = -high;
    }
    if (scale->log)
        low = fmax(low, DECADES_MIN * high);
    if (high > low && isfinite(high - low)) {
        scale->range[0] = low;
        scale->range[1] = high;
    }
}
