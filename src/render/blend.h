/* The domain's floor and edges as the triangles that the cpu renderer blends. */
#ifndef RENDER_BLEND_H
#define RENDER_BLEND_H

#include "render/splat.h"
#include "render/wire.h"

enum { BLENDS_MAX = (FACE_VERTICES + 2 * EDGE_COUNT * LINE_VERTICES) / 3 };

/* Triangles of all layers, in order, for a picture of width x height samples; returns how many. */
size_t blends_make(const struct wire *wire, int width, int height, struct blend blends[BLENDS_MAX]);

#endif
