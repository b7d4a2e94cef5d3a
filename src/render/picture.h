/* What a picture of spheres is made of: spheres in camera axes, triangles that are blended over them, and
 * what all samples share. In the common subset of C and CUDA. */
#ifndef RENDER_PICTURE_H
#define RENDER_PICTURE_H

#include "render/look.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Most samples of a tile's side: the picture is cut into tiles, and spans of triangles start at their sides. */
enum { TILE = 64 };

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
    bool solid;                   /* hides what comes after it, as a sphere does */
    int left, right, top, bottom; /* right and bottom are not in */
};

/* What all samples of a picture share. */
struct splat {
    const struct ball *balls;
    const float *ray_x, *ray_y; /* of each column and row of samples, rows from the top; padded by TILE */
    float lens;                 /* 1: rays start at the eye; 0: they are parallel */
    float radius;
    struct look look;
    int planes;                 /* of colour: 3, or 4 with alpha; then colours are times alpha */
    float back[4], fade[4];     /* background, 0..1, in the middle of the upper row of samples; and its change
                                 * with rows */
    const struct blend *blends; /* in order */
    size_t blend_count;
    int samples;                /* of a pixel, in x and in y */
    uint8_t *rgba;              /* pixels, rows from the top */
    size_t pitch;               /* pixels of a row */
};

#endif
