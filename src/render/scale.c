/* The value at a place of a colour map: for bars and ticks. */
#include "render/scale.h"

double scale_value(const struct color_scale *scale, double part)
{
    double low = scale->range[0], high = scale->range[1];
    return scale->log ? low * pow(high / low, part) : low + part * (high - low);
}
