/* The loops of the fluid's surface; part of splat_loops.h. */
#include "render/surface.h"

static void surface_keep(struct surface *f, const struct tile *tile)
{
    for (int y = 0; y < tile->height; y++) {
        size_t at = surface_at(f, tile->left, tile->top + y);
        memcpy(f->depth + at, tile->depth[y], (size_t)tile->width * sizeof *f->depth);
        memcpy(f->ball + at, tile->ball[y], (size_t)tile->width * sizeof *f->ball);
    }
}

/* Adds the sphere's chords in CHUNK samples of a row. */
static inline void chunk_thicken(const struct splat *s, const struct ball *ball,
                                 const float *restrict ray_x, float y, float *restrict sum)
{
    const struct meeting meeting = meeting_make(s, ball, y);
#pragma omp simd
    for (int l = 0; l < CHUNK; l++) {
        float along, square, root = meeting_root(&meeting, ray_x[l], &along, &square);
        sum[l] += 2 * sqrtf((root > 0 ? root : 0) / square);
    }
}

static void surface_thicken(const struct splat *s, struct surface *f, struct tile *tile,
                            const struct ball_list *list)
{
    float (*sum)[TILE] = tile->color[0];
    memset(tile->color[0], 0, sizeof tile->color[0]);
    for (size_t i = 0; i < list->count; i++) {
        const struct ball *ball = &s->balls[list->entry[i].ball];
        int left = ball->left > tile->left ? ball->left - tile->left : 0;
        int top = ball->top > tile->top ? ball->top - tile->top : 0;
        int right = ball->right - tile->left, bottom = ball->bottom - tile->top;
        right = right < tile->width ? right : tile->width;
        bottom = bottom < tile->height ? bottom : tile->height;
        for (int y = top; y < bottom; y++)
            for (int x = left & ~(CHUNK - 1); x < right; x += CHUNK)
                chunk_thicken(s, ball, s->ray_x + tile->left + x, s->ray_y[tile->top + y], &sum[y][x]);
    }
    for (int y = 0; y < tile->height; y++)
        for (int x = 0; x < tile->width; x++)
            f->thickness[surface_at(f, tile->left + x, tile->top + y)] = f->volume * sum[y][x];
}

/* The filter's reach at the nearest of CHUNK samples; 0 where there is nothing. */
static inline int chunk_reach(const struct surface *f, const float *depth)
{
    float least = INFINITY;
    for (int l = 0; l < CHUNK; l++)
        least = depth[l] < least ? depth[l] : least;
    float reach = f->parallel ? f->reach : f->reach / least;
    return !(least < INFINITY) ? 0 : reach < 1 ? 1 : reach < SURFACE_PAD ? (int)reach : SURFACE_PAD;
}

/* Every third sample will do: chords have no finer detail that is to stay. */
enum { SOFTEN_STRIDE = 3 };

/* The mean over samples that are no farther than f->far before or behind. */
static void surface_soften(struct surface *f, int y, size_t step)
{
    for (int x = 0; x < f->width; x += CHUNK) {
        const size_t at = surface_at(f, x, y);
        const float *depth = f->depth + at, *in = f->thickness + at, far = f->far;
        float *restrict out = f->other + at, sum[CHUNK], weight[CHUNK];
        const int reach = chunk_reach(f, depth);
        for (int l = 0; l < CHUNK; l++) {
            sum[l] = in[l];
            weight[l] = 1;
        }
        for (int k = SOFTEN_STRIDE; k <= reach; k += SOFTEN_STRIDE) {
            const float *restrict after = in + (size_t)k * step, *restrict z_after = depth + (size_t)k * step;
            const float *restrict before = in - (size_t)k * step, *restrict z_before = depth - (size_t)k * step;
            const float w = f->weight[reach][k];
#pragma omp simd
            for (int l = 0; l < CHUNK; l++) {
                bool a = fabsf(z_after[l] - depth[l]) < far, b = fabsf(z_before[l] - depth[l]) < far;
                sum[l] += (a ? w * after[l] : 0) + (b ? w * before[l] : 0); /* a, b: neither is INFINITY */
                weight[l] += (a ? w : 0) + (b ? w : 0);
            }
        }
        for (int l = 0; l < CHUNK; l++)
            out[l] = sum[l] / weight[l];
    }
}

static void surface_smooth(struct surface *f, int y, size_t step)
{
    for (int x = 0; x < f->width; x += CHUNK) {
        const float *in = f->depth + surface_at(f, x, y), far = f->far, mean = f->step;
        float *restrict out = f->other + surface_at(f, x, y), sum[CHUNK], weight[CHUNK];
        const int reach = chunk_reach(f, in);
        for (int l = 0; l < CHUNK; l++) {
            sum[l] = in[l];
            weight[l] = 1;
        }
        for (int k = 1; k <= reach; k++) {
            const float *restrict after = in + (size_t)k * step, *restrict before = in - (size_t)k * step;
            const float w = f->weight[reach][k];
#pragma omp simd
            for (int l = 0; l < CHUNK; l++) {
                float z = in[l], a = after[l], b = before[l];
                float nearest = a < b ? a : b;
                a = a > z + far ? z + mean : a;
                b = b > z + far ? z + mean : b;
                float own = nearest < z - far ? 0 : w;
                sum[l] += own * (a + b);
                weight[l] += 2 * own;
            }
        }
        for (int l = 0; l < CHUNK; l++)
            out[l] = in[l] < INFINITY ? sum[l] / weight[l] : INFINITY;
    }
}

/* The surface's normal, towards the viewer (camera axes, z towards the viewer), from the less steep of
 * the differences to either side. */
static inline void surface_normal(const struct splat *s, const struct surface *f, int x, int y,
                                  float n[3])
{
    size_t at = surface_at(f, x, y);
    float z = f->depth[at], rx = s->ray_x[x], ry = s->ray_y[y];
    float right = f->depth[at + 1] - z, left = z - f->depth[at - 1];
    float below = f->depth[at + f->pitch] - z, above = z - f->depth[at - f->pitch];
    float dx = fabsf(right) < fabsf(left) ? right : left, dy = fabsf(below) < fabsf(above) ? below : above;
    dx = fabsf(dx) < f->far ? dx : 0;
    dy = fabsf(dy) < f->far ? dy : 0;
    float lens = s->lens, scale = lens * z + (1 - lens), across = s->ray_x[x + 1] - rx;
    float down = s->ray_y[y] - s->ray_y[y > 0 ? y - 1 : 1];
    down = y > 0 ? down : -down;
    float u[3] = {across * scale + lens * rx * dx, lens * ry * dx, dx};
    float v[3] = {lens * rx * dy, down * scale + lens * ry * dy, dy};
    n[0] = u[1] * v[2] - u[2] * v[1];
    n[1] = u[2] * v[0] - u[0] * v[2];
    n[2] = -(u[0] * v[1] - u[1] * v[0]);
    float unit = 1 / sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int k = 0; k < 3; k++)
        n[k] *= unit;
}

/* About exp(-x). */
static inline float surface_decay(float x)
{
    return 1 / (1 + x * (1 + x * (0.5F + x * (1 / 6.0F + x / 24))));
}

/* Light that comes from above in a direction whose upward part is y: ground, horizon, sky. */
static inline float surface_sky(float y, int k)
{
    static const float ground[3] = {0.20F, 0.26F, 0.34F}, sky[3] = {0.86F, 0.94F, 1.0F};
    float t = 0.5F + 0.5F * y;
    t = t * t * (3 - 2 * t);
    return ground[k] + t * (sky[k] - ground[k]);
}

#include "render/surface_refract.h"

static inline void surface_sample(const struct splat *s, const struct surface *f, int x, int y,
                                  const float back[4], float out[4])
{
    const struct look *look = &s->look;
    float n[3], behind[4] = {back[0], back[1], back[2], back[3]}, clear = 0;
    float rx = s->lens * s->ray_x[x], ry = s->lens * s->ray_y[y], length = 1 / sqrtf(rx * rx + ry * ry + 1);
    surface_normal(s, f, x, y, n);
    float facing = (n[2] - n[0] * rx - n[1] * ry) * length;
    facing = facing > 0 ? facing < 1 ? facing : 1 : 0;
    if (f->back_count)
        surface_refract(s, f, x, y, n, facing, behind);
    float key = n[0] * look->key[0] + n[1] * look->key[1] + n[2] * look->key[2];
    float ahead = (rx * look->key[0] + ry * look->key[1] - look->key[2]) * length;
    float glance = ahead + 2 * facing * key, up = ry * length + 2 * facing * n[1], away = 1 - facing;
    float g2 = glance > 0 ? glance * glance : 0, g4 = g2 * g2, g8 = g4 * g4, g32 = g8 * g8 * g8 * g8;
    float schlick = 0.02F + 0.98F * (away * away) * (away * away) * away;
    float mirror = f->opaque ? 0.4F * schlick : schlick;
    float light = f->opaque ? 0.72F + 0.28F * (key > 0 ? key : 0) : 0.20F + 0.80F * (key > 0 ? key : 0);
    const struct ball *ball = &s->balls[f->ball[surface_at(f, x, y)]];
    float thick = f->thickness[surface_at(f, x, y)] / f->clarity;
    for (int k = 0; k < 3; k++) {
        float own = (float)ball->rgb[k] * (1 / 255.0F);
        float through = f->opaque ? 0 : surface_decay(thick * (1.1F - own));
        float body = behind[k] * through + own * light * (1 - through);
        float c = body * (1 - mirror) + surface_sky(up, k) * mirror + 0.6F * g32 * g32;
        out[k] = c < 1 ? c : 1;
        clear += through * (1.0F / 3);
    }
    /* Alpha, where there is; colours are times it. */
    float shine = 0.6F * g32 * g32;
    out[3] = 1 - (1 - behind[3]) * clear * (1 - mirror) * (shine < 1 ? 1 - shine : 0);
    for (int k = 0; k < 3 && s->planes == 4; k++)
        out[k] = out[k] < out[3] ? out[k] : out[3];
}

static void surface_shade(const struct splat *s, const struct surface *f, struct tile *tile)
{
    tile->plain = false;
    for (int y = 0; y < tile->height; y++) {
        float behind[4];
        for (int k = 0; k < 4; k++)
            behind[k] = back_of(s, k, tile->top + y);
        for (int x = 0; x < tile->width; x++) {
            float out[4] = {behind[0], behind[1], behind[2], 0};
            size_t at = surface_at(f, tile->left + x, tile->top + y);
            bool fluid = f->ball[at] != UINT32_MAX;
            tile->depth[y][x] = f->depth[at];
            if (fluid)
                surface_sample(s, f, tile->left + x, tile->top + y, behind, out);
            for (int k = 0; k < 4; k++)
                tile->color[k][y][x] = out[k];
        }
    }
}

static const struct surface_loops surface_loops = {surface_keep, surface_thicken, surface_behind,
                                                   surface_soften, surface_smooth, surface_shade};
