/* The table of encoders, and what can be said about an output before a run. */
#include "encode/encode.h"

#include "base/output.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

extern const struct encoder_row encoder_mp4, encoder_webm, encoder_mkv, encoder_gif, encoder_apng,
    encoder_y4m, encoder_png, encoder_pdf, encoder_svg, encoder_csv, encoder_hash, encoder_null,
    encoder_reference, encoder_pfm;

static const struct variant *const rows[] = {
    &encoder_mp4.variant,
    &encoder_webm.variant,
    &encoder_mkv.variant,
    &encoder_gif.variant,
    &encoder_apng.variant,
    &encoder_y4m.variant,
    &encoder_png.variant,
    &encoder_pdf.variant,
    &encoder_svg.variant,
    &encoder_pfm.variant,
    &encoder_csv.variant,
    &encoder_hash.variant,
    &encoder_null.variant,
    &encoder_reference.variant,
};

const struct variant_table encode_table = {
    .name = "encoders",
    .doc = "what -o writes, chosen by the extension of the output",
    .rows = rows,
    .count = sizeof rows / sizeof *rows,
};

/* ".mp4" fits any NAME.mp4; "null" fits only itself. */
static bool extension_fits(const char *extension, const char *path)
{
    if (extension[0] != '.')
        return strcmp(path, extension) == 0;
    const char *slash = strrchr(path, '/');
    const char *name = slash ? slash + 1 : path;
    const char *dot = strrchr(name, '.');
    return dot && dot != name && strcasecmp(dot, extension) == 0;
}

static const char *const *known_extension(const struct encoder_row *row, const char *path)
{
    for (const char *const *extension = row->extensions; *extension; extension++)
        if (extension_fits(*extension, path))
            return extension;
    return NULL;
}

bool encode_is_file(const struct encoder_row *row, const char *path)
{
    return **known_extension(row, path) == '.';
}

const struct encoder_row *encode_find(const char *path, struct error *e)
{
    char known[400] = "";
    size_t used = 0;
    for (size_t i = 0; i < encode_table.count; i++) {
        const struct encoder_row *row = (const struct encoder_row *)rows[i];
        if (known_extension(row, path))
            return row;
        for (const char *const *x = row->extensions; *x; x++)
            if (used < sizeof known)
                used += (size_t)snprintf(known + used, sizeof known - used, "%s%s%s",
                                         used ? ", " : "", **x == '.' ? "NAME" : "", *x);
    }
    error_set(e, STATUS_USAGE, "output \"%s\": no encoder writes such a file; known are %s", path,
              known);
    return NULL;
}

bool encode_any(const char *const *outputs, size_t count, bool (*has)(const struct encoder_row *))
{
    struct error ignored;
    for (size_t i = 0; i < count; i++) {
        const struct encoder_row *row = encode_find(outputs[i], &ignored);
        if (row && has(row))
            return true;
    }
    return false;
}

enum status encode_check(const struct encode_target *target, struct error *e)
{
    const struct encoder_row *row = encode_find(target->path, e);
    if (!row)
        return e->status;
    if (row->variant.missing)
        return error_set(e, STATUS_BACKEND, "output \"%s\": encoder %s is not in this build: %s",
                         target->path, row->variant.name, row->variant.missing);
    if (target->width < 1 || target->height < 1)
        return error_set(e, STATUS_USAGE, "output \"%s\": a picture of %d x %d pixels is empty",
                         target->path, target->width, target->height);
    if (!(target->fps > 0) || !isfinite(target->fps))
        return error_set(e, STATUS_USAGE, "output \"%s\": %g frames per second are not positive",
                         target->path, target->fps);
    if (row->check && row->check(target, e))
        return e->status;
    if (encode_is_file(row, target->path))
        return output_check(target->path, e);
    return STATUS_OK;
}
