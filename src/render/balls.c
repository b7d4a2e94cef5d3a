/* Puts a frame's particles into camera axes and into the tiles that they may cover. */
#include "render/balls.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void balls_color(const struct ball_view *v, const struct occlusion *occlusion, const struct render_frame *frame,
                 size_t i, size_t count, struct ball *balls)
{
    const float strength = (float)v->setup->scene->render.occlusion;
    const struct color_scale *scale = frame->scale ? frame->scale : &v->setup->scale;
    if (!v->setup->solid)
        v->loops->color(scale, v->map, frame->value + i, count, balls);
    for (size_t l = 0; l < count && v->setup->solid; l++)
        memcpy(balls[l].rgb, frame->color + 4 * (i + l), 3);
    for (size_t l = 0; l < count && strength > 0; l++) {
        float shade = occlusion_shade(occlusion, frame->position + 3 * (i + l), strength);
        for (int k = 0; k < 3; k++)
            balls[l].rgb[k] = (uint8_t)((float)balls[l].rgb[k] * shade + 0.5F);
    }
}

/* The tile of a sample, along one axis. */
static inline int tile_at(const struct bins *b, int sample)
{
    return (int)((uint64_t)sample * b->inverse >> 32);
}

/* Calls for each tile that the sphere may cover. */
#define FOR_TILES(ball, bins, index)                                                                   \
    if ((ball)->left < (ball)->right)                                                                  \
        for (int row_ = tile_at(bins, (ball)->top), last_ = tile_at(bins, (ball)->bottom - 1);         \
             row_ <= last_; row_++)                                                                    \
            for (int index = row_ * (bins)->columns + tile_at(bins, (ball)->left),                     \
                     end_ = row_ * (bins)->columns + tile_at(bins, (ball)->right - 1);                 \
                 index <= end_; index++)

static enum status bins_room(struct bins *b, const struct ball_view *v, struct error *e)
{
    b->tile = v->tile;
    b->inverse = (UINT32_MAX + (uint64_t)v->tile) / (uint64_t)v->tile;
    b->columns = (v->from.size[0] + v->tile - 1) / v->tile;
    b->rows = (v->from.size[1] + v->tile - 1) / v->tile;
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

/* Makes the spheres of particles i to end - 1, and counts them in each tile. */
static void balls_make_some(struct balls *s, const struct ball_view *v, const struct render_frame *frame,
                            size_t i, size_t end, size_t *tiles)
{
    for (; i < end; i += CHUNK) {
        struct ball *balls = s->ball + i;
        const size_t count = end - i < CHUNK ? end - i : CHUNK;
        v->loops->place(&v->from, frame->position + 3 * i, count, balls);
        balls_color(v, &s->occlusion, frame, i, count, balls);
        for (size_t l = 0; l < count; l++)
            FOR_TILES(&balls[l], &s->bins, tile)
                tiles[tile]++;
    }
}

static void balls_count(struct balls *s, const struct ball_view *v, const struct render_frame *frame)
{
    struct bins *b = &s->bins;
    size_t tiles = (size_t)b->columns * (size_t)b->rows;
    memset(b->next, 0, tiles * (size_t)v->threads * sizeof *b->next);
#pragma omp parallel for schedule(static, 1) num_threads(v->threads)
    for (int t = 0; t < v->threads; t++)
        balls_make_some(s, v, frame, share(s->count, t, v->threads), share(s->count, t + 1, v->threads),
                        b->next + (size_t)t * tiles);
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
