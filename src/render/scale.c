/* How values spread over a colour map: linear or logarithmic, continuous or in steps. */
#include "render/scale.h"

#include "base/portable_math.h"

#include <math.h>

double scale_part(const struct color_scale *scale, double value)
{
    double low = scale->range[0], high = scale->range[1];
    if (!(high > low))
        return value > low;
    if (scale->log)
        return value > 0 ? portable_log(value / low) / portable_log(high / low) : (double)NAN;
    return (value - low) / (high - low);
}

double scale_value(const struct color_scale *scale, double part)
{
    double low = scale->range[0], high = scale->range[1];
    return scale->log ? low * pow(high / low, part) : low + part * (high - low);
}

float scale_place(const struct color_scale *scale, float value)
{
    if (!scale->log && scale->steps < 2 && scale->range[1] > scale->range[0])
        return scale_place_linear(scale->range[0], scale->range[1], value);
    double part = scale_part(scale, (double)value);
    part = part >= 1 ? 1 : part > 0 ? part : 0;
    if (scale->steps < 2)
        return (float)part;
    return (float)(fmin(floor(part * scale->steps), scale->steps - 1) / (scale->steps - 1));
}
