/* What one sample shows: where its ray meets a sphere, the light there, the triangles blended over it; and
 * the pixel that samples make. The cpu renderer's loops and the cuda renderer's kernels are made of it, so
 * that both draw the same bits. In the common subset of C and CUDA.
 *
 * A ray r = (x, y, 1) from the eye meets the sphere of radius R about c, with o = c_z r - c, where
 *   |o + t r|^2 = R^2: t = -(o.r + sqrt((o.r)^2 - r.r (o.o - R^2)))/r.r, depth c_z + t
 * all differences being taken near the sphere. */
#ifndef RENDER_SAMPLE_H
#define RENDER_SAMPLE_H

#include "render/picture.h"

#include <math.h>

/* A sphere, and the rays of a row of samples: what is the same along it. */
struct meeting {
    float lens, scale, x, z;  /* scale: o_x = scale r_x - x */
    float rest, across, side; /* o_y^2 - R^2, o_y r_y, r_y^2 + 1 */
};

static inline struct meeting meeting_make(const struct splat *s, const struct ball *ball, float ray_y)
{
    const float scale = s->lens * ball->z + (1 - s->lens), r2 = s->radius * s->radius;
    const float oy = scale * ray_y - ball->y, dy = s->lens * ray_y;
    struct meeting m;
    m.lens = s->lens;
    m.scale = scale;
    m.x = ball->x;
    m.z = ball->z;
    m.rest = oy * oy - r2;
    m.across = oy * dy;
    m.side = dy * dy + 1;
    return m;
}

/* (o.r)^2 - r.r (o.o - R^2): below 0 where the ray passes by. Sets o.r and r.r. */
static inline float meeting_root(const struct meeting *m, float ray_x, float *along, float *square)
{
    const float ox = m->scale * ray_x - m->x, dx = m->lens * ray_x;
    *along = ox * dx + m->across;
    *square = dx * dx + m->side;
    return *along * *along - *square * (ox * ox + m->rest);
}

/* The depth of what the ray meets; *root below 0: nothing. */
static inline float meeting_depth(const struct meeting *m, float ray_x, float *root)
{
    float along, square;
    *root = meeting_root(m, ray_x, &along, &square);
    return m->z - (along + sqrtf(*root > 0 ? *root : 0)) / square;
}

/* The factor of the colour, and the white that is added. */
struct light {
    float part, shine;
};

/* At `depth`, where the ray meets the sphere about (x, y, z); `inverse` is 1 / radius. See look.h. */
static inline struct light light_make(const struct look *look, float lens, float inverse, float x, float y,
                                      float z, float ray_x, float ray_y, float depth)
{
    float t = depth - z, scale = lens * depth + (1 - lens), dx = lens * ray_x, dy = lens * ray_y;
    float nx = (scale * ray_x - x) * inverse;
    float ny = (scale * ray_y - y) * inverse, nz = -t * inverse; /* towards the viewer */
    float length = 1 / sqrtf(dx * dx + dy * dy + 1), along = nx * dx + ny * dy - nz;
    float facing = along < 0 ? -along * length : 0;
    float key = nx * look->key[0] + ny * look->key[1] + nz * look->key[2];
    float ahead = (dx * look->key[0] + dy * look->key[1] - look->key[2]) * length;
    float glance = ahead - 2 * along * length * key;
    float g2 = glance > 0 ? glance * glance : 0, g4 = g2 * g2, g8 = g4 * g4;
    float sum = look->base + look->sky * (0.5F + 0.5F * ny);
    sum = (sum + look->diffuse * (key > 0 ? key : 0)) * (1 - look->facing + look->facing * facing);
    float inside = facing * facing < look->rim ? 0 : 1, white = look->shine * inside;
    struct light light;
    sum = sum < 1 ? sum : 1;
    light.part = (0.25F + 0.75F * inside) * sum;
    light.shine = white * (g8 * g8 * g8);
    return light;
}

/* The byte of a sphere's colour that is `shift` bits up, lit. */
static inline float light_color(uint32_t rgb, int shift, float part, float shine)
{
    float c = (float)(int)(rgb >> shift & 255) * (1 / 255.0F) * part + shine;
    return c < 1 ? c : 1;
}

/* The background's colour k in a row of samples. */
static inline float back_of(const struct splat *s, int k, int row)
{
    return s->back[k] + s->fade[k] * (float)row;
}

/* Whether the middle of a sample is in the triangle. */
static inline bool blend_covers(const struct blend *b, double x, double y)
{
    for (int k = 0; k < 3; k++) {
        double inside = b->edge[k][0] + b->edge[k][2] * y + b->edge[k][1] * x;
        if (!(inside > 0 || (b->owns[k] && inside == 0)))
            return false;
    }
    return true;
}

/* Whether no sample of a tile is in the triangle: for each edge the corner farthest inwards is asked,
 * by blend_covers' sum, which rounding leaves monotonic. */
static inline bool blend_misses(const struct blend *b, int left, int top, int width, int height)
{
    for (int k = 0; k < 3; k++) {
        double x = left + 0.5 + (b->edge[k][1] > 0 ? width - 1 : 0);
        double y = top + 0.5 + (b->edge[k][2] > 0 ? height - 1 : 0);
        if (b->edge[k][0] + b->edge[k][2] * y + b->edge[k][1] * x < 0)
            return true;
    }
    return false;
}

/* A triangle in one row of a tile. */
struct span {
    float near, near_x, side, side_x; /* at the tile's first sample, and their change with samples */
    float half, cover, parallel, sign, tie;
};

/* `left` is the tile's first column. */
static inline struct span span_make(const struct blend *b, int left, int row)
{
    const double py = row + 0.5, px = left + 0.5;
    struct span s;
    s.near = (float)(b->inverse[0] + b->inverse[2] * py + b->inverse[1] * px);
    s.side = (float)(b->across[0] + b->across[2] * py + b->across[1] * px);
    s.near_x = (float)b->inverse[1];
    s.side_x = (float)b->across[1];
    s.half = b->half_width > 0 ? b->half_width + 0.5F : 1;
    s.cover = b->cover;
    s.parallel = b->parallel ? 1 : 0;
    s.sign = b->behind ? -1 : 1;
    s.tie = b->behind ? 1 : 0;
    return s;
}

/* Its depth at sample i of the tile's row. */
static inline float span_depth(const struct span *s, int i)
{
    float value = s->near + s->near_x * (float)i;
    return s->parallel > 0 ? value : 1 / value;
}

/* How much it covers of that sample, where a sphere is seen at depth `seen`. */
static inline float span_part(const struct span *s, int i, float seen)
{
    float apart = s->sign * (seen - span_depth(s, i));
    float soft = s->half - fabsf(s->side + s->side_x * (float)i);
    soft = soft < 0 ? 0 : soft;
    soft = soft > 1 ? 1 : soft;
    return ((apart > 0) | ((s->tie > 0) & (apart == 0))) ? s->cover * soft : 0;
}

/* Four bytes of a pixel, the first lowest, from sums over its samples; `scale` is 1 / their number. Colours
 * are divided by alpha. */
static inline uint32_t pixel_make(float red, float green, float blue, float alpha, float scale)
{
    float cover = alpha * scale, part = 255 * scale / (cover > 1e-4F ? cover : 1);
    uint32_t r = (uint32_t)(int)(red * part + 0.5F);
    uint32_t g = (uint32_t)(int)(green * part + 0.5F);
    uint32_t b = (uint32_t)(int)(blue * part + 0.5F);
    uint32_t a = (uint32_t)(int)(255 * cover + 0.5F);
    return r | g << 8 | b << 16 | a << 24;
}

#endif
