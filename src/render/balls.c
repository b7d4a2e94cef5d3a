/* Puts a frame's particles into camera axes and into the tiles that they may cover. */
#include "render/balls.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Between the two nearest colours of the map; the ends of the range are the first and the last. */
static void map_color(const uint8_t map[MAP_SIZE][3], double place, uint8_t rgb[3])
{
    double t = place * (MAP_SIZE - 1);
    int low = t < MAP_SIZE - 2 ? (int)t : MAP_SIZE - 2;
    for (int k = 0; k < 3; k++)
        rgb[k] = (uint8_t)(map[low][k] + (t - low) * (map[low + 1][k] - map[low][k]) + 0.5);
}

/* The samples first..end - 1 whose rays, through their middles, may meet the sphere along one axis: what
 * is within the tangents from the eye, and a little more for rounding; `half` is half the picture's
 * samples per tangent, of either sign. */
static inline void extent(float center, float z, float radius, bool parallel, float half, int count,
                          uint16_t *first, uint16_t *end)
{
    float under = z * z - radius * radius, most = (float)count, a = 0, b = most;
    if (parallel || z > radius * 1.01F) {
        float reach = parallel ? radius : radius * sqrtf(center * center + under);
        float scale = parallel ? half : half / under, middle = parallel ? center : center * z;
        float low = (middle - reach) * scale, high = (middle + reach) * scale;
        float more = 0.55F + 1e-3F * fabsf(high - low);
        a = (low < high ? low : high) + 0.5F * most - more + 1;
        b = (low < high ? high : low) + 0.5F * most + more;
    }
    *first = (uint16_t)(a > 0 ? a < most ? a : most : 0);
    *end = (uint16_t)(b > 0 ? b < most ? b : most : 0);
}

/* A sphere without extent is out of sight: behind the eye, around it, or not a number. */
static void ball_make(const struct ball_view *v, const struct occlusion *occlusion,
                      const struct render_frame *frame, size_t i, struct ball *ball)
{
    const float *p = frame->position + 3 * i;
    const double *m = v->camera->right, *u = v->camera->up, *f = v->camera->forward;
    double x = p[0] - v->camera->eye[0], y = p[1] - v->camera->eye[1], z = p[2] - v->camera->eye[2];
    *ball = (struct ball){(float)(x * m[0] + y * m[1] + z * m[2]), (float)(x * u[0] + y * u[1] + z * u[2]),
                          (float)(x * f[0] + y * f[1] + z * f[2]), {0}, 0, 0, 0, 0};
    float radius = (float)v->radius;
    float distance2 = ball->x * ball->x + ball->y * ball->y + ball->z * ball->z;
    if (!(ball->z > 0 && (distance2 > radius * radius || v->camera->orthographic) && distance2 < 1e30F))
        return;
    const struct color_scale *scale = frame->scale ? frame->scale : &v->setup->scale;
    extent(ball->x, ball->z, radius, v->camera->orthographic, v->half[0], v->width, &ball->left, &ball->right);
    extent(ball->y, ball->z, radius, v->camera->orthographic, v->half[1], v->height, &ball->top, &ball->bottom);
    if (v->setup->solid)
        memcpy(ball->rgb, frame->color + 4 * i, 3);
    else
        map_color(v->setup->palette, scale_place(scale, frame->value[i]), ball->rgb);
    const float strength = (float)v->setup->scene->render.occlusion;
    if (strength > 0) {
        float shade = occlusion_shade(occlusion, p, strength);
        for (int k = 0; k < 3; k++)
            ball->rgb[k] = (uint8_t)((float)ball->rgb[k] * shade + 0.5F);
    }
}

/* Calls for each tile that the sphere may cover. */
#define FOR_TILES(ball, bins, index)                                                               \
    if ((ball)->left < (ball)->right)                                                              \
        for (int row_ = (ball)->top / (bins)->tile; row_ * (bins)->tile < (ball)->bottom; row_++)  \
            for (int column_ = (ball)->left / (bins)->tile, index = row_ * (bins)->columns + column_; \
                 column_ * (bins)->tile < (ball)->right; column_++, index++)

static enum status bins_room(struct bins *b, const struct ball_view *v, struct error *e)
{
    b->tile = v->tile;
    b->columns = (v->width + v->tile - 1) / v->tile;
    b->rows = (v->height + v->tile - 1) / v->tile;
    size_t tiles = (size_t)b->columns * (size_t)b->rows;
    if (tiles > b->tile_room) {
        free(b->start);
        free(b->next);
        b->start = calloc(tiles + 1, sizeof *b->start);
        b->next = calloc(tiles * (size_t)v->threads, sizeof *b->next);
        b->tile_room = b->start && b->next ? tiles : 0;
    }
    return b->tile_room ? STATUS_OK : error_set(e, STATUS_RUN, "out of memory for the picture");
}

/* Particles of thread t of all. */
static size_t share(size_t count, int t, int threads)
{
    return count / (size_t)threads * (size_t)t + (t == threads ? count % (size_t)threads : 0);
}

static void balls_count(struct balls *s, const struct ball_view *v, const struct render_frame *frame)
{
    struct bins *b = &s->bins;
    size_t tiles = (size_t)b->columns * (size_t)b->rows;
    memset(b->next, 0, tiles * (size_t)v->threads * sizeof *b->next);
#pragma omp parallel for schedule(static, 1) num_threads(v->threads)
    for (int t = 0; t < v->threads; t++)
        for (size_t i = share(s->count, t, v->threads); i < share(s->count, t + 1, v->threads); i++) {
            ball_make(v, &s->occlusion, frame, i, &s->ball[i]);
            FOR_TILES(&s->ball[i], b, tile)
                b->next[(size_t)t * tiles + (size_t)tile]++;
        }
}

/* Counts become places: lists one after another, in each those of the first thread first. */
static void bins_place(struct bins *b, int threads)
{
    size_t tiles = (size_t)b->columns * (size_t)b->rows, sum = 0;
    for (size_t tile = 0; tile < tiles; tile++) {
        b->start[tile] = sum;
        for (int t = 0; t < threads; t++) {
            size_t *next = &b->next[(size_t)t * tiles + tile], count = *next;
            *next = sum;
            sum += count;
        }
    }
    b->start[tiles] = b->entries = sum;
}

static enum status entries_room(struct bins *b, struct error *e)
{
    if (b->entries <= b->entry_room)
        return STATUS_OK;
    size_t room = b->entries + b->entries / 4;
    free(b->entry);
    free(b->sorted);
    b->entry = malloc(room * sizeof *b->entry);
    b->sorted = malloc(room * sizeof *b->sorted);
    b->entry_room = b->entry && b->sorted ? room : 0;
    return b->entry_room ? STATUS_OK : error_set(e, STATUS_RUN, "out of memory for the picture");
}

static void bins_fill(struct balls *s, int threads)
{
    struct bins *b = &s->bins;
    size_t tiles = (size_t)b->columns * (size_t)b->rows;
#pragma omp parallel for schedule(static, 1) num_threads(threads)
    for (int t = 0; t < threads; t++)
        for (size_t i = share(s->count, t, threads); i < share(s->count, t + 1, threads); i++)
            FOR_TILES(&s->ball[i], b, tile)
                b->entry[b->next[(size_t)t * tiles + (size_t)tile]++] =
                    (struct ball_entry){(uint32_t)i, s->ball[i].z};
}

enum status balls_make(struct balls *s, const struct ball_view *view, const struct render_frame *frame,
                       struct error *e)
{
    s->count = frame->count;
    if (s->count > s->room) {
        size_t room = s->count + s->count / 4;
        free(s->ball);
        s->ball = s->count < UINT32_MAX ? malloc(room * sizeof *s->ball) : NULL;
        s->room = s->ball ? room : 0;
        if (!s->ball)
            return error_set(e, STATUS_RUN, "out of memory for drawing %zu particles", s->count);
    }
    const struct scene *scene = view->setup->scene;
    if (scene->render.occlusion > 0 && occlusion_make(&s->occlusion, scene, frame, view->threads, e))
        return e->status;
    if (bins_room(&s->bins, view, e))
        return e->status;
    balls_count(s, view, frame);
    bins_place(&s->bins, view->threads);
    if (entries_room(&s->bins, e))
        return e->status;
    bins_fill(s, view->threads);
    return STATUS_OK;
}

enum { SLICES = 64 }; /* of a tile's depth: order within one does not matter much */

struct ball_list balls_of_tile(struct balls *s, int tile)
{
    const struct bins *b = &s->bins;
    const struct ball_entry *entry = b->entry + b->start[tile];
    struct ball_entry *sorted = b->sorted + b->start[tile];
    const size_t count = b->start[tile + 1] - b->start[tile];
    size_t place[SLICES + 1] = {0};
    float near = INFINITY, far = 0;
    for (size_t i = 0; i < count; i++) {
        near = entry[i].z < near ? entry[i].z : near;
        far = entry[i].z > far ? entry[i].z : far;
    }
    float scale = far > near ? (SLICES - 1) / (far - near) : 0;
    for (size_t i = 0; i < count; i++)
        place[(int)((entry[i].z - near) * scale) + 1]++;
    for (int k = 0; k < SLICES; k++)
        place[k + 1] += place[k];
    for (size_t i = 0; i < count; i++)
        sorted[place[(int)((entry[i].z - near) * scale)]++] = entry[i];
    return (struct ball_list){sorted, count, 1.001F * (far - near) / (SLICES - 1)};
}

void balls_free(struct balls *s)
{
    occlusion_free(&s->occlusion);
    free(s->ball);
    free(s->bins.entry);
    free(s->bins.sorted);
    free(s->bins.start);
    free(s->bins.next);
    memset(s, 0, sizeof *s);
}
