/* The cuda renderer's kernels: what they do for thread i. In the common subset of C and CUDA; the includer
 * says how threads share a least number, draw_least, and which bit of a word is the lowest, draw_lowest.
 *
 * Each sample keeps one number of 64 bits, depth above particle: depths in front of the eye are above 0, where
 * the bits of floats are in the order of their values. So the least number is the nearest sphere, of
 * equal depths the first, in whatever order threads come. */
#ifndef RENDER_CUDA_DRAW_H
#define RENDER_CUDA_DRAW_H

#include "render/cuda/draw_work.h"
#include "render/sample.h"

#include <string.h>

static inline uint64_t draw_key(float depth, uint32_t ball)
{
    uint32_t bits;
    memcpy(&bits, &depth, sizeof bits);
    return (uint64_t)bits << 32 | ball;
}

static inline float draw_depth(uint64_t key)
{
    const uint32_t bits = (uint32_t)(key >> 32);
    float depth;
    memcpy(&depth, &bits, sizeof depth);
    return depth;
}

/* Nothing is seen at sample i. */
static inline void draw_clear(const struct draw_work *w, size_t i)
{
    w->seen[i] = draw_key(INFINITY, UINT32_MAX);
}

/* The place in the map of the value that a word has. */
static inline float draw_map_place(const struct draw_work *w, uint32_t word)
{
    float value;
    memcpy(&value, &word, sizeof value);
    return scale_place(&w->scale, value);
}

/* Particle i as OpenGL's sprites want it. */
static inline void draw_pack(const struct draw_work *w, size_t i)
{
    const float p[3] = {w->position[3 * i], w->position[3 * i + 1], w->position[3 * i + 2]};
    uint32_t packed[4]; /* whole words: of what memcpy moves in memory, nvcc takes each byte by itself */
    packed[3] = w->word[i];
    if (w->values) {
        const float place = draw_map_place(w, packed[3]);
        memcpy(&packed[3], &place, sizeof place);
    }
    memcpy(packed, p, sizeof p);
    for (int k = 0; k < 4; k++)
        w->packed[i][k] = packed[k];
}

/* Particle i becomes a sphere in camera axes; without extent where it is out of sight. */
static inline void draw_place(const struct draw_work *w, size_t i)
{
    const float *p = w->position + 3 * i;
    struct ball b;
    float left, right, top, bottom, seen;
    b.x = place_along(&w->from, 0, p[0], p[1], p[2]);
    b.y = place_along(&w->from, 1, p[0], p[1], p[2]);
    b.z = place_along(&w->from, 2, p[0], p[1], p[2]);
    place_extent(&w->from, 0, b.x, b.z, &left, &right);
    place_extent(&w->from, 1, b.y, b.z, &top, &bottom);
    seen = place_seen(&w->from, b.x, b.y, b.z, left, right, top, bottom);
    const uint32_t word = w->word[i], rgb = w->values ? scale_color(w->map, draw_map_place(w, word)) : word;
    memcpy(b.rgb, &rgb, sizeof b.rgb);
    b.left = (uint16_t)(int)(seen * left);
    b.right = (uint16_t)(int)(seen * right);
    b.top = (uint16_t)(int)(seen * top);
    b.bottom = (uint16_t)(int)(seen * bottom);
    w->balls[i] = b;
}

/* Draws a share of a sphere: every DRAW_DOWN-th row, every DRAW_ACROSS-th sample. */
static inline void draw_splat(const struct draw_work *w, size_t i)
{
    const uint32_t number = (uint32_t)(i / DRAW_THREADS);
    const int lane = (int)(i % DRAW_THREADS);
    const struct ball b = w->balls[number];
    for (int y = b.top + lane / DRAW_ACROSS; y < b.bottom; y += DRAW_DOWN) {
        const struct meeting meeting = meeting_make(&w->splat, &b, w->splat.ray_y[y]);
        uint64_t *seen = w->seen + (size_t)y * (size_t)w->width;
        for (int x = b.left + lane % DRAW_ACROSS; x < b.right; x += DRAW_ACROSS) {
            float root, z = meeting_depth(&meeting, w->splat.ray_x[x], &root);
            if (root >= 0 && z > 0)
                draw_least(&seen[x], draw_key(z, number));
        }
    }
}

/* Word i of the tiles' masks: which of 32 triangles may cover the tile. */
static inline void draw_cull(const struct draw_work *w, size_t i)
{
    const int tile = (int)(i / w->words), left = tile % w->columns * w->tile, top = tile / w->columns * w->tile;
    const int width = w->width - left < w->tile ? w->width - left : w->tile;
    const int height = w->height - top < w->tile ? w->height - top : w->tile;
    const size_t first = i % w->words * 32;
    uint32_t bits = 0;
    for (size_t k = first; k < first + 32 && k < w->splat.blend_count; k++) {
        const struct blend *b = &w->splat.blends[k];
        bool near = b->left < left + width && b->right > left && b->top < top + height && b->bottom > top;
        if (near && !blend_misses(b, left, top, width, height))
            bits |= (uint32_t)1 << (k - first);
    }
    w->mask[i] = bits;
}

/* Blends a triangle over a sample at x, y of a tile that starts in column `left`, where *depth is seen. */
static inline void draw_blend(const struct blend *b, int left, int x, int y, float *depth, float color[4])
{
    if (x < b->left || x >= b->right || y < b->top || y >= b->bottom || !blend_covers(b, x + 0.5, y + 0.5))
        return;
    const struct span span = span_make(b, left, y);
    const float part = span_part(&span, x - left, *depth);
    for (int k = 0; k < 4; k++)
        color[k] += part * (b->color[k] - color[k]);
    if (b->solid && part > 0)
        *depth = span_depth(&span, x - left);
}

/* The sphere or the background of a sample. */
static inline void draw_ground(const struct draw_work *w, int x, int y, uint64_t seen, float color[4])
{
    const struct splat *s = &w->splat;
    const uint32_t number = (uint32_t)seen;
    for (int k = 0; k < 3; k++)
        color[k] = back_of(s, k, y);
    color[3] = 0;
    if (number == UINT32_MAX)
        return;
    const struct ball *b = &s->balls[number];
    const struct light light = light_make(&s->look, s->lens, 1 / s->radius, b->x, b->y, b->z, s->ray_x[x],
                                          s->ray_y[y], draw_depth(seen));
    uint32_t rgb;
    memcpy(&rgb, b->rgb, sizeof rgb);
    for (int k = 0; k < 3; k++)
        color[k] = light_color(rgb, 8 * k, light.part, light.shine);
    color[3] = 1;
}

/* The colour of a sample. */
static inline void draw_sample(const struct draw_work *w, int x, int y, float color[4])
{
    const uint64_t seen = w->seen[(size_t)y * (size_t)w->width + (size_t)x];
    const int column = x / w->tile, tile = y / w->tile * w->columns + column;
    const uint32_t *mask = w->mask + (size_t)tile * w->words;
    float depth = draw_depth(seen);
    draw_ground(w, x, y, seen, color);
    for (size_t word = 0; word < w->words; word++)
        for (uint32_t bits = mask[word]; bits; bits &= bits - 1)
            draw_blend(&w->splat.blends[32 * word + (size_t)draw_lowest(bits)], column * w->tile, x, y,
                       &depth, color);
}

/* The colour of pixel i: the mean of its samples. */
static inline void draw_shade(const struct draw_work *w, size_t i)
{
    const int n = w->splat.samples;
    const int x = (int)(i % w->splat.pitch) * n, y = (int)(i / w->splat.pitch) * n;
    const float count = (float)(n * n);
    float sum[4] = {0, 0, 0, 0};
    for (int j = 0; j < n * n; j++) {
        float color[4];
        draw_sample(w, x + j % n, y + j / n, color);
        for (int k = 0; k < 4; k++)
            sum[k] += color[k];
    }
    const float alpha = w->splat.planes == 4 ? sum[3] : count;
    w->pixel[i] = pixel_make(sum[0], sum[1], sum[2], alpha, 1.0F / count);
}

/* The nearest of the samples of pixel i; of equal ones the first. */
static inline void draw_nearest(const struct draw_work *w, size_t i)
{
    const int n = w->splat.samples;
    const size_t x = i % w->splat.pitch * (size_t)n, y = i / w->splat.pitch * (size_t)n;
    uint64_t best = draw_key(INFINITY, UINT32_MAX);
    for (int j = 0; j < n * n; j++) {
        uint64_t seen = w->seen[(y + (size_t)(j / n)) * (size_t)w->width + x + (size_t)(j % n)];
        best = seen >> 32 < best >> 32 ? seen : best;
    }
    w->nearest[i] = best;
}

#endif
