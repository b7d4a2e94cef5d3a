/* The loops that put particles into camera axes; part of splat_loops.h. */
#include "render/project.h"

/* Positions in camera axes. */
static inline void chunk_view(const struct viewpoint *v, const float *position, float *restrict x,
                              float *restrict y, float *restrict z)
{
    const double *r = v->axis[0], *u = v->axis[1], *f = v->axis[2];
    const double ex = v->eye[0], ey = v->eye[1], ez = v->eye[2];
#pragma omp simd
    for (int l = 0; l < CHUNK; l++) {
        double px = position[3 * l] - ex, py = position[3 * l + 1] - ey, pz = position[3 * l + 2] - ez;
        x[l] = (float)(px * r[0] + py * r[1] + pz * r[2]);
        y[l] = (float)(px * u[0] + py * u[1] + pz * u[2]);
        z[l] = (float)(px * f[0] + py * f[1] + pz * f[2]);
    }
}

/* The samples first..end - 1 whose rays, through their middles, may meet the spheres along one axis: what
 * is within the tangents from the eye, and a little more for rounding. */
static inline void chunk_extent(const struct viewpoint *v, int axis, const float *restrict center,
                                const float *restrict z, float *restrict first, float *restrict end)
{
    const float radius = v->radius, half = v->half[axis], most = (float)v->size[axis];
    const float lens = v->lens, least = lens > 0 ? radius * 1.01F : -INFINITY;
#pragma omp simd
    for (int l = 0; l < CHUNK; l++) {
        float under = z[l] * z[l] - radius * radius;
        float reach = radius * sqrtf(lens * (center[l] * center[l] + under) + (1 - lens));
        float scale = half / (lens * under + (1 - lens)), middle = center[l] * (lens * z[l] + (1 - lens));
        float low = (middle - reach) * scale, high = (middle + reach) * scale;
        float more = 0.55F + 1e-3F * fabsf(high - low);
        float a = (low < high ? low : high) + 0.5F * most - more + 1;
        float b = (low < high ? high : low) + 0.5F * most + more;
        bool known = z[l] > least;
        a = known ? a : 0;
        b = known ? b : most;
        a = a < most ? a : most;
        b = b < most ? b : most;
        first[l] = a > 0 ? a : 0;
        end[l] = b > 0 ? b : 0;
    }
}

/* 1 where a sphere is in front of the eye, and covers samples. */
static inline void chunk_seen(const struct viewpoint *v, const float *restrict x, const float *restrict y,
                              const float *restrict z, const float (*restrict box)[CHUNK],
                              float *restrict seen)
{
    const float r2 = v->lens > 0 ? v->radius * v->radius : -1;
#pragma omp simd
    for (int l = 0; l < CHUNK; l++) {
        float distance2 = x[l] * x[l] + y[l] * y[l] + z[l] * z[l];
        bool ahead = (z[l] > 0) & (distance2 > r2) & (distance2 < 1e30F);
        bool any = ((int)box[0][l] < (int)box[1][l]) & ((int)box[2][l] < (int)box[3][l]);
        seen[l] = (ahead & any) ? 1 : 0;
    }
}

static void chunk_place(const struct viewpoint *v, const float *position, size_t count, struct ball *balls)
{
    float p[3 * CHUNK] = {0}, x[CHUNK], y[CHUNK], z[CHUNK], box[4][CHUNK], seen[CHUNK];
    memcpy(p, position, 3 * count * sizeof *p);
    chunk_view(v, p, x, y, z);
    chunk_extent(v, 0, x, z, box[0], box[1]);
    chunk_extent(v, 1, y, z, box[2], box[3]);
    chunk_seen(v, x, y, z, (const float (*)[CHUNK])box, seen);
    for (size_t l = 0; l < count; l++) {
        const float s = seen[l];
        balls[l] = (struct ball){x[l], y[l], z[l], {0}, (uint16_t)(int)(s * box[0][l]),
                                 (uint16_t)(int)(s * box[1][l]), (uint16_t)(int)(s * box[2][l]),
                                 (uint16_t)(int)(s * box[3][l])};
    }
}

/* Places of values in the map. */
static inline void chunk_scale(const struct color_scale *scale, const float *restrict value,
                               float *restrict place)
{
    const double low = scale->range[0], high = scale->range[1];
    if (scale->log || scale->steps >= 2 || !(high > low)) {
        for (int l = 0; l < CHUNK; l++)
            place[l] = scale_place(scale, value[l]);
        return;
    }
#pragma omp simd
    for (int l = 0; l < CHUNK; l++)
        place[l] = scale_place_linear(low, high, value[l]);
}

/* Between the two nearest colours of the map; the ends of the range are the first and the last. */
static void chunk_colors(const struct color_scale *scale, const uint32_t *map, const float *value,
                         size_t count, struct ball *balls)
{
    float v[CHUNK] = {0}, place[CHUNK];
    uint32_t rgb[CHUNK];
    memcpy(v, value, count * sizeof *v);
    chunk_scale(scale, v, place);
#pragma omp simd
    for (int l = 0; l < CHUNK; l++) {
        double t = place[l] * (double)(MAP_SIZE - 1);
        int low = t < MAP_SIZE - 2 ? (int)t : MAP_SIZE - 2;
        uint32_t own = map[low], next = map[low + 1], sum = 0;
        for (int k = 0; k < 24; k += 8) {
            int a = (int)(own >> k & 255), b = (int)(next >> k & 255);
            sum |= (uint32_t)(int)(a + (t - low) * (b - a) + 0.5) << k;
        }
        rgb[l] = sum;
    }
    for (size_t l = 0; l < count; l++)
        memcpy(balls[l].rgb, &rgb[l], sizeof balls[l].rgb); /* bytes in memory: little endian */
}

static const struct project_loops project_loops = {chunk_place, chunk_colors};
