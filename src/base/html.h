/* Pieces of pages that hold all they show. */
#ifndef BASE_HTML_H
#define BASE_HTML_H

#include "base/image.h"

#include <stddef.h>
#include <stdio.h>

/* The text with &, <, > and " made harmless, inside and outside of tags. */
void html_text(FILE *out, const char *text);

/* RFC 4648. */
void html_base64(FILE *out, const void *bytes, size_t size);

/* <img> with the picture in it, shrunk by a whole factor to `width` pixels or a little more (0: as it
 * is); `path` is how messages call it. STATUS_RUN, STATUS_OUTPUT. */
enum status html_image(FILE *out, const struct image *image, int width, const char *path,
                       struct error *e);

/* <img> with the SVG file in it; STATUS_OUTPUT when it cannot be read. */
enum status html_svg(FILE *out, const char *path, struct error *e);

#endif
