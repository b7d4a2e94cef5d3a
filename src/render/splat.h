/* Spheres into tiles of samples: what the cpu renderer's loops read and write.
 *
 * The picture is cut into tiles of at most TILE x TILE samples, which threads draw one at a time. A tile
 * keeps the depth and the number of the nearest sphere at each sample, and shades once when all are
 * known. Of equal depths the first sphere wins, so that no order of drawing matters: the picture has the
 * same bits for any number of threads and any instruction set. */
#ifndef RENDER_SPLAT_H
#define RENDER_SPLAT_H

#include "render/picture.h"

enum { CHUNK = 16, BLOCK = 8, BLOCKS = TILE / BLOCK };

/* Spheres that may cover a tile, about nearest first: each is at most `step` m nearer than those before. */
struct ball_entry {
    uint32_t ball;
    float z;
};
struct ball_list {
    const struct ball_entry *entry;
    size_t count;
    float step;
};

struct tile {
    int left, top, width, height; /* samples */
    bool plain;                   /* nothing but the background is in it, and its colours are not made */
    _Alignas(64) float depth[TILE][TILE]; /* INFINITY: nothing; the struct is a multiple of a cache line */
    uint32_t ball[TILE][TILE];    /* UINT32_MAX: none */
    float far[BLOCKS][BLOCKS];    /* largest depth of a block */
    bool stale[BLOCKS][BLOCKS];   /* that it must be found anew */
    float color[4][TILE][TILE];
};

/* One row for each instruction set: the same loops. */
struct project_loops; /* render/project.h */
struct surface_loops; /* render/surface.h */
struct splat_isa {
    const char *name;
    bool (*supported)(void);
    /* Finds the nearest sphere at each sample of a tile. */
    void (*fill)(const struct splat *splat, struct tile *tile, const struct ball_list *list);
    /* Colours the spheres. */
    void (*shade)(const struct splat *splat, struct tile *tile);
    /* Blends the triangles over them and writes the tile's pixels. */
    void (*finish)(const struct splat *splat, struct tile *tile);
    const struct project_loops *project;
    const struct surface_loops *surface;
};
extern const struct splat_isa splat_scalar, splat_avx2, splat_avx512;

/* The row of that name, or the best that the processor has. */
const struct splat_isa *splat_isa_find(const char *name);

#endif
