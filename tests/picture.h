/* Test pictures and temporary directories for the tests of encoders and the film pipeline. */
#ifndef TESTS_PICTURE_H
#define TESTS_PICTURE_H

#include "base/image.h"

#include <dirent.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { PATCH_COUNT = 8 };

/* Colours of a film of water: greys, primaries, and colour-map blues and yellows. */
static const uint8_t patch_colors[PATCH_COUNT][3] = {
    {255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 255},
    {0, 0, 0}, {68, 1, 84}, {253, 231, 37}, {128, 128, 128},
};

/* Four by two flat patches; patch k has its middle at (k % 4 + 1/2) / 4 of the width and so on. */
static inline void picture_patches(struct image *image)
{
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++) {
            int patch = x * 4 / image->width + 4 * (y * 2 / image->height);
            uint8_t *p = image->rgba + 4 * ((size_t)y * (size_t)image->width + (size_t)x);
            memcpy(p, patch_colors[patch], 3);
            p[3] = 255;
        }
}

/* Noise that no codec can shrink; equal seeds give equal pictures. */
static inline void picture_noise(struct image *image, uint32_t seed)
{
    uint32_t state = seed * 2654435761u + 1;
    for (size_t i = 0; i < (size_t)image->width * (size_t)image->height * 4; i++) {
        state ^= state << 13, state ^= state >> 17, state ^= state << 5;
        image->rgba[i] = (uint8_t)(state >> 24);
    }
}

/* A dark ground with a bright square that moves with `index`. */
static inline void picture_moving(struct image *image, long index)
{
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++) {
            bool inside = (x + index * 3) % image->width < 24 && y > 20 && y < 44;
            uint8_t *p = image->rgba + 4 * ((size_t)y * (size_t)image->width + (size_t)x);
            p[0] = p[1] = inside ? 240 : 20;
            p[2] = inside ? 90 : (uint8_t)(40 + y);
            p[3] = 255;
        }
}

static char test_directory[64];

static inline int directory_make(void **state)
{
    (void)state;
    strcpy(test_directory, "/tmp/sph-test-XXXXXX");
    return mkdtemp(test_directory) ? 0 : -1;
}

static inline int directory_remove(void **state)
{
    char command[100];
    (void)state;
    snprintf(command, sizeof command, "rm -rf '%s'", test_directory);
    return system(command);
}

/* Name of a file in the test's directory; valid until eight more calls. */
static inline const char *in_directory(const char *name)
{
    static char paths[8][256];
    static int next;
    char *path = paths[next++ % 8];
    snprintf(path, sizeof paths[0], "%s/%s", test_directory, name);
    return path;
}

/* Number of entries in the test's directory. */
static inline int directory_count(void)
{
    int count = 0;
    DIR *directory = opendir(test_directory);
    for (struct dirent *entry; (entry = readdir(directory));)
        count += entry->d_name[0] != '.';
    closedir(directory);
    return count;
}

static inline bool exists(const char *path)
{
    return access(path, F_OK) == 0;
}

static inline void file_write(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    fputs(text, file);
    fclose(file);
}

static inline bool file_is(const char *path, const char *text)
{
    char buffer[200] = "";
    FILE *file = fopen(path, "r");
    if (!file)
        return false;
    size_t size = fread(buffer, 1, sizeof buffer - 1, file);
    fclose(file);
    return size == strlen(text) && memcmp(buffer, text, size) == 0;
}

#endif
