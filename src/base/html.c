/* Pieces of pages that hold all they show. */
#include "base/html.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

void html_text(FILE *out, const char *text)
{
    for (; *text; text++)
        switch (*text) {
        case '&': fputs("&amp;", out); break;
        case '<': fputs("&lt;", out); break;
        case '>': fputs("&gt;", out); break;
        case '"': fputs("&quot;", out); break;
        default: putc(*text, out);
        }
}

void html_base64(FILE *out, const void *data, size_t size)
{
    static const char letters[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const unsigned char *bytes = data;
    for (size_t i = 0; i < size; i += 3) {
        unsigned left = size - i < 3 ? (unsigned)(size - i) : 3, three = (unsigned)bytes[i] << 16;
        three |= left > 1 ? (unsigned)bytes[i + 1] << 8 : 0;
        three |= left > 2 ? (unsigned)bytes[i + 2] : 0;
        for (unsigned k = 0; k < 4; k++)
            putc(k <= left ? letters[three >> (18 - 6 * k) & 63] : '=', out);
    }
}

static void write_img(FILE *out, const char *kind, const void *bytes, size_t size)
{
    fprintf(out, "<img alt=\"\" src=\"data:image/%s;base64,", kind);
    html_base64(out, bytes, size);
    fputs("\">", out);
}

/* Means of squares of `factor` pixels. */
static enum status shrink(struct image *out, const struct image *in, int factor, struct error *e)
{
    if (image_create(out, in->width / factor, in->height / factor, e))
        return e->status;
    for (int y = 0; y < out->height; y++)
        for (int x = 0; x < out->width; x++)
            for (int k = 0; k < 4; k++) {
                int sum = 0;
                for (int i = 0; i < factor * factor; i++)
                    sum += in->rgba[4 * ((size_t)(y * factor + i / factor) * (size_t)in->width +
                                         (size_t)(x * factor + i % factor)) + (size_t)k];
                out->rgba[4 * ((size_t)y * (size_t)out->width + (size_t)x) + (size_t)k] =
                    (uint8_t)(sum / (factor * factor));
            }
    return STATUS_OK;
}

static enum status write_image(FILE *out, const struct image *image, const char *path,
                               struct error *e)
{
    char *bytes = NULL;
    size_t size = 0;
    FILE *memory = open_memstream(&bytes, &size);
    if (!memory)
        return error_set(e, STATUS_RUN, "memory is short");
    enum status status = image_write_png_to(image, memory, path, e);
    if (fclose(memory) != 0 && !status)
        status = error_set(e, STATUS_RUN, "memory is short");
    if (!status)
        write_img(out, "png", bytes, size);
    free(bytes);
    return status;
}

enum status html_image(FILE *out, const struct image *image, int width, const char *path,
                       struct error *e)
{
    struct image small = {0};
    int side = image->width < image->height ? image->width : image->height;
    int factor = width > 0 ? image->width / width : 1;
    factor = factor > side ? side : factor;
    if (factor <= 1)
        return write_image(out, image, path, e);
    enum status status = shrink(&small, image, factor, e);
    if (!status)
        status = write_image(out, &small, path, e);
    image_free(&small);
    return status;
}

enum status html_svg(FILE *out, const char *path, struct error *e)
{
    char *bytes = NULL, block[1 << 12];
    size_t size = 0, got;
    FILE *in = fopen(path, "rb"), *memory = in ? open_memstream(&bytes, &size) : NULL;
    if (!memory) {
        error_set(e, STATUS_OUTPUT, "%s: %s", path, strerror(errno));
        if (in)
            fclose(in);
        return e->status;
    }
    while ((got = fread(block, 1, sizeof block, in)) > 0)
        fwrite(block, 1, got, memory);
    fclose(in);
    if (fclose(memory) != 0) {
        free(bytes);
        return error_set(e, STATUS_RUN, "memory is short");
    }
    write_img(out, "svg+xml", bytes, size);
    free(bytes);
    return STATUS_OK;
}
