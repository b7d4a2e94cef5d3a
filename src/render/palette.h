/* The colours of a film: a map of the table or of the scene's own file. */
#ifndef RENDER_PALETTE_H
#define RENDER_PALETTE_H

#include "base/error.h"
#include "render/maps.h"
#include "scene/scene.h"

#include <stdbool.h>

/* From the low to the high end, as color.map, color.map_file and color.reverse say; `diverging`: the
 * map of "auto" has a middle. STATUS_USAGE when the file is not a map: "FILE:LINE:COLUMN: why". */
enum status palette_make(const struct scene *scene, bool diverging, uint8_t (*rgb)[3],
                         struct error *e);

/* Reads a file of colours. */
enum status palette_read(const char *path, uint8_t (*rgb)[3], struct error *e);

#endif
