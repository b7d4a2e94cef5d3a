/* What the kernels of the cuda renderer work on. In the common subset of C and CUDA. */
#ifndef RENDER_CUDA_DRAW_WORK_H
#define RENDER_CUDA_DRAW_WORK_H

#include "render/picture.h"
#include "render/place.h"
#include "render/scale.h"

struct draw_work {
    struct splat splat;       /* its arrays are on the device */
    struct viewpoint from;
    const float *position;    /* of each particle, m */
    const uint32_t *word;     /* of each: its colour, red in the lowest byte, or bits of its value (float) */
    bool values;              /* words are values, of this scale, */
    struct color_scale scale;
    const uint32_t *map;      /* and of these colours */
    uint32_t (*packed)[4];    /* bits of x, y, z, and of the place in the map, or the colour */
    struct ball *balls;
    uint64_t *seen;           /* of each sample: bits of the depth of what is nearest, then its number */
    int width, height;        /* samples */
    int tile, columns;        /* samples of a tile's side, tiles side by side */
    size_t words;             /* of a tile's mask */
    uint32_t *mask;           /* triangles that may cover a tile, a bit each */
    uint32_t *pixel;          /* RGBA, red in the lowest byte; splat.pitch of them in a row */
    uint64_t *nearest;        /* as `seen`, of each pixel */
};

enum { DRAW_ACROSS = 8, DRAW_DOWN = 4, DRAW_THREADS = DRAW_ACROSS * DRAW_DOWN }; /* of a sphere */

#endif
