/* 8-bit RGBA images, and their PNG files through libpng. */
#include "base/image.h"

#include "base/output.h"
#include "base/vectors.h"

#include <errno.h>
#include <png.h>
#include <setjmp.h>
#include <stdlib.h>
#include <string.h>

enum status image_create(struct image *image, int width, int height, struct error *e)
{
    memset(image, 0, sizeof *image);
    if (width < 1 || height < 1)
        return error_set(e, STATUS_RUN, "an image of %d x %d pixels is empty", width, height);
    image->rgba = calloc((size_t)width * 4, (size_t)height);
    if (!image->rgba)
        return error_set(e, STATUS_RUN, "out of memory for an image of %d x %d pixels", width,
                         height);
    image->width = width;
    image->height = height;
    return STATUS_OK;
}

enum status image_create_raw(struct image *image, struct error *e)
{
    image->raw = calloc((size_t)image->width * RAW_PLANES * sizeof *image->raw, (size_t)image->height);
    return image->raw ? STATUS_OK
                      : error_set(e, STATUS_RUN, "out of memory for the raw numbers of %d x %d pixels",
                                  image->width, image->height);
}

void image_free(struct image *image)
{
    free(image->rgba);
    free(image->raw);
    vectors_free(image);
    memset(image, 0, sizeof *image);
}

/* libpng reports by calling back, and wants not to be returned to. */
struct png_trouble {
    jmp_buf jump;
    char text[200];
};

static void on_error(png_structp png, png_const_charp text)
{
    struct png_trouble *trouble = png_get_error_ptr(png);
    snprintf(trouble->text, sizeof trouble->text, "%s", text);
    longjmp(trouble->jump, 1);
}

static void on_warning(png_structp png, png_const_charp text)
{
    (void)png;
    (void)text; /* warnings are about ancillary chunks that we do not use */
}

static void expand_to_rgba8(png_structp png, png_infop info)
{
    png_set_expand(png); /* palette, low bit depths and transparency chunks */
    png_set_scale_16(png);
    png_set_gray_to_rgb(png);
    png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
    (void)png_set_interlace_handling(png);
    png_read_update_info(png, info);
}

/* Everything that can jump out is called from here or below, and nothing in this frame changes
 * between setjmp and longjmp: the caller owns all that must be freed. */
static int png_read_guarded(png_structp png, png_infop info, FILE *file, struct image *image,
                            struct png_trouble *trouble, struct error *e)
{
    if (setjmp(trouble->jump))
        return -1;
    png_init_io(png, file);
    png_read_info(png, info);
    expand_to_rgba8(png, info);
    if (image_create(image, (int)png_get_image_width(png, info),
                     (int)png_get_image_height(png, info), e) != STATUS_OK)
        return 1;
    for (int pass = png_get_interlace_type(png, info) == PNG_INTERLACE_ADAM7 ? 7 : 1; pass; pass--)
        for (int y = 0; y < image->height; y++)
            png_read_row(png, image->rgba + (size_t)y * (size_t)image->width * 4, NULL);
    png_read_end(png, NULL);
    return 0;
}

enum status image_read_png(struct image *image, const char *path, struct error *e)
{
    struct png_trouble trouble = {.text = "out of memory"};
    png_structp png = NULL;
    png_infop info = NULL;
    enum status status = STATUS_USAGE;
    int result = -1;
    FILE *file;
    memset(image, 0, sizeof *image);
    file = fopen(path, "rb");
    if (!file)
        return error_set(e, STATUS_USAGE, "cannot read %s: %s", path, strerror(errno));
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &trouble, on_error, on_warning);
    if (png)
        info = png_create_info_struct(png);
    if (info)
        result = png_read_guarded(png, info, file, image, &trouble, e);
    if (result == 0)
        status = STATUS_OK;
    else if (result < 0)
        error_set(e, status, "cannot read %s as PNG: %s", path, trouble.text);
    else
        status = error_context(e, "%s", path);
    png_destroy_read_struct(&png, &info, NULL);
    fclose(file);
    if (status != STATUS_OK)
        image_free(image);
    return status;
}

static int png_write_guarded(png_structp png, png_infop info, FILE *file,
                             const struct image *image, struct png_trouble *trouble)
{
    if (setjmp(trouble->jump))
        return -1;
    png_init_io(png, file);
    /* Measured on film frames: about five times faster than the defaults for 3 % larger files. */
    png_set_compression_level(png, 1);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    png_set_IHDR(png, info, (png_uint_32)image->width, (png_uint_32)image->height, 8,
                 PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (int y = 0; y < image->height; y++)
        png_write_row(png, image->rgba + (size_t)y * (size_t)image->width * 4);
    png_write_end(png, NULL);
    return 0;
}

enum status image_write_png_to(const struct image *image, FILE *file, const char *path,
                               struct error *e)
{
    struct png_trouble trouble = {.text = "out of memory"};
    png_infop info = NULL;
    int result = -1;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &trouble, on_error,
                                              on_warning);
    if (png)
        info = png_create_info_struct(png);
    errno = 0;
    if (info)
        result = png_write_guarded(png, info, file, image, &trouble);
    if (result != 0)
        error_set(e, STATUS_OUTPUT, "cannot write %s: %s", path,
                  errno ? strerror(errno) : trouble.text);
    png_destroy_write_struct(&png, &info);
    return result == 0 ? STATUS_OK : STATUS_OUTPUT;
}

enum status image_write_png(const struct image *image, const char *path, struct error *e)
{
    struct output_file file;
    struct error ignored;
    if (output_open(&file, path, e))
        return e->status;
    enum status status = image_write_png_to(image, file.stream, file.part, e);
    return status ? (output_close(&file, false, &ignored), status) : output_close(&file, true, e);
}
