/* Spheres into tiles of samples: what the cpu renderer's loops read and write.
 *
 * The picture is cut into tiles of at most TILE x TILE samples, which threads draw one at a time. A tile
 * keeps the depth and the number of the nearest sphere at each sample, and shades once when all are
 * known. A ray r = (x, y, 1) from the eye meets the sphere of radius R about c, with o = c_z r - c, where
 *   |o + t r|^2 = R^2: t = -(o.r + sqrt((o.r)^2 - r.r (o.o - R^2)))/r.r, depth c_z + t
 * all differences being taken near the sphere. Of equal depths the first sphere wins, so that no order of
 * drawing matters: the picture has the same bits for any number of threads and any instruction set. */
#ifndef RENDER_SPLAT_H
#define RENDER_SPLAT_H

#include "render/look.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { TILE = 64, CHUNK = 16, BLOCK = 8, BLOCKS = TILE / BLOCK };

/* A sphere in camera axes (z in front of the eye, m) and the samples that it may cover. */
struct ball {
    float x, y, z;
    uint8_t rgb[4];
    uint16_t left, right, top, bottom; /* right and bottom are not in */
};

/* A triangle that is blended over the spheres, in samples. Inside, a + b x + c y of each edge is above 0,
 * or 0 where the edge belongs to it; two triangles that share an edge draw each sample once. */
struct blend {
    double edge[3][3];
    bool owns[3];
    double inverse[3], across[3]; /* 1 / distance (if parallel, distance); samples across the line, or what a
                                     face's cover lacks to 1: a + b x + c y */
    float half_width;             /* of a line; 0: a face */
    float color[4], cover;
    bool parallel;
    bool behind;                  /* where a sphere is in front, not where it is nearer */
    int left, right, top, bottom; /* right and bottom are not in */
};

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

/* What all tiles of a picture share. */
struct splat {
    const struct ball *balls;
    const float *ray_x, *ray_y; /* of each column and row of samples, rows from the top; padded by TILE */
    float lens;                 /* 1: rays start at the eye; 0: they are parallel */
    float radius;
    struct look look;
    int planes;                 /* of colour: 3, or 4 with alpha; then colours are times alpha */
    float back[4], fade[4];     /* background, 0..1, in the upper row of samples; and its change with rows */
    const struct blend *blends; /* in order */
    size_t blend_count;
    int samples;                /* of a pixel, in x and in y */
    uint8_t *rgba;              /* pixels, rows from the top */
    size_t pitch;               /* pixels of a row */
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

#endif
