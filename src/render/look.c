/* Light and material of spheres. */
#include "render/look.h"

#include <math.h>

struct look look_make(double outline)
{
    static const double key[3] = {-0.40, 0.55, 0.73};
    double length = sqrt(key[0] * key[0] + key[1] * key[1] + key[2] * key[2]);
    struct look look = {
        .base = 0.44F, .sky = 0.20F, .diffuse = 0.52F, .facing = 0.38F, .shine = 0.10F,
        .rim = (float)(outline * (2 - outline))};
    for (int k = 0; k < 3; k++)
        look.key[k] = (float)(key[k] / length);
    return look;
}
