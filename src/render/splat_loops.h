/* The loops of the cpu renderer: plain C that compilers turn into vectors of CHUNK lanes or less. Each
 * sample's arithmetic is the same in all of them. */
#include "render/sample.h"
#include "render/splat.h"

#include <math.h>
#include <string.h>

/* Samples outside the picture have depth 0, which nothing is nearer than. */
static void tile_clear(struct tile *tile)
{
    for (int y = 0; y < TILE; y++)
        for (int x = 0; x < TILE; x++) {
            tile->depth[y][x] = ((x < tile->width) & (y < tile->height)) ? INFINITY : 0;
            tile->ball[y][x] = UINT32_MAX;
        }
    for (int y = 0; y < BLOCKS; y++)
        for (int x = 0; x < BLOCKS; x++) {
            tile->far[y][x] = INFINITY;
            tile->stale[y][x] = false;
        }
}

/* The largest depth of a block. */
static float block_far(struct tile *tile, int column, int row)
{
    float most[BLOCK] = {0}, far = 0;
    if (!tile->stale[row][column])
        return tile->far[row][column];
    for (int y = 0; y < BLOCK; y++) {
        const float *depth = &tile->depth[row * BLOCK + y][column * BLOCK];
        for (int x = 0; x < BLOCK; x++)
            most[x] = depth[x] > most[x] ? depth[x] : most[x];
    }
    for (int x = 0; x < BLOCK; x++)
        far = most[x] > far ? most[x] : far;
    tile->stale[row][column] = false;
    tile->far[row][column] = far;
    return far;
}

/* Whether all samples that the sphere may cover show something nearer; its box is in tile's samples. */
static bool ball_is_hidden(struct tile *tile, const struct ball *ball, float radius,
                           const int box[4])
{
    float front = ball->z - 1.0001F * radius - 1e-6F * ball->z;
    for (int row = box[1] / BLOCK; row * BLOCK < box[3]; row++)
        for (int column = box[0] / BLOCK; column * BLOCK < box[2]; column++)
            if (!(block_far(tile, column, row) < front))
                return false;
    return true;
}

/* `lanes` samples of a row. */
static inline void chunk_splat(const struct splat *s, const struct ball *ball, uint32_t number, int lanes,
                               const float *restrict ray_x, float y, float *restrict depth,
                               uint32_t *restrict nearest)
{
    const struct meeting meeting = meeting_make(s, ball, y);
#pragma omp simd
    for (int l = 0; l < lanes; l++) {
        float root, z = meeting_depth(&meeting, ray_x[l], &root);
        bool first = (z < depth[l]) | ((z == depth[l]) & (number < nearest[l]));
        bool hit = (root >= 0) & (z > 0) & first;
        depth[l] = hit ? z : depth[l];
        nearest[l] = hit ? number : nearest[l];
    }
}

/* The samples of a box, in rows of `lanes` and more; some twice, which changes nothing. */
static inline void box_splat(const struct splat *s, struct tile *tile, const struct ball *ball,
                             uint32_t number, const int box[4], int lanes)
{
    for (int y = box[1]; y < box[3]; y++)
        for (int x = box[0]; x < box[2]; x += lanes) {
            int at = x < TILE - lanes ? x : TILE - lanes;
            chunk_splat(s, ball, number, lanes, s->ray_x + tile->left + at, s->ray_y[tile->top + y],
                        &tile->depth[y][at], &tile->ball[y][at]);
        }
}

static void ball_splat(const struct splat *s, struct tile *tile, uint32_t number)
{
    const struct ball *ball = &s->balls[number];
    int box[4] = {ball->left - tile->left, ball->top - tile->top, ball->right - tile->left,
                  ball->bottom - tile->top};
    box[0] = box[0] > 0 ? box[0] : 0;
    box[1] = box[1] > 0 ? box[1] : 0;
    box[2] = box[2] < tile->width ? box[2] : tile->width;
    box[3] = box[3] < tile->height ? box[3] : tile->height;
    if (ball_is_hidden(tile, ball, s->radius, box))
        return;
    if (box[2] - box[0] <= CHUNK / 2)
        box_splat(s, tile, ball, number, box, CHUNK / 2);
    else
        box_splat(s, tile, ball, number, box, CHUNK);
    for (int row = box[1] / BLOCK; row * BLOCK < box[3]; row++)
        for (int column = box[0] / BLOCK; column * BLOCK < box[2]; column++)
            tile->stale[row][column] = true;
}

/* Spheres that CHUNK samples show. */
struct shown {
    float x[CHUNK], y[CHUNK], z[CHUNK];
    uint32_t rgb[CHUNK];
};

static inline void shown_load(const struct splat *s, const uint32_t *number, struct shown *shown)
{
    static const struct ball none = {.z = 1};
    for (int l = 0; l < CHUNK; l++) {
        const struct ball *ball = number[l] == UINT32_MAX ? &none : &s->balls[number[l]];
        shown->x[l] = ball->x;
        shown->y[l] = ball->y;
        shown->z[l] = ball->z;
        memcpy(&shown->rgb[l], ball->rgb, 4);
    }
}

/* The factor of the colour, and the white that is added, at the points where rays meet spheres: z is
 * their depth. */
static inline void chunk_light(const struct splat *s, const struct shown *restrict shown,
                               const float *restrict ray_x, float y, const float *restrict depth,
                               float *restrict light, float *restrict shine)
{
    const struct look look = s->look;
    const float lens = s->lens, inverse = 1 / s->radius;
#pragma omp simd
    for (int l = 0; l < CHUNK; l++) {
        const struct light own = light_make(&look, lens, inverse, shown->x[l], shown->y[l], shown->z[l], ray_x[l],
                                            y, depth[l]);
        light[l] = own.part;
        shine[l] = own.shine;
    }
}

static inline bool chunk_is_empty(const uint32_t *number)
{
    uint32_t all = UINT32_MAX;
    for (int l = 0; l < CHUNK; l++)
        all &= number[l];
    return all == UINT32_MAX;
}

static inline void chunk_shade(const struct splat *s, struct tile *tile, int x, int y)
{
    struct shown shown;
    float light[CHUNK], shine[CHUNK], depth[CHUNK];
    uint32_t number[CHUNK];
    memcpy(number, &tile->ball[y][x], sizeof number);
#pragma omp simd
    for (int l = 0; l < CHUNK; l++)
        depth[l] = number[l] == UINT32_MAX ? 1 : tile->depth[y][x + l];
    shown_load(s, number, &shown);
    chunk_light(s, &shown, s->ray_x + tile->left + x, s->ray_y[tile->top + y], depth, light, shine);
    for (int k = 0; k < 3; k++) {
        float *restrict color = &tile->color[k][y][x];
        const float back = back_of(s, k, tile->top + y);
        const int shift = 8 * k;
#pragma omp simd
        for (int l = 0; l < CHUNK; l++) {
            float c = light_color(shown.rgb[l], shift, light[l], shine[l]);
            color[l] = number[l] == UINT32_MAX ? back : c;
        }
    }
    if (s->planes == 4)
#pragma omp simd
        for (int l = 0; l < CHUNK; l++)
            tile->color[3][y][x + l] = number[l] == UINT32_MAX ? 0 : 1;
}

static inline void chunk_color(const struct splat *s, struct tile *tile, int x, int y)
{
    if (!chunk_is_empty(&tile->ball[y][x])) {
        chunk_shade(s, tile, x, y);
        return;
    }
    for (int k = 0; k < s->planes; k++) {
        const float back = back_of(s, k, tile->top + y);
#pragma omp simd
        for (int l = 0; l < CHUNK; l++)
            tile->color[k][y][x + l] = back;
    }
}

/* Narrows x..end to where e + d (px + x) may be above 0. */
static inline void span_cut(double e, double d, double px, int *x, int *end)
{
    double zero = -e / d - px;
    if (d > 0 && zero - 1 > *x)
        *x = zero < *end ? (int)(zero - 1) : *end;
    if (d < 0 && zero + 2 < *end)
        *end = zero > -2 ? (int)(zero + 2) : 0;
}

/* Samples x..end of a row, all of them in the triangle. */
static inline void span_blend(const struct blend *b, struct tile *tile, int planes, int y, int x,
                              int end)
{
    const struct span span = span_make(b, tile->left, tile->top + y);
    float *restrict seen = tile->depth[y];
    float part[TILE];
#pragma omp simd
    for (int i = x; i < end; i++)
        part[i] = span_part(&span, i, seen[i]);
    for (int k = 0; k < planes; k++) {
        float *restrict color = tile->color[k][y];
        const float ink = b->color[k];
#pragma omp simd
        for (int i = x; i < end; i++)
            color[i] += part[i] * (ink - color[i]);
    }
    for (int i = x; i < end && b->solid; i++)
        seen[i] = part[i] > 0 ? span_depth(&span, i) : seen[i];
}

/* Samples x..end of row y that are in the triangle. */
static inline void row_blend(const struct blend *b, struct tile *tile, int planes, int y, int x,
                             int end)
{
    const double py = tile->top + y + 0.5, px = tile->left + 0.5;
    for (int k = 0; k < 3; k++)
        span_cut(b->edge[k][0] + b->edge[k][2] * py, b->edge[k][1], px, &x, &end);
    while (x < end && !blend_covers(b, px + x, py))
        x++;
    while (x < end && !blend_covers(b, px + end - 1, py))
        end--;
    span_blend(b, tile, planes, y, x, end);
}

static void tile_blend(const struct blend *b, struct tile *tile, int planes)
{
    int left = b->left > tile->left ? b->left - tile->left : 0;
    int top = b->top > tile->top ? b->top - tile->top : 0;
    int right = b->right - tile->left < tile->width ? b->right - tile->left : tile->width;
    int bottom = b->bottom - tile->top < tile->height ? b->bottom - tile->top : tile->height;
    for (int y = top; y < bottom; y++)
        row_blend(b, tile, planes, y, left, right);
}

/* Adds every n-th of a row's samples. */
static inline void samples_add(const float *restrict color, int n, int count, float *restrict sum)
{
    if (n == 2)
        for (int x = 0; x < TILE / 2; x++)
            sum[x] += color[2 * x];
    else
        for (int x = 0; x < count; x++)
            sum[x] += color[n * x];
}

/* Sums of the samples of a row of pixels. */
static inline void row_sum(const struct tile *tile, int y, int n, int planes, float sum[4][TILE])
{
    for (int k = 0; k < planes; k++)
        for (int j = 0; j < n * n; j++)
            samples_add(&tile->color[k][y * n + j / n][j % n], n, tile->width / n, sum[k]);
}

/* The same where only the background is. */
static inline void row_sum_back(const struct splat *s, const struct tile *tile, int y, float sum[4][TILE])
{
    const int n = s->samples;
    for (int k = 0; k < s->planes; k++) {
        float all = 0;
        for (int j = 0; j < n * n; j++)
            all += back_of(s, k, tile->top + y * n + j / n);
        for (int x = 0; x < TILE; x++)
            sum[k][x] = all;
    }
}

/* One row of pixels: the means of their n x n samples, rounded; colours are divided by alpha. */
static inline void row_write(const struct splat *s, float sum[4][TILE], int width, uint8_t *rgba)
{
    const float count = (float)(s->samples * s->samples), scale = 1.0F / count;
    uint32_t out[TILE];
    for (int x = 0; s->planes == 3 && x < TILE; x++)
        sum[3][x] = count;
    for (int x = 0; x < width; x++)
        out[x] = pixel_make(sum[0][x], sum[1][x], sum[2][x], sum[3][x], scale); /* memory: little endian */
    memcpy(rgba, out, 4 * (size_t)width);
}

static void tile_resolve(const struct splat *s, const struct tile *tile)
{
    const int n = s->samples;
    for (int y = 0; y < tile->height / n; y++) {
        float sum[4][TILE] = {{0}};
        if (tile->plain)
            row_sum_back(s, tile, y, sum);
        else
            row_sum(tile, y, n, s->planes, sum);
        row_write(s, sum, tile->width / n,
                  s->rgba + 4 * ((size_t)(tile->top / n + y) * s->pitch + (size_t)(tile->left / n)));
    }
}

/* Whether all samples of the tile show something nearer than any sphere whose centre is that far. */
static bool tile_is_full(struct tile *tile, float z, float radius)
{
    float front = z - 1.0001F * radius - 1e-6F * z;
    for (int row = 0; row * BLOCK < tile->height; row++)
        for (int column = 0; column * BLOCK < tile->width; column++)
            if (!(block_far(tile, column, row) < front))
                return false;
    return true;
}

/* Spheres after which it is seen whether the rest are hidden; and those that are fetched ahead. */
enum { FULL_EVERY = 32, AHEAD = 12 };

static void tile_fill(const struct splat *s, struct tile *tile, const struct ball_list *list)
{
    tile_clear(tile);
    tile->plain = list->count == 0;
    for (size_t i = 0; i < list->count; i++) {
        if (i % FULL_EVERY == 0 && tile_is_full(tile, list->entry[i].z - list->step, s->radius))
            return;
        if (i + AHEAD < list->count)
            __builtin_prefetch(&s->balls[list->entry[i + AHEAD].ball]);
        ball_splat(s, tile, list->entry[i].ball);
    }
}

static void tile_color(const struct splat *s, struct tile *tile)
{
    for (int y = 0; y < tile->height; y++)
        for (int x = 0; x < tile->width; x += CHUNK)
            chunk_color(s, tile, x, y);
}

static void tile_shade(const struct splat *s, struct tile *tile)
{
    if (!tile->plain)
        tile_color(s, tile);
}

static void tile_finish(const struct splat *s, struct tile *tile)
{
    for (size_t i = 0; i < s->blend_count; i++) {
        if (blend_misses(&s->blends[i], tile->left, tile->top, tile->width, tile->height))
            continue;
        if (tile->plain)
            tile_color(s, tile);
        tile->plain = false;
        tile_blend(&s->blends[i], tile, s->planes);
    }
    tile_resolve(s, tile);
}

#include "render/project_loops.h"
#include "render/surface_loops.h"
