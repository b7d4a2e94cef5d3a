/* Particles of a frame as spheres in camera axes, and which tiles of the picture each may cover. */
#ifndef RENDER_BALLS_H
#define RENDER_BALLS_H

#include "render/occlusion.h"
#include "render/project.h"
#include "render/render.h"

/* Lists of spheres by tile: those of tile i are entry[start[i]] to entry[start[i + 1] - 1]. */
struct bins {
    int columns, rows, tile; /* tiles in the picture; samples of a tile's side */
    struct ball_entry *entry, *sorted;
    size_t *start, *next;    /* next: of each thread and tile, while lists are filled */
    uint64_t inverse;        /* 2^32 / tile, rounded up: (x * inverse) >> 32 is the tile of sample x */
    size_t entries, entry_room, tile_room;
};

struct balls {
    struct ball *ball; /* in order of the frame's particles; without extent where out of sight */
    size_t count, room;
    struct bins bins;
    struct occlusion occlusion; /* where the scene wants it */
};

/* What spheres are seen by. */
struct ball_view {
    struct viewpoint from;
    const struct project_loops *loops;
    const struct render_setup *setup;
    const uint32_t *map;     /* the palette, see project_loops.color */
    int tile, threads;
};

/* STATUS_RUN when memory is short. */
enum status balls_make(struct balls *balls, const struct ball_view *view,
                       const struct render_frame *frame, struct error *e);

/* The colours of at most CHUNK spheres, those of particles from i on. */
void balls_color(const struct ball_view *view, const struct occlusion *occlusion,
                 const struct render_frame *frame, size_t i, size_t count, struct ball *balls);

/* The spheres that may cover a tile. */
struct ball_list balls_of_tile(struct balls *balls, int tile);

void balls_free(struct balls *balls);

#endif
