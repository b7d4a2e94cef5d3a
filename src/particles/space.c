/* Maps metres to fixed-point coordinates. */
#include "particles/space.h"

#include <math.h>

struct space space_create(const struct scene *scene, double margin)
{
    struct space s = {0};
    for (int a = 0; a < 3; a++) {
        const enum wall_kind *walls = &scene->domain.walls[2 * a];
        s.periodic[a] = walls[0] == WALL_PERIODIC;
        double low = walls[0] == WALL_PARTICLES ? margin : 0;
        double beyond = 2 * scene->particles.spacing; /* a step beyond the plane is still above it */
        double high = s.periodic[a] ? 0 : walls[1] == WALL_PARTICLES ? fmax(margin, beyond) : beyond;
        double size = scene->domain.max[a] - scene->domain.min[a];
        s.origin[a] = scene->domain.min[a] - low;
        s.length[a] = low + size + high;
        s.unit[a] = s.length[a] * (s.periodic[a] ? 0x1p-32 : 0x1p-31);
        s.low[a] = (uint32_t)llround(low / s.unit[a]);
        s.high[a] = s.periodic[a] ? UINT32_MAX : (uint32_t)llround((low + size) / s.unit[a]);
    }
    return s;
}

uint32_t space_count(const struct space *space, int axis, double metres)
{
    double counts = (metres - space->origin[axis]) / space->unit[axis];
    return (uint32_t)(int64_t)llround(counts);
}

double space_metres(const struct space *space, int axis, uint32_t count)
{
    return space->origin[axis] + count * space->unit[axis];
}
