/* 8-bit RGBA images and their PNG files. */
#include "base/image.h"
#include "base/memory.h"

#include <errno.h>
#include <png.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum status image_create(struct image *image, int width, int height, struct error *e)
{
    image->width = width;
    image->height = height;
    image->rgba = memory_create("images", (size_t)width * (size_t)height, 4, e);
    return image->rgba ? STATUS_OK : e->status;
}

void image_free(struct image *image)
{
    memory_free(image->rgba);
    image->rgba = NULL;
}

enum status image_read_png(struct image *image, const char *path, struct error *e)
{
    png_image png = {.version = PNG_IMAGE_VERSION};
    if (!png_image_begin_read_from_file(&png, path))
        return error_set(e, STATUS_USAGE, "%s: %s", path, png.message);
    png.format = PNG_FORMAT_RGBA;
    if (image_create(image, (int)png.width, (int)png.height, e))
        return e->status;
    if (!png_image_finish_read(&png, NULL, image->rgba, 0, NULL))
        return error_set(e, STATUS_USAGE, "%s: %s", path, png.message);
    return STATUS_OK;
}

enum status image_write_png(const struct image *image, const char *path, struct error *e)
{
    png_image png = {.version = PNG_IMAGE_VERSION, .width = (unsigned)image->width,
                     .height = (unsigned)image->height, .format = PNG_FORMAT_RGBA,
                     .flags = PNG_IMAGE_FLAG_FAST};
    char part[4200];
    snprintf(part, sizeof part, "%s.part", path);
    errno = 0;
    if (!png_image_write_to_file(&png, part, 0, image->rgba, 0, NULL) || rename(part, path)) {
        error_set(e, STATUS_OUTPUT, "%s: %s", path, errno ? strerror(errno) : png.message);
        remove(part);
        return STATUS_OUTPUT;
    }
    return STATUS_OK;
}
