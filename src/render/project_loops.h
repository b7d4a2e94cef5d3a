/* The loops that put particles into camera axes; part of splat_loops.h. */
#include "render/project.h"

/* Positions in camera axes. */
static inline void chunk_view(const struct viewpoint *v, const float *position, float *restrict x,
                              float *restrict y, float *restrict z)
{
    const struct viewpoint view = *v;
#pragma omp simd
    for (int l = 0; l < CHUNK; l++) {
        float px = position[3 * l], py = position[3 * l + 1], pz = position[3 * l + 2];
        x[l] = place_along(&view, 0, px, py, pz);
        y[l] = place_along(&view, 1, px, py, pz);
        z[l] = place_along(&view, 2, px, py, pz);
    }
}

static inline void chunk_extent(const struct viewpoint *v, int axis, const float *restrict center,
                                const float *restrict z, float *restrict first, float *restrict end)
{
    const struct viewpoint view = *v;
#pragma omp simd
    for (int l = 0; l < CHUNK; l++)
        place_extent(&view, axis, center[l], z[l], &first[l], &end[l]);
}

static inline void chunk_seen(const struct viewpoint *v, const float *restrict x, const float *restrict y,
                              const float *restrict z, const float (*restrict box)[CHUNK],
                              float *restrict seen)
{
    const struct viewpoint view = *v;
#pragma omp simd
    for (int l = 0; l < CHUNK; l++)
        seen[l] = place_seen(&view, x[l], y[l], z[l], box[0][l], box[1][l], box[2][l], box[3][l]);
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

/* Colours of values. */
static void chunk_colors(const struct color_scale *scale, const uint32_t *map, const float *value,
                         size_t count, struct ball *balls)
{
    float v[CHUNK] = {0}, place[CHUNK];
    uint32_t rgb[CHUNK];
    memcpy(v, value, count * sizeof *v);
    chunk_scale(scale, v, place);
#pragma omp simd
    for (int l = 0; l < CHUNK; l++)
        rgb[l] = scale_color(map, place[l]);
    for (size_t l = 0; l < count; l++)
        memcpy(balls[l].rgb, &rgb[l], sizeof balls[l].rgb); /* bytes in memory: little endian */
}

static const struct project_loops project_loops = {chunk_place, chunk_colors};
