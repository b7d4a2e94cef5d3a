/* 8-bit RGBA images, and their PNG files. */
#ifndef BASE_IMAGE_H
#define BASE_IMAGE_H

#include "base/error.h"

#include <stdint.h>
#include <stdio.h>

struct _cairo_surface;

struct image {
    int width, height; /* pixels */
    uint8_t *rgba;     /* height rows, top row first, width * 4 bytes each, no padding */
    float *raw;        /* what a pixel shows, in the same order, or NULL: enum raw_plane */
    uint8_t *plain;    /* rgba before anything was written over it, or NULL: base/vectors.h */
    struct _cairo_surface *over; /* what is written over `plain`: a cairo recording, or NULL */
};

/* Of a pixel: distance in front of the camera, m (INFINITY: nothing); the colour's value (NAN: none); the
 * particle's number (-1: none). */
enum raw_plane { RAW_DEPTH, RAW_VALUE, RAW_ID, RAW_PLANES };

/* Allocates a zeroed image; STATUS_RUN when memory is short. */
enum status image_create(struct image *image, int width, int height, struct error *e);
/* Adds room for raw numbers. */
enum status image_create_raw(struct image *image, struct error *e);
void image_free(struct image *image);

/* Reads any PNG as RGBA8; STATUS_USAGE when the file is missing or no PNG. */
enum status image_read_png(struct image *image, const char *path, struct error *e);

/* Writes to PATH.part, then fsync and rename, so that PATH is whole or untouched; STATUS_OUTPUT. */
enum status image_write_png(const struct image *image, const char *path, struct error *e);

/* The same into an open file; `path` is how messages call it. */
enum status image_write_png_to(const struct image *image, FILE *file, const char *path,
                               struct error *e);

#endif
