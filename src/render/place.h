/* Puts one particle into camera axes, and finds the samples that its sphere may cover. The cpu renderer's
 * loops and the cuda renderer's kernels are made of it. In the common subset of C and CUDA. */
#ifndef RENDER_PLACE_H
#define RENDER_PLACE_H

#include <math.h>
#include <stdbool.h>

/* Where spheres are seen from, and on what. */
struct viewpoint {
    double eye[3];              /* m */
    double axis[3][3];          /* right, up, forward */
    float half[2];              /* samples from the picture's middle to tangent 1, rightwards and downwards */
    int size[2];                /* samples of the picture */
    float radius;               /* of the spheres, m */
    float lens;                 /* 1: rays start at the eye; 0: they are parallel */
};

/* A position along camera axis k. */
static inline float place_along(const struct viewpoint *v, int k, float x, float y, float z)
{
    const double *a = v->axis[k];
    double px = x - v->eye[0], py = y - v->eye[1], pz = z - v->eye[2];
    return (float)(px * a[0] + py * a[1] + pz * a[2]);
}

/* The samples first..end - 1 whose rays, through their middles, may meet the sphere along one axis: what
 * is within the tangents from the eye, and a little more for rounding. */
static inline void place_extent(const struct viewpoint *v, int axis, float center, float z, float *first,
                                float *end)
{
    const float radius = v->radius, half = v->half[axis], most = (float)v->size[axis];
    const float lens = v->lens, least = lens > 0 ? radius * 1.01F : -INFINITY;
    float under = z * z - radius * radius;
    float reach = radius * sqrtf(lens * (center * center + under) + (1 - lens));
    float scale = half / (lens * under + (1 - lens)), middle = center * (lens * z + (1 - lens));
    float low = (middle - reach) * scale, high = (middle + reach) * scale;
    float more = 0.55F + 1e-3F * fabsf(high - low);
    float a = (low < high ? low : high) + 0.5F * most - more + 1;
    float b = (low < high ? high : low) + 0.5F * most + more;
    bool known = z > least;
    a = known ? a : 0;
    b = known ? b : most;
    a = a < most ? a : most;
    b = b < most ? b : most;
    *first = a > 0 ? a : 0;
    *end = b > 0 ? b : 0;
}

/* 1 where the sphere is in front of the eye, not around it, and covers samples; else 0. */
static inline float place_seen(const struct viewpoint *v, float x, float y, float z, float left, float right,
                               float top, float bottom)
{
    const float r2 = v->lens > 0 ? v->radius * v->radius : -1;
    float distance2 = x * x + y * y + z * z;
    bool ahead = (z > 0) & (distance2 > r2) & (distance2 < 1e30F);
    bool any = ((int)left < (int)right) & ((int)top < (int)bottom);
    return (ahead & any) ? 1 : 0;
}

#endif
