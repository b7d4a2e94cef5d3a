/* What a film's outputs want of it: pixels, rows, raw numbers, text, hashes. */
#include "encode/encode.h"
#include "run/film.h"

static bool has_pixels(const struct encoder_row *row)
{
    return row->wants_pixels;
}
static bool has_rows(const struct encoder_row *row)
{
    return row->wants_rows;
}
static bool has_raw(const struct encoder_row *row)
{
    return row->wants_raw;
}
static bool has_hashes(const struct encoder_row *row)
{
    return row->wants_hashes;
}
static bool has_vectors(const struct encoder_row *row)
{
    return row->wants_vectors;
}

bool film_wants_pixels(const char *const *outputs, size_t count)
{
    return encode_any(outputs, count, has_pixels);
}
bool film_wants_rows(const char *const *outputs, size_t count)
{
    return encode_any(outputs, count, has_rows);
}
bool film_wants_raw(const char *const *outputs, size_t count)
{
    return encode_any(outputs, count, has_raw);
}
bool film_wants_hashes(const char *const *outputs, size_t count)
{
    return encode_any(outputs, count, has_hashes);
}
bool film_wants_vectors(const char *const *outputs, size_t count)
{
    return encode_any(outputs, count, has_vectors);
}
